using System.Net;

namespace Gjk.Demo.Output;

/// <summary>Text from the user's files, in a form that is safe in a terminal, in CSV and in XML.</summary>
internal static class PlainText
{
    /// <summary>Writes control characters as \u001b and the like. They could change the terminal's colours or title,
    /// and XML cannot contain them. Characters that turn the direction of the text could make it look like another
    /// text.</summary>
    public static string Of(string text)
    {
        int first = 0;
        while (first < text.Length && !IsSpecial(text[first])) first++;
        if (first == text.Length) return text;
        var plain = new StringBuilder(text, 0, first, text.Length + 16);
        foreach (char c in text.AsSpan(first))
        {
            if (IsSpecial(c)) plain.Append(CultureInfo.InvariantCulture, $"\\u{(int)c:x4}");
            else plain.Append(c);
        }

        return plain.ToString();
    }

    /// <summary>The text for the content of an element of XML or HTML.</summary>
    public static string Markup(string text) => WebUtility.HtmlEncode(Of(text));

    /// <summary>The text as one field of CSV. It is quoted where that is needed (RFC 4180).</summary>
    public static string CsvField(string text)
    {
        string plain = Of(text);
        return plain.AsSpan().ContainsAny(',', '"') ? $"\"{plain.Replace("\"", "\"\"")}\"" : plain;
    }

    private static bool IsSpecial(char c) =>
        char.IsControl(c) || c is '\u2028' or '\u2029' or '\uFFFE' or '\uFFFF'
        || c is (>= '\u202A' and <= '\u202E') or (>= '\u2066' and <= '\u2069');
}
