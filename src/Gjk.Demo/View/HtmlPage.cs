namespace Gjk.Demo.View;

/// <summary>Writes one self-contained file. It puts the page's frame, style and script, which are embedded in the demo,
/// around the data.</summary>
internal static class HtmlPage
{
    /// <summary>Writes the page.</summary>
    /// <param name="stream">Where to write.</param>
    /// <param name="title">Shown as plain text.</param>
    /// <param name="attributes">Counts for the body element, where they can be read without running the script.</param>
    /// <param name="json">The data that the page shows.</param>
    /// <param name="library">Writes the library at the end of the body, which needs WebAssembly; null for none.</param>
    public static void Write(
        Stream stream, string title, ReadOnlySpan<(string Name, long Value)> attributes, ReadOnlySpan<byte> json,
        Action<Stream>? library = null)
    {
        var counts = new StringBuilder();
        foreach ((string attribute, long value) in attributes)
            counts.Append(CultureInfo.InvariantCulture, $" data-{attribute}=\"{value}\"");
        ReadOnlySpan<char> rest = PageText.Asset("page.html");
        while (true)
        {
            int start = rest.IndexOf("{{");
            if (start < 0) break;
            int end = rest.IndexOf("}}");
            PageText.Add(stream, rest[..start]);
            switch (rest[(start + 2)..end])
            {
                case "wasm":
                    if (library is not null) PageText.Add(stream, " 'wasm-unsafe-eval'");
                    break;
                case "title":
                    PageText.Add(stream, PlainText.Markup(title));
                    break;
                case "counts":
                    PageText.Add(stream, counts.ToString());
                    break;
                case "style":
                    PageText.Add(stream, PageText.Asset("page.css"));
                    PageText.Add(stream, PageText.Asset("trace.css"));
                    break;
                case "data":
                    stream.Write(json);
                    break;
                case "script":
                    PageText.Add(stream, PageText.Script("viewer.js"));
                    break;
                case "library":
                    library?.Invoke(stream);
                    break;
            }

            rest = rest[(end + 2)..];
        }

        PageText.Add(stream, rest);
        stream.Flush();
    }
}
