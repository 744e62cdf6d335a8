using System.Security.Cryptography;
using Gjk.Demo.View;

namespace Gjk.Demo.Play;

/// <summary>Writes one self-contained page that runs the library. Its content security policy allows exactly the
/// scripts and the style that are in it, by their hashes, and WebAssembly. It allows no request at all.</summary>
internal static class ScriptPage
{
    private static readonly string[] Licences = ["three.LICENSE.txt"];

    /// <param name="stream">Where to write.</param>
    /// <param name="title">Shown as plain text.</param>
    /// <param name="json">The data that the page shows.</param>
    /// <param name="name">The name of its style and its script.</param>
    /// <param name="licences">The licences of what is in its script, besides that of three.js.</param>
    public static void Write(
        Stream stream, string title, ReadOnlySpan<byte> json, string name = "play", params string[] licences)
    {
        string style = PageText.Asset($"{name}.css");
        List<string> scripts = [.. BrowserRuntime.Scripts(), PageText.Script($"{name}.js")];
        string notices =
            string.Join("\n", [BrowserRuntime.Notices(), .. Licences.Concat(licences).Select(PageText.Asset)]);
        string policy = $"default-src 'none'; script-src {string.Join(" ", scripts.Select(Hash))} 'wasm-unsafe-eval'; "
            + $"style-src {Hash(style)}; img-src data:";
        PageText.Add(stream, $"""
            <!doctype html>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <meta http-equiv="Content-Security-Policy" content="{policy}">
            <link rel="icon" href="data:,">
            <title>{PlainText.Markup(title)}</title>
            <style>{style}</style>
            </head>
            <body>
            <noscript>This page runs the library in a script, which the browser does not run.</noscript>
            <script type="application/json" id="data">
            """.ReplaceLineEndings("\n"));
        stream.Write(json);
        PageText.Add(stream, "</script>\n");
        BrowserRuntime.Write(stream, notices, scripts);
        PageText.Add(stream, "</body>\n</html>\n");
        stream.Flush();
    }

    private static string Hash(string text) =>
        $"'sha256-{Convert.ToBase64String(SHA256.HashData(Encoding.UTF8.GetBytes(text)))}'";
}
