using System.Text;

namespace Gjk.Import;

/// <summary>Reads a text file line by line as words, and knows the line for messages.</summary>
internal sealed class MeshText
{
    private readonly string _file;
    private readonly byte[] _bytes;
    private readonly List<string> _words = [];

    /// <summary>True if a line feed behind a carriage return is no part of the line's end.</summary>
    private readonly bool _hasBareReturns;
    private int _next;

    /// <exception cref="ImportException">It is not text of bytes.</exception>
    public MeshText(string file, byte[] bytes)
    {
        CheckEncoding(file, bytes);
        _file = file;
        _bytes = bytes;

        // The first line tells how lines end. In a binary PLY with carriage returns alone, the data behind the header
        // may begin with a line feed.
        int first = bytes.AsSpan().IndexOfAny((byte)'\r', (byte)'\n');
        _hasBareReturns = first >= 0 && bytes[first] == '\r' && (first + 1 == bytes.Length || bytes[first + 1] != '\n');
    }

    /// <summary>Counted from 1. Of a line that a backslash continues, the first one.</summary>
    public int Line { get; private set; }

    public IReadOnlyList<string> Words => _words;

    /// <summary>The position behind the line.</summary>
    public int Position => _next;

    private int LinesRead { get; set; }

    /// <summary>The line itself, without the words cut.</summary>
    public string Text { get; private set; } = "";

    public ImportException Refuse(string reason) => new($"{_file}:{Line}: {reason}");

    /// <summary>Moves to the next line that has words. Returns false at the end of the file.</summary>
    /// <param name="comment">What begins a comment, or '\0'.</param>
    /// <param name="continues">What continues a line at its end, or '\0'.</param>
    public bool NextLine(char comment = '\0', char continues = '\0')
    {
        while (_next < _bytes.Length)
        {
            Line = LinesRead + 1;
            Text = RawLine();
            while (continues != '\0' && Text.EndsWith(continues) && _next < _bytes.Length)
                Text = Text[..^1] + " " + RawLine();
            int end = comment == '\0' ? -1 : Text.IndexOf(comment, StringComparison.Ordinal);
            if (end >= 0) Text = Text[..end];
            _words.Clear();
            _words.AddRange(Text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
            if (_words.Count > 0) return true;
        }

        Line = LinesRead;
        _words.Clear();
        return false;
    }

    /// <summary>A coordinate. It is rounded once, from its decimal digits to float.</summary>
    public float Number(string word)
    {
        if (!TryParse(word, out float value) || float.IsNaN(value)) throw NotANumber(word);
        return float.IsFinite(value) ? value : throw Refuse($"{Short(word)} is too large for a float");
    }

    /// <summary>Refuses what is neither a number nor infinite or NaN as C or C# write it.</summary>
    public void CheckNumeric(string word)
    {
        ReadOnlySpan<char> name = word.AsSpan().TrimStart("+-");
        bool isNan = name.StartsWith("nan", StringComparison.OrdinalIgnoreCase)
            && (name.Length == 3 || (name[3] == '(' && name[^1] == ')'));
        if (!isNan && !name.Equals("inf", StringComparison.OrdinalIgnoreCase) && !TryParse(word, out _))
            throw NotANumber(word);
    }

    public int Whole(string word) =>
        int.TryParse(word, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value)
            ? value
            : throw Refuse($"\"{Short(word)}\" is not a whole number");

    /// <summary>Refuses text of 16 bits a character, with or without a mark at its beginning.</summary>
    /// <exception cref="ImportException">It is such text.</exception>
    public static void CheckEncoding(string file, ReadOnlySpan<byte> bytes)
    {
        bool isMarked = bytes.Length >= 2 && (bytes[0], bytes[1]) is (0xFF, 0xFE) or (0xFE, 0xFF);
        bool isWide = bytes.Length >= 4 && (bytes[0] == 0) != (bytes[1] == 0) && (bytes[0] == 0) == (bytes[2] == 0)
            && (bytes[1] == 0) == (bytes[3] == 0);
        if (isMarked || isWide) throw new ImportException($"{file}: it is UTF-16 text; save it as UTF-8");
    }

    /// <summary>A word of a file that is not text may be very long.</summary>
    public static string Short(string word) => word.Length <= 40 ? word : word[..40] + "...";

    /// <exception cref="ImportException">A coordinate is not finite.</exception>
    public static Vector3 Checked(Vector3 vertex, Func<ImportException> refuse) =>
        ((Double3)vertex).IsFinite ? vertex : throw refuse();

    private static bool TryParse(string word, out float value) =>
        float.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out value);

    private ImportException NotANumber(string word) => Refuse($"\"{Short(word)}\" is not a number");

    /// <summary>A line ends with a line feed, a carriage return or both.</summary>
    private string RawLine()
    {
        ReadOnlySpan<byte> rest = _bytes.AsSpan(_next);
        int end = rest.IndexOfAny((byte)'\r', (byte)'\n');
        ReadOnlySpan<byte> line = end < 0 ? rest : rest[..end];
        _next += end < 0 ? rest.Length : end + 1;
        LinesRead++;
        bool isPair = !_hasBareReturns && end >= 0 && rest[end..].StartsWith("\r\n"u8);
        if (isPair) _next++;
        return Encoding.UTF8.GetString(line).TrimStart('\uFEFF');
    }
}
