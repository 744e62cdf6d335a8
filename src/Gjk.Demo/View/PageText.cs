using System.Reflection;

namespace Gjk.Demo.View;

/// <summary>The texts that pages are made of: files that are embedded in the demo, and UTF-8.</summary>
internal static class PageText
{
    /// <summary>A file that is embedded in the demo. Its lines end as a browser reads them, whatever the disk
    /// had.</summary>
    public static string Asset(string name)
    {
        using Stream asset = Assembly.GetExecutingAssembly().GetManifestResourceStream(name)
            ?? throw new InvalidOperationException($"The demo was built without {name}.");
        using var reader = new StreamReader(asset, Encoding.UTF8);
        return reader.ReadToEnd().ReplaceLineEndings("\n");
    }

    /// <summary>A page's script, behind the part of three.js that all of them share.</summary>
    public static string Script(string name) => Asset("three.js") + Asset(name);

    public static void Add(Stream stream, ReadOnlySpan<char> text)
    {
        byte[] bytes = new byte[Encoding.UTF8.GetByteCount(text)];
        stream.Write(bytes, 0, Encoding.UTF8.GetBytes(text, bytes));
    }
}
