using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Text.Json;

namespace Gjk.Import;

/// <summary>
/// A GLB file cut into its JSON and its bytes (Khronos Group, "glTF 2.0 Specification", 2021, section 4.4). Numbers and
/// indices are read with checks, since nothing in a file can be trusted.
/// </summary>
internal sealed class GlbFile : IDisposable
{
    /// <summary>"glTF", "JSON" and "BIN" with a zero, as little-endian numbers.</summary>
    private const uint Magic = 0x46546C67, JsonChunk = 0x4E4F534A, BinaryChunk = 0x004E4942;

    private const int HeaderBytes = 12, ChunkHeaderBytes = 8, Version = 2;

    private readonly string _file;
    private readonly JsonDocument _json;
    private readonly Dictionary<string, List<JsonElement>> _lists = new(StringComparer.Ordinal);

    private GlbFile(string file, JsonDocument json, ReadOnlyMemory<byte> binary)
    {
        _file = file;
        _json = json;
        Binary = binary;
    }

    public JsonElement Root => _json.RootElement;

    /// <summary>The file's own buffer. Empty if it has none.</summary>
    public ReadOnlyMemory<byte> Binary { get; }

    public static GlbFile Open(string file, byte[] bytes)
    {
        ImportException Refuse(string reason) => new($"{file}: {reason}");
        if (bytes.Length < HeaderBytes || Number(bytes, 0) != Magic)
            throw Refuse("not a GLB file: it must begin with \"glTF\"");
        if (Number(bytes, 4) != Version)
            throw Refuse($"glTF version {Number(bytes, 4)} is not known; must be {Version}");
        if (Number(bytes, 8) != bytes.Length)
            throw Refuse($"its header says {Number(bytes, 8)} bytes, but it has {bytes.Length}");
        ReadOnlyMemory<byte> json = default, binary = default;
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

        try
        {
            return new GlbFile(file, JsonDocument.Parse(json), binary);
        }
        catch (JsonException e)
        {
            throw Refuse($"its JSON is not valid at line {e.LineNumber + 1}, byte {e.BytePositionInLine + 1}");
        }
    }

    public void Dispose() => _json.Dispose();

    public ImportException Refuse(string where, string reason) => new($"{_file}: {where}: {reason}");

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

    private static uint Number(byte[] bytes, int at) => BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(at));
}
