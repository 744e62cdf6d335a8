using System.Buffers.Binary;
using System.Text.Json;

namespace Gjk.Import;

/// <summary>Reads the numbers of an accessor: plain, interleaved, sparse or made of integers (glTF 2.0, sections 3.6.2
/// and 3.11).</summary>
internal sealed class GlbAccessor
{
    /// <summary>The component types of glTF, which took them from OpenGL.</summary>
    private const int Int8 = 5120, UInt8 = 5121, Int16 = 5122, UInt16 = 5123, UInt32 = 5125, Float = 5126;

    private readonly GlbFile _file;
    private readonly string _where;
    private readonly int _width;
    private readonly int _type;
    private readonly bool _isNormalized;

    private GlbAccessor(GlbFile file, JsonElement accessor, string where, string kind)
    {
        _file = file;
        _where = where;
        _width = kind == "VEC3" ? 3 : 1;
        _type = file.Index(accessor, "componentType", where) ?? throw file.Refuse(where, "componentType is missing");
        _isNormalized = accessor.TryGetProperty("normalized", out JsonElement flag)
            && flag.ValueKind == JsonValueKind.True;
        if (file.Text(accessor, "type") != kind) throw file.Refuse(where, $"must be of type {kind}");
        if (SizeOf(_type) == 0) throw file.Refuse(where, $"unknown component type {_type}");
    }

    /// <summary>The numbers of all elements, one after the other.</summary>
    /// <param name="file">The file.</param>
    /// <param name="index">The accessor.</param>
    /// <param name="kind">VEC3 or SCALAR.</param>
    public static double[] Read(GlbFile file, int index, string kind)
    {
        string where = $"accessors[{index}]";
        var accessors = file.List("accessors");
        JsonElement accessor = accessors[file.Checked(index, accessors.Count, "accessor", where)];
        var reader = new GlbAccessor(file, accessor, where, kind);
        int count = file.Index(accessor, "count", where) ?? throw file.Refuse(where, "count is missing");
        if (count > SceneBuilder.MostVertices)
            throw file.Refuse(where, $"{count} elements, but at most {SceneBuilder.MostVertices} can be read");
        double[] numbers = file.Index(accessor, "bufferView", where) is { } view
            ? reader.Elements(view, Offset(file, accessor, where), count, reader._type, reader._width)
            : new double[count * reader._width];
        if (file.TryObject(accessor, "sparse", where, out JsonElement sparse)) reader.Overwrite(sparse, numbers);
        return reader._isNormalized && reader._type != Float ? reader.Normalized(numbers) : numbers;
    }

    /// <summary>False if the numbers are those of a compressed primitive, which the accessor has not.</summary>
    public static bool HasData(GlbFile file, int index, string where)
    {
        var accessors = file.List("accessors");
        JsonElement accessor = accessors[file.Checked(index, accessors.Count, "accessor", where)];
        return file.Index(accessor, "bufferView", where) is not null;
    }

    private static int Offset(GlbFile file, JsonElement element, string where) =>
        file.Index(element, "byteOffset", where) ?? 0;

    private static int SizeOf(int type) => type switch
    {
        Int8 or UInt8 => 1,
        Int16 or UInt16 => 2,
        UInt32 or Float => 4,
        _ => 0,
    };

    private void Overwrite(JsonElement sparse, double[] numbers)
    {
        string where = _where + ".sparse";
        int count = _file.Index(sparse, "count", where) ?? throw _file.Refuse(where, "count is missing");
        if (!_file.TryObject(sparse, "indices", where, out JsonElement indices)
            || !_file.TryObject(sparse, "values", where, out JsonElement values))
            throw _file.Refuse(where, "indices and values are needed");
        int type = _file.Index(indices, "componentType", where) ?? 0;
        if (type is not (UInt8 or UInt16 or UInt32)) throw _file.Refuse(where, $"indices of component type {type}");
        if (count > numbers.Length / _width) throw _file.Refuse(where, $"{count} indices are too many");
        double[] places = Elements(View(indices, where), Offset(_file, indices, where), count, type, 1);
        double[] fresh = Elements(View(values, where), Offset(_file, values, where), count, _type, _width);
        for (int i = 0; i < count; i++)
        {
            int given = (int)Math.Min(places[i], int.MaxValue);
            int place = _file.Checked(given, numbers.Length / _width, "element", where);
            Array.Copy(fresh, i * _width, numbers, place * _width, _width);
        }
    }

    private int View(JsonElement element, string where) =>
        _file.Index(element, "bufferView", where) ?? throw _file.Refuse(where, "bufferView is missing");

    private double[] Elements(int viewIndex, int offset, int count, int type, int width)
    {
        string where = $"bufferViews[{viewIndex}]";
        var views = _file.List("bufferViews");
        JsonElement view = views[_file.Checked(viewIndex, views.Count, "buffer view", _where)];
        if (_file.TryObject(view, "extensions", where, out JsonElement extensions)
            && extensions.TryGetProperty("EXT_meshopt_compression", out _))
            throw _file.Refuse(where, "is compressed with EXT_meshopt_compression, which is not read");
        ReadOnlySpan<byte> bytes = _file.Buffer(_file.Index(view, "buffer", where) ?? 0, where).Span;
        int size = SizeOf(type) * width;
        int stride = _file.Index(view, "byteStride", where) ?? size;
        long length = _file.Index(view, "byteLength", where) ?? throw _file.Refuse(where, "byteLength is missing");
        long start = (long)Offset(_file, view, where) + offset, end = Offset(_file, view, where) + length;
        if (stride < size) throw _file.Refuse(where, $"a byteStride of {stride} is less than an element's {size}");
        if (end > bytes.Length) throw _file.Refuse(where, $"ends at byte {end}, but its buffer has {bytes.Length}");
        if (count > 0 && start + (count - 1L) * stride + size > end)
            throw _file.Refuse(_where, $"{count} elements do not fit into bufferViews[{viewIndex}]");
        var numbers = new double[count * width];
        for (int i = 0; i < numbers.Length; i++)
        {
            long at = start + (long)(i / width) * stride + i % width * SizeOf(type);
            numbers[i] = Component(bytes[(int)at..], type);
        }

        return numbers;
    }

    private static double Component(ReadOnlySpan<byte> bytes, int type) => type switch
    {
        Int8 => (sbyte)bytes[0],
        UInt8 => bytes[0],
        Int16 => BinaryPrimitives.ReadInt16LittleEndian(bytes),
        UInt16 => BinaryPrimitives.ReadUInt16LittleEndian(bytes),
        UInt32 => BinaryPrimitives.ReadUInt32LittleEndian(bytes),
        _ => LittleEndian.Single(bytes),
    };

    /// <summary>Integers as shares of their largest value; the lowest one counts as -1, too.</summary>
    private double[] Normalized(double[] numbers)
    {
        double largest = _type switch
        {
            Int8 => sbyte.MaxValue,
            UInt8 => byte.MaxValue,
            Int16 => short.MaxValue,
            UInt16 => ushort.MaxValue,
            _ => 1,
        };
        for (int i = 0; i < numbers.Length; i++) numbers[i] = Math.Max(numbers[i] / largest, -1);
        return numbers;
    }
}
