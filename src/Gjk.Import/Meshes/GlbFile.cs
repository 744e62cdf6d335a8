using System.Buffers.Binary;
using System.Text.Json;

namespace Gjk.Import;

/// <summary>A GLB file cut into its JSON and its bytes, or a .gltf file with the files beside it (Khronos Group, "glTF
/// 2.0 Specification", 2021, section 4.4). Numbers and indices are checked, since nothing in a file can be
/// trusted.</summary>
internal sealed class GlbFile : IDisposable
{
    /// <summary>"glTF", "JSON" and "BIN" with a zero, as little-endian numbers.</summary>
    private const uint Magic = 0x46546C67, JsonChunk = 0x4E4F534A, BinaryChunk = 0x004E4942;

    private const int HeaderBytes = 12, ChunkHeaderBytes = 8, Version = 2;

    private readonly string _file;
    private readonly JsonDocument _json;
    private readonly ReadOnlyMemory<byte> _binary;
    private readonly Dictionary<string, List<JsonElement>> _lists = new(StringComparer.Ordinal);

    private readonly string? _folder;
    private readonly CancellationToken _cancel;
    private readonly Dictionary<int, byte[]> _buffers = [];

    private GlbFile(
        string file, JsonDocument json, ReadOnlyMemory<byte> binary, string? folder, CancellationToken cancel)
    {
        _file = file;
        _json = json;
        _binary = binary;
        _folder = folder;
        _cancel = cancel;
    }

    public JsonElement Root => _json.RootElement;

    /// <param name="file">For messages.</param>
    /// <param name="bytes">Its content: JSON in the frame of a GLB file, or on its own.</param>
    /// <param name="isFramed">True for a GLB file.</param>
    /// <param name="folder">Where the files lie that it names; null if none may be opened.</param>
    /// <param name="cancel">Ends the reading of such a file.</param>
    public static GlbFile Open(string file, byte[] bytes, bool isFramed, string? folder, CancellationToken cancel)
    {
        ReadOnlyMemory<byte> json = bytes, binary = default;
        if (isFramed) Cut(file, bytes, out json, out binary);
        else MeshText.CheckEncoding(file, bytes);
        if (json.Span.StartsWith("\uFEFF"u8)) json = json["\uFEFF"u8.Length..];
        try
        {
            return new GlbFile(file, JsonDocument.Parse(json), binary, folder, cancel);
        }
        catch (JsonException e)
        {
            throw new ImportException(
                $"{file}: its JSON is not valid at line {e.LineNumber + 1}, byte {e.BytePositionInLine + 1}");
        }
    }

    private static void Cut(string file, byte[] bytes, out ReadOnlyMemory<byte> json, out ReadOnlyMemory<byte> binary)
    {
        ImportException Refuse(string reason) => new($"{file}: {reason}");
        if (bytes.Length < HeaderBytes || Number(bytes, 0) != Magic)
            throw Refuse("not a GLB file: it must begin with \"glTF\"");
        if (Number(bytes, 4) != Version)
            throw Refuse($"glTF version {Number(bytes, 4)} is not known; must be {Version}");
        if (Number(bytes, 8) != bytes.Length)
            throw Refuse($"its header says {Number(bytes, 8)} bytes, but it has {bytes.Length}");
        json = binary = default;
        int next = HeaderBytes;
        for (int i = 0; next < bytes.Length; i++)
        {
            if (bytes.Length - next < ChunkHeaderBytes) throw Refuse($"chunk {i} is cut off");
            uint length = Number(bytes, next), type = Number(bytes, next + 4);
            next += ChunkHeaderBytes;
            if (length > bytes.Length - next) throw Refuse($"chunk {i} is cut off");
            if (i == 0 && type != JsonChunk) throw Refuse("the first chunk is not JSON");
            if (i == 0) json = bytes.AsMemory(next, (int)length);
            if (i == 1 && type == BinaryChunk) binary = bytes.AsMemory(next, (int)length);
            next += (int)length;
        }
    }

    public void Dispose() => _json.Dispose();

    public ImportException Refuse(string where, string reason) => new($"{_file}: {where}: {reason}");

    /// <summary>The bytes of a buffer: those of the file itself, text within it, or a file beside it.</summary>
    public ReadOnlyMemory<byte> Buffer(int index, string where)
    {
        List<JsonElement> buffers = List("buffers");
        JsonElement buffer = buffers[Checked(index, buffers.Count, "buffer", where)];
        where = $"buffers[{index}]";
        string uri = Text(buffer, "uri");
        if (index == 0 && uri.Length == 0) return _binary;
        if (_buffers.TryGetValue(index, out byte[]? known)) return known;
        byte[] bytes = uri.StartsWith("data:", StringComparison.Ordinal) ? OfText(uri, where) : Beside(uri, where);
        if (Index(buffer, "byteLength", where) is { } length && length > bytes.Length)
            throw Refuse(where, $"must have {length} bytes, but has {bytes.Length}");
        _buffers.Add(index, bytes);
        return bytes;
    }

    /// <summary>The elements of an array of the root. Empty if it is missing.</summary>
    public List<JsonElement> List(string name)
    {
        if (!_lists.TryGetValue(name, out List<JsonElement>? list)) _lists[name] = list = List(Root, name, name);
        return list;
    }

    public List<JsonElement> List(JsonElement parent, string name, string where)
    {
        if (parent.ValueKind != JsonValueKind.Object) throw Refuse(where, "must be an object");
        if (!parent.TryGetProperty(name, out JsonElement array)) return [];
        if (array.ValueKind != JsonValueKind.Array) throw Refuse(where, "must be an array");
        return [.. array.EnumerateArray()];
    }

    public bool TryObject(JsonElement parent, string name, string where, out JsonElement value)
    {
        if (parent.ValueKind != JsonValueKind.Object) throw Refuse(where, "must be an object");
        if (!parent.TryGetProperty(name, out value)) return false;
        if (value.ValueKind != JsonValueKind.Object) throw Refuse($"{where}.{name}", "must be an object");
        return true;
    }

    /// <summary>A whole number that is not negative, or null if it is missing.</summary>
    public int? Index(JsonElement parent, string name, string where)
    {
        if (parent.ValueKind != JsonValueKind.Object) throw Refuse(where, "must be an object");
        if (!parent.TryGetProperty(name, out JsonElement value)) return null;
        if (value.ValueKind == JsonValueKind.Number && value.TryGetInt32(out int index) && index >= 0) return index;
        throw Refuse($"{where}.{name}", "must be a whole number, at least 0");
    }

    /// <summary>An index of a list.</summary>
    public int Checked(int index, int count, string what, string where) =>
        index < count ? index : throw Refuse(where, $"there is no {what} {index}: the file has {count}");

    /// <summary>A text, or nothing if it is missing.</summary>
    public string Text(JsonElement parent, string name) =>
        parent.ValueKind == JsonValueKind.Object && parent.TryGetProperty(name, out JsonElement value)
            ? TextOf(value, name)
            : "";

    public string TextOf(JsonElement value, string where)
    {
        try
        {
            return value.ValueKind == JsonValueKind.String
                ? value.GetString()!
                : throw Refuse(where, "must be a string");
        }
        catch (InvalidOperationException)
        {
            throw Refuse(where, "the text is not valid Unicode");
        }
    }

    /// <summary>Numbers of a fixed count, or null if they are missing.</summary>
    public double[]? Numbers(JsonElement parent, string name, int count, string where)
    {
        if (!parent.TryGetProperty(name, out JsonElement array)) return null;
        var numbers = new double[count];
        bool isGood = array.ValueKind == JsonValueKind.Array && array.GetArrayLength() == count;
        for (int i = 0; i < count && isGood; i++)
        {
            isGood = array[i].ValueKind == JsonValueKind.Number && array[i].TryGetDouble(out numbers[i])
                && double.IsFinite(numbers[i]);
        }

        return isGood ? numbers : throw Refuse($"{where}.{name}", $"must be {count} finite numbers");
    }

    private byte[] OfText(string uri, string where)
    {
        const string encoding = ";base64,";
        int comma = uri.IndexOf(encoding, StringComparison.Ordinal);
        try
        {
            if (comma >= 0) return Convert.FromBase64String(uri[(comma + encoding.Length)..]);
        }
        catch (FormatException)
        {
            // As without the encoding.
        }

        throw Refuse(where, "its data is not valid base64");
    }

    /// <summary>A file in the folder or below it; no name leads anywhere else.</summary>
    private byte[] Beside(string uri, string where)
    {
        if (uri.Length == 0) throw Refuse(where, "has no data");
        if (_folder is null) throw Refuse(where, "lies in another file; export with all data in the .glb");
        string name = Uri.UnescapeDataString(uri);
        bool isBelow = !Path.IsPathRooted(name) && name.IndexOfAny([':', '\\', '\0']) < 0
            && !Array.Exists(name.Split('/'), step => step == "..");
        if (!isBelow) throw Refuse(where, $"\"{MeshText.Short(name)}\" is not the name of a file beside it");
        try
        {
            return WholeFile.Read(Path.Combine(_folder, name), ImportLimits.FileBytes, _cancel);
        }
        catch (ImportException e)
        {
            throw Refuse(where, e.Message);
        }
    }

    private static uint Number(byte[] bytes, int at) => BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(at));
}
