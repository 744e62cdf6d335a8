namespace Gjk.Import;

internal enum PlyFormat
{
    Text,
    LittleEndian,
    BigEndian,
}

/// <summary>A number type of PLY, under either of its names.</summary>
internal enum PlyType
{
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Float32,
    Float64,
}

/// <summary>A property of an element. A list has the type of its length, too.</summary>
internal sealed record PlyProperty(string Name, PlyType Type, PlyType? Length);

/// <summary>A table of the file.</summary>
internal sealed record PlyElement(string Name, int Count, List<PlyProperty> Properties)
{
    public int IndexOf(string property) => Properties.FindIndex(p => p.Name == property && p.Length is null);
}

/// <summary>The text at the beginning of a PLY file (Turk 1994, "The PLY Polygon File Format").</summary>
internal sealed class PlyHeader
{
    private readonly MeshText _text;
    private readonly List<PlyElement> _elements = [];
    private PlyFormat? _format;

    private PlyHeader(MeshText text) => _text = text;

    public PlyFormat Format => _format!.Value;

    public IReadOnlyList<PlyElement> Elements => _elements;

    public static PlyHeader Read(MeshText text)
    {
        var header = new PlyHeader(text);
        if (!text.NextLine() || text.Words[0] != "ply") throw text.Refuse("not a PLY file: it must begin with \"ply\"");
        while (true)
        {
            if (!text.NextLine()) throw text.Refuse("the file ends before \"end_header\"");
            if (text.Words[0] == "end_header") break;
            header.ReadLine(text.Words);
        }

        if (header._format is null) throw text.Refuse("the header has no \"format\"");
        return header;
    }

    private void ReadLine(IReadOnlyList<string> words)
    {
        switch (words[0])
        {
            case "comment" or "obj_info":
                break;
            case "format":
                _format = words.Count < 2 ? throw _text.Refuse("the format is missing") : words[1] switch
                {
                    "ascii" => PlyFormat.Text,
                    "binary_little_endian" => PlyFormat.LittleEndian,
                    "binary_big_endian" => PlyFormat.BigEndian,
                    _ => throw _text.Refuse($"unknown format \"{MeshText.Short(words[1])}\""),
                };
                break;
            case "element" when words.Count == 3:
                int count = _text.Whole(words[2]);
                if (count < 0) throw _text.Refuse($"{count} is not a number of elements");
                _elements.Add(new PlyElement(words[1], count, []));
                break;
            case "property" when words.Count == 3 && _elements.Count > 0:
                _elements[^1].Properties.Add(new PlyProperty(words[2], TypeOf(words[1]), null));
                break;
            case "property" when words.Count == 5 && words[1] == "list" && _elements.Count > 0:
                PlyType length = TypeOf(words[2]);
                if (length is PlyType.Float32 or PlyType.Float64)
                    throw _text.Refuse("the length of a list must be a whole number");
                _elements[^1].Properties.Add(new PlyProperty(words[4], TypeOf(words[3]), length));
                break;
            default:
                throw _text.Refuse($"\"{MeshText.Short(_text.Text.Trim())}\" is not a line of a PLY header");
        }
    }

    private PlyType TypeOf(string name) => name switch
    {
        "char" or "int8" => PlyType.Int8,
        "uchar" or "uint8" => PlyType.UInt8,
        "short" or "int16" => PlyType.Int16,
        "ushort" or "uint16" => PlyType.UInt16,
        "int" or "int32" => PlyType.Int32,
        "uint" or "uint32" => PlyType.UInt32,
        "float" or "float32" => PlyType.Float32,
        "double" or "float64" => PlyType.Float64,
        _ => throw _text.Refuse($"unknown type \"{MeshText.Short(name)}\""),
    };
}
