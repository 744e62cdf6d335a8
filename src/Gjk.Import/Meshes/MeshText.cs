using System;
using System.Collections.Generic;
using System.Globalization;
using System.Numerics;
using System.Text;
using Gjk.Core;

namespace Gjk.Import;

/// <summary>Reads a text file line by line as words, and knows the line for messages.</summary>
internal sealed class MeshText
{
    private readonly string _file;
    private readonly byte[] _bytes;
    private readonly List<string> _words = [];
    private int _next;

    public MeshText(string file, byte[] bytes, int start = 0)
    {
        _file = file;
        _bytes = bytes;
        _next = start;
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
        bool isNumber = float.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out float value);
        if (!isNumber || float.IsNaN(value)) throw Refuse($"\"{Short(word)}\" is not a number");
        return float.IsFinite(value) ? value : throw Refuse($"{Short(word)} is too large for a float");
    }

    public int Whole(string word) =>
        int.TryParse(word, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value)
            ? value
            : throw Refuse($"\"{Short(word)}\" is not a whole number");

    /// <summary>A word of a file that is not text may be very long.</summary>
    public static string Short(string word) => word.Length <= 40 ? word : word[..40] + "...";

    /// <exception cref="ImportException">A coordinate is not finite.</exception>
    public static Vector3 Checked(Vector3 vertex, Func<ImportException> refuse) =>
        ((Double3)vertex).IsFinite ? vertex : throw refuse();

    private string RawLine()
    {
        ReadOnlySpan<byte> rest = _bytes.AsSpan(_next);
        int end = rest.IndexOf((byte)'\n');
        ReadOnlySpan<byte> line = end < 0 ? rest : rest[..end];
        _next += end < 0 ? rest.Length : end + 1;
        LinesRead++;
        if (line.EndsWith("\r"u8)) line = line[..^1];
        return Encoding.UTF8.GetString(line).TrimStart('\uFEFF');
    }
}
