using System;
using System.Globalization;
using System.IO;
using System.Reflection;
using System.Text;
using Gjk.Demo.Output;

namespace Gjk.Demo.View;

/// <summary>
/// Writes one self-contained file. It puts the page's frame, style and script, which are embedded in the demo, around
/// the data.
/// </summary>
internal static class HtmlPage
{
    /// <summary>Writes the page.</summary>
    /// <param name="stream">Where to write.</param>
    /// <param name="title">Shown as plain text.</param>
    /// <param name="attributes">Counts for the body element, where they can be read without running the script.</param>
    /// <param name="json">The data that the page shows.</param>
    public static void Write(
        Stream stream, string title, ReadOnlySpan<(string Name, long Value)> attributes, ReadOnlySpan<byte> json)
    {
        var counts = new StringBuilder();
        foreach ((string attribute, long value) in attributes)
            counts.Append(CultureInfo.InvariantCulture, $" data-{attribute}=\"{value}\"");
        ReadOnlySpan<char> rest = Asset("page.html");
        while (true)
        {
            int start = rest.IndexOf("{{");
            if (start < 0) break;
            int end = rest.IndexOf("}}");
            Add(stream, rest[..start]);
            switch (rest[(start + 2)..end])
            {
                case "title":
                    Add(stream, PlainText.Markup(title));
                    break;
                case "counts":
                    Add(stream, counts.ToString());
                    break;
                case "style":
                    Add(stream, Asset("page.css"));
                    Add(stream, Asset("trace.css"));
                    break;
                case "data":
                    stream.Write(json);
                    break;
                case "script":
                    Add(stream, Asset("viewer.js"));
                    break;
            }

            rest = rest[(end + 2)..];
        }

        Add(stream, rest);
        stream.Flush();
    }

    private static string Asset(string name)
    {
        using Stream asset = Assembly.GetExecutingAssembly().GetManifestResourceStream(name)
            ?? throw new InvalidOperationException($"The demo was built without {name}.");
        using var reader = new StreamReader(asset, Encoding.UTF8);
        return reader.ReadToEnd();
    }

    private static void Add(Stream stream, ReadOnlySpan<char> text)
    {
        byte[] bytes = new byte[Encoding.UTF8.GetByteCount(text)];
        stream.Write(bytes, 0, Encoding.UTF8.GetBytes(text, bytes));
    }
}
