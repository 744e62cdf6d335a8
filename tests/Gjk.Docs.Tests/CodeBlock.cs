namespace Gjk.Docs.Tests;

/// <summary>A fenced block of a Markdown page.</summary>
/// <param name="Words">What stands behind the fence: the language, and words that say how it is tested.</param>
/// <param name="Text">The lines between the fences.</param>
/// <param name="Line">The line of the opening fence, from 1.</param>
public sealed record CodeBlock(IReadOnlyList<string> Words, string Text, int Line)
{
    private const string Fence = "```";

    public string Language => Words[0];

    public bool Has(string word) => Words.Skip(1).Contains(word);

    /// <summary>The blocks of a page in the order in which they are printed.</summary>
    /// <exception cref="FormatException">A fence has no language, or is not closed.</exception>
    public static IReadOnlyList<CodeBlock> Of(string markdown)
    {
        var blocks = new List<CodeBlock>();
        string[] lines = markdown.Split('\n');
        for (int i = 0; i < lines.Length; i++)
        {
            if (!lines[i].StartsWith(Fence, StringComparison.Ordinal)) continue;
            string[] words = lines[i][Fence.Length..].Split(' ', StringSplitOptions.RemoveEmptyEntries);
            if (words.Length == 0) throw new FormatException($"the code block in line {i + 1} names no language");
            int end = Array.FindIndex(lines, i + 1, l => l.StartsWith(Fence, StringComparison.Ordinal));
            if (end < 0) throw new FormatException($"the code block in line {i + 1} does not end");
            blocks.Add(new CodeBlock(words, string.Concat(lines[(i + 1)..end].Select(l => l + "\n")), i + 1));
            i = end;
        }

        return blocks;
    }
}
