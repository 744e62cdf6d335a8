using System.Runtime.InteropServices;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace Gjk.Demo.Tests.View;

/// <summary>A written page, read as text. It gives the counts on its body and the data for its script.</summary>
public sealed class PageText
{
    public PageText(string file)
    {
        Text = File.ReadAllText(file);
        const string script = "<script type=\"application/json\" id=\"data\">(.*?)</script>";
        Data = JsonDocument.Parse(Regex.Match(Text, script, RegexOptions.Singleline).Groups[1].Value).RootElement;
    }

    public string Text { get; }

    public JsonElement Data { get; }

    /// <summary>A count on the body element.</summary>
    public long Count(string name) =>
        long.Parse(Regex.Match(Text, $"<body[^>]* data-{name}=\"(\\d+)\"").Groups[1].Value);

    /// <summary>A column: base64 of little-endian numbers.</summary>
    public T[] Column<T>(string name)
        where T : unmanaged => MemoryMarshal.Cast<byte, T>(Data.GetProperty(name).GetBytesFromBase64()).ToArray();

    /// <summary>Asserts that the page has nothing that a browser would fetch, and that its content security policy
    /// forbids fetching.</summary>
    public void AssertSelfContained()
    {
        Assert.Contains(
            "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
            + "style-src 'unsafe-inline'; img-src data:\"",
            Text);
        string frame = Regex.Replace(Text, "(?s)(<script>).*?(</script>)", "$1$2");
        Assert.InRange(frame.Length, 1_000, Text.Length - 400_000);
        Assert.DoesNotMatch("(?i)<(script|img|iframe)[^>]*\\ssrc=|<link[^>]*href=\"(?!data:)|@import|url\\(", frame);
        Assert.DoesNotMatch("\\bimport\\(|new WebSocket|XMLHttpRequest\\(", Text);
        Assert.EndsWith("</html>\n", Text);
        Assert.Equal(2, Regex.Count(Text, "</script>"));
        Assert.Contains("three.js authors", Text, StringComparison.OrdinalIgnoreCase);
    }
}
