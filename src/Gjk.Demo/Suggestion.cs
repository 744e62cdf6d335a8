namespace Gjk.Demo;

/// <summary>Finds the word that was meant.</summary>
internal static class Suggestion
{
    /// <summary>Letters that may be wrong, missing, too many or swapped.</summary>
    private const int MostSlips = 2;

    /// <summary>": did you mean query?", or nothing where no word is near.</summary>
    public static string For(string word, IEnumerable<string> words)
    {
        string? nearest = words.MinBy(w => Slips(word, w));
        bool isNear = nearest is not null
            && Slips(word, nearest) <= Math.Min(MostSlips, nearest.TrimStart('-').Length / 2);
        return isNear ? $": did you mean {nearest}?" : "";
    }

    /// <summary>The distance of Damerau and Levenshtein, in which a swapped pair of letters is one slip.</summary>
    private static int Slips(string a, string b)
    {
        var slips = new int[a.Length + 1, b.Length + 1];
        for (int i = 0; i <= a.Length; i++) slips[i, 0] = i;
        for (int j = 0; j <= b.Length; j++) slips[0, j] = j;
        for (int i = 1; i <= a.Length; i++)
        {
            for (int j = 1; j <= b.Length; j++)
            {
                int same = slips[i - 1, j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
                slips[i, j] = Math.Min(same, 1 + Math.Min(slips[i - 1, j], slips[i, j - 1]));
                bool isSwapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
                if (isSwapped) slips[i, j] = Math.Min(slips[i, j], slips[i - 2, j - 2] + 1);
            }
        }

        return slips[a.Length, b.Length];
    }
}
