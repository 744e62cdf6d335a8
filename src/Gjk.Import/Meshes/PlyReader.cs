using System.Buffers.Binary;

namespace Gjk.Import;

/// <summary>Reads PLY, text or binary: the positions of the vertices, and the faces. Everything else in the file is
/// passed over.</summary>
internal sealed class PlyReader
{
    private const int RowsPerLook = 4096;

    private readonly string _file;
    private readonly byte[] _bytes;
    private readonly MeshText _text;
    private readonly PlyHeader _header;
    private readonly ImportLog _log;
    private readonly List<Vector3> _vertices = [];
    private readonly List<int> _triangles = [];
    private readonly List<double> _list = [];
    private int _next, _word;
    private string _place = "";

    private PlyReader(string file, byte[] bytes, ImportLog log)
    {
        _log = log;
        _file = file;
        _bytes = bytes;
        _text = new MeshText(file, bytes);
        _header = PlyHeader.Read(_text);
        _next = _text.Position;
        _word = int.MaxValue;
    }

    public static List<ImportedMesh> Read(string file, byte[] bytes, ImportLog log, CancellationToken cancel)
    {
        var reader = new PlyReader(file, bytes, log);
        foreach (PlyElement element in reader._header.Elements) reader.Rows(element, cancel);
        reader.WarnOfRest();
        if (reader._vertices.Count == 0) throw new ImportException($"{file}: there are no vertices in it");
        foreach (int corner in reader._triangles)
        {
            if ((uint)corner >= (uint)reader._vertices.Count)
                throw new ImportException(
                    $"{file}: a face names vertex {corner}, but there are {reader._vertices.Count}, counted from 0");
        }

        string name = System.IO.Path.GetFileNameWithoutExtension(file);
        return [ImportedMesh.Weld(name, reader._vertices, reader._triangles)];
    }

    /// <summary>Rows that the header does not count, or bytes behind the last row.</summary>
    private void WarnOfRest()
    {
        const string rest = "behind its last element are passed over";
        if (_header.Format != PlyFormat.Text && _next < _bytes.Length)
            _log.Warn(_file, $"{_bytes.Length - _next} bytes {rest}");
        while (_header.Format == PlyFormat.Text && _text.NextLine())
            _log.Warn($"{_file}:{_text.Line}", "lines " + rest);
    }

    private ImportException Refuse(string reason) => new($"{_file}: {_place}: {reason}");

    private void Rows(PlyElement element, CancellationToken cancel)
    {
        int x = element.IndexOf("x"), y = element.IndexOf("y"), z = element.IndexOf("z");
        bool isVertex = element.Name == "vertex", isFace = element.Name == "face";
        _place = element.Name;
        if (isVertex && (x < 0 || y < 0 || z < 0)) throw Refuse("the properties x, y and z are needed");
        int corners = isFace
            ? element.Properties.FindIndex(p => p.Length is not null && p.Name is "vertex_indices" or "vertex_index")
            : -1;
        var row = new double[element.Properties.Count];
        if (row.Length == 0) return;
        for (int i = 0; i < element.Count; i++)
        {
            if (i % RowsPerLook == 0) cancel.ThrowIfCancellationRequested();
            _place = $"{element.Name} {i}";
            for (int k = 0; k < row.Length; k++)
            {
                PlyProperty property = element.Properties[k];
                if (property.Length is null) row[k] = Value(property.Type);
                else List(property);
                if (k == corners) Face();
            }

            EndRow();
            if (!isVertex) continue;
            var vertex = new Vector3((float)row[x], (float)row[y], (float)row[z]);
            _vertices.Add(MeshText.Checked(vertex, () => Refuse("a coordinate is not a finite number of a float")));
        }
    }

    private void Face()
    {
        if (_list.Count < 3) _log.Warn($"{_file}: {_place}", "a face of fewer than three corners is left out");
        for (int i = 1; i + 1 < _list.Count; i++)
        {
            _triangles.Add(Corner(_list[0]));
            _triangles.Add(Corner(_list[i]));
            _triangles.Add(Corner(_list[i + 1]));
        }
    }

    private int Corner(double value) =>
        value >= 0 && value <= int.MaxValue && value == Math.Floor(value)
            ? (int)value
            : throw Refuse($"there is no vertex {value.ToString(CultureInfo.InvariantCulture)}");

    private void List(PlyProperty property)
    {
        double length = Value(property.Length!.Value);
        if (length < 0 || length != Math.Floor(length))
            throw Refuse("the length of a list is not a number of elements");
        _list.Clear();
        for (long i = 0; i < length; i++) _list.Add(Value(property.Type));
    }

    private double Value(PlyType type) => _header.Format == PlyFormat.Text ? Word(type) : Binary(type);

    private double Word(PlyType type)
    {
        if (_word >= _text.Words.Count)
        {
            if (_word != int.MaxValue) throw Refuse($"line {_text.Line} has too few numbers");
            if (!_text.NextLine()) throw Refuse("the file ends here");
            _word = 0;
        }

        string word = _text.Words[_word++];
        if (type == PlyType.Float32) return _text.Number(word);
        bool isNumber = double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double value);
        return isNumber ? value : throw _text.Refuse($"\"{MeshText.Short(word)}\" is not a number");
    }

    /// <summary>In a text file each row is a line.</summary>
    private void EndRow()
    {
        if (_header.Format != PlyFormat.Text) return;
        if (_word < _text.Words.Count) throw Refuse($"line {_text.Line} has too many numbers");
        _word = int.MaxValue;
    }

    private double Binary(PlyType type)
    {
        int size = type switch
        {
            PlyType.Int8 or PlyType.UInt8 => 1,
            PlyType.Int16 or PlyType.UInt16 => 2,
            PlyType.Float64 => 8,
            _ => 4,
        };
        if (_bytes.Length - _next < size) throw Refuse("the file ends here");
        Span<byte> value = stackalloc byte[8];
        value = value[..size];
        _bytes.AsSpan(_next, size).CopyTo(value);
        _next += size;
        if (_header.Format == PlyFormat.BigEndian) value.Reverse();
        return type switch
        {
            PlyType.Int8 => (sbyte)value[0],
            PlyType.UInt8 => value[0],
            PlyType.Int16 => BinaryPrimitives.ReadInt16LittleEndian(value),
            PlyType.UInt16 => BinaryPrimitives.ReadUInt16LittleEndian(value),
            PlyType.Int32 => BinaryPrimitives.ReadInt32LittleEndian(value),
            PlyType.UInt32 => BinaryPrimitives.ReadUInt32LittleEndian(value),
            PlyType.Float32 => LittleEndian.Single(value),
            _ => LittleEndian.Double(value),
        };
    }
}
