using System.Runtime.InteropServices;
using System.Text.Json;

namespace Gjk.Demo.View;

/// <summary>Writes JSON for a script element. The JSON is compact, and arrays of numbers are base64 of their
/// little-endian bytes.</summary>
internal sealed class PageData : IDisposable
{
    private readonly MemoryStream _bytes = new();

    public PageData() => Json = new Utf8JsonWriter(_bytes);

    /// <summary>The default escaping of this writer writes &lt; as \u003C. So no text can end the script
    /// element.</summary>
    public Utf8JsonWriter Json { get; }

    /// <summary>The whole text. Valid after the last value was written.</summary>
    public ReadOnlySpan<byte> Text
    {
        get
        {
            Json.Flush();
            return _bytes.GetBuffer().AsSpan(0, (int)_bytes.Length);
        }
    }

    public void Array<T>(string name, ReadOnlySpan<T> values)
        where T : unmanaged
    {
        if (!BitConverter.IsLittleEndian)
            throw new PlatformNotSupportedException("The page's numbers are little-endian.");
        Json.WriteBase64String(name, MemoryMarshal.AsBytes(values));
    }

    public void Dispose()
    {
        Json.Dispose();
        _bytes.Dispose();
    }
}
