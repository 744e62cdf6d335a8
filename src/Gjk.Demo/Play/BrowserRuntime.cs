using System.IO.Compression;
using System.Net;
using System.Text.Json;
using System.Text.RegularExpressions;
using Gjk.Demo.View;

namespace Gjk.Demo.Play;

/// <summary>The library for a page: the runtime's scripts, which a page must hold in line, and its DLLs and WebAssembly
/// as compressed text. The project Gjk.Web puts all of them into a folder beside the demo when it is built.</summary>
internal static partial class BrowserRuntime
{
    private static readonly string Folder = Path.Combine(AppContext.BaseDirectory, "browser");

    private static readonly (string Name, string File)[] Modules =
    [
        ("loader", "dotnet.js"), ("native", "dotnet.native.js"), ("runtime", "dotnet.runtime.js"),
    ];

    private static readonly string[] NoticeFiles =
        ["LICENSE.TXT", "EMSCRIPTEN-LICENSE.TXT", "THIRD-PARTY-NOTICES.TXT"];

    /// <summary>The runtime's modules as scripts. A page from a disk can import nothing, so each one puts what it
    /// exports into the global object gjkRuntime instead.</summary>
    public static IEnumerable<string> Scripts() => Modules.Select(m => Script(m.Name, Text(m.File)));

    /// <summary>The other files as JSON: names with base64 of their gzipped bytes.</summary>
    public static byte[] Files()
    {
        using var json = new MemoryStream();
        using (var writer = new Utf8JsonWriter(json))
        {
            writer.WriteStartObject();
            foreach (string name in Names().Where(n => n.EndsWith(".dll") || n.EndsWith(".wasm")))
                writer.WriteBase64String(name, Zipped(name));
            writer.WriteEndObject();
        }

        return json.ToArray();
    }

    /// <summary>The licences of what is in the page, which must travel with it.</summary>
    public static string Notices() => string.Join("\n", NoticeFiles.Select(Text));

    /// <summary>Writes the library into the body of a page, with its licences, and the modules that run it.</summary>
    public static void Write(Stream stream, string notices, IEnumerable<string> scripts)
    {
        PageText.Add(stream, "<script type=\"application/json\" id=\"runtime\">");
        stream.Write(Files());
        PageText.Add(stream, $"</script>\n<template id=\"notices\">{WebUtility.HtmlEncode(notices)}</template>\n");
        foreach (string script in scripts) PageText.Add(stream, $"<script type=\"module\">{script}</script>\n");
    }

    private static string Script(string name, string text)
    {
        text = SourceMap().Replace(text, "");
        MatchCollection found = Exports().Matches(text);
        if (found.Count != 1) throw new InvalidOperationException($"The runtime's module {name} has a new form.");
        Match export = found[0];
        IEnumerable<string> entries = export.Groups["all"].Success
            ? export.Groups["all"].Value.Split(',').Select(Entry)
            : [$"default:{export.Groups["one"].Value}"];
        return $"{text[..export.Index]}(globalThis.gjkRuntime??={{}}).{name}={{{string.Join(",", entries)}}};"
            + text[(export.Index + export.Length)..];
    }

    /// <summary>"a as b" as "b:a".</summary>
    private static string Entry(string exported)
    {
        string[] words = exported.Split(" as ", StringSplitOptions.TrimEntries);
        return $"{words[^1]}:{words[0]}";
    }

    private static IEnumerable<string> Names() =>
        Directory.EnumerateFiles(Folder).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal);

    private static byte[] Zipped(string name)
    {
        using var bytes = new MemoryStream();
        using (var zip = new GZipStream(bytes, CompressionLevel.SmallestSize))
        using (Stream file = Open(name))
        {
            file.CopyTo(zip);
        }

        return bytes.ToArray();
    }

    private static string Text(string name)
    {
        using var reader = new StreamReader(Open(name));
        return reader.ReadToEnd();
    }

    private static FileStream Open(string name)
    {
        string file = Path.Combine(Folder, name);
        return File.Exists(file)
            ? File.OpenRead(file)
            : throw new RefusedException(
                "this page runs the library, which was not built for browsers: "
                + "dotnet build -c Release src/Gjk.Web builds it, and the whole solution does");
    }

    [GeneratedRegex(@"^//# sourceMappingURL=.*$", RegexOptions.Multiline)]
    private static partial Regex SourceMap();

    [GeneratedRegex(@"\bexport\s*(?:\{(?<all>[^}]*)\}|default\s+(?<one>\w+))\s*;")]
    private static partial Regex Exports();
}
