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

    /// <summary>The corners of all faces, one behind the other, and where each begins. They are cut when all vertices
    /// are known.</summary>
    private readonly List<int> _corners = [], _faces = [];
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
        reader.CutFaces(cancel);
        string name = System.IO.Path.GetFileNameWithoutExtension(file);
        return [ImportedMesh.Weld(name, reader._vertices, reader._triangles)];
    }

    private void CutFaces(CancellationToken cancel)
    {
        foreach (List<int> corners in (List<int>[])[_corners, _triangles])
        {
            foreach (int corner in corners)
            {
                if ((uint)corner < (uint)_vertices.Count) continue;
                throw new ImportException(
                    $"{_file}: a face names vertex {corner}, but there are {_vertices.Count}, counted from 0");
            }
        }

        int[] all = _corners.ToArray();
        var polygons = new PolygonTriangles();
        for (int i = 0; i < _faces.Count; i++)
        {
            if (i % RowsPerLook == 0) cancel.ThrowIfCancellationRequested();
            int end = i + 1 < _faces.Count ? _faces[i + 1] : all.Length;
            PolygonFaults faults = polygons.Append(_vertices, all.AsSpan(_faces[i]..end), _triangles);
            if (faults != PolygonFaults.None) _log.WarnOf($"{_file}: face {i}", faults);
        }
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
        bool isStrip = element.Name == "tristrips";
        _place = element.Name;
        if (isVertex && (x < 0 || y < 0 || z < 0)) throw Refuse("the properties x, y and z are needed");
        int corners = isFace || isStrip
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
                if (property.Length is not null) List(property, k == corners);
                else row[k] = Value(property.Type, isVertex && (k == x || k == y || k == z));
                if (k != corners) continue;
                if (isFace) Face();
                else Strips();
            }

            EndRow();
            if (!isVertex) continue;
            var vertex = new Vector3((float)row[x], (float)row[y], (float)row[z]);
            _vertices.Add(MeshText.Checked(vertex, () => Refuse("a coordinate is not a finite number of a float")));
        }
    }

    private void Face()
    {
        _faces.Add(_corners.Count);
        foreach (double corner in _list) _corners.Add(Corner(corner));
    }

    /// <summary>Many strips are one list, with -1 between them.</summary>
    private void Strips()
    {
        var strip = new List<int>();
        foreach (double corner in _list)
        {
            if (corner != -1) strip.Add(Corner(corner));
            if (corner != -1) continue;
            TriangleStrip.Append(strip.ToArray(), _triangles);
            strip.Clear();
        }

        TriangleStrip.Append(strip.ToArray(), _triangles);
    }

    private int Corner(double value) =>
        value >= 0 && value <= int.MaxValue && value == Math.Floor(value)
            ? (int)value
            : throw Refuse($"there is no vertex {value.ToString(CultureInfo.InvariantCulture)}");

    private void List(PlyProperty property, bool isUsed)
    {
        double length = Value(property.Length!.Value, true);
        if (length < 0 || length != Math.Floor(length))
            throw Refuse("the length of a list is not a number of elements");
        _list.Clear();
        for (long i = 0; i < length; i++) _list.Add(Value(property.Type, isUsed));
    }

    /// <param name="type">The number's type.</param>
    /// <param name="isUsed">False for colours and the like, of which a text may say anything.</param>
    private double Value(PlyType type, bool isUsed) =>
        _header.Format == PlyFormat.Text ? Word(type, isUsed) : Binary(type);

    private double Word(PlyType type, bool isUsed)
    {
        if (_word >= _text.Words.Count)
        {
            if (_word != int.MaxValue) throw Refuse($"line {_text.Line} has too few numbers");
            if (!_text.NextLine()) throw Refuse("the file ends here");
            _word = 0;
        }

        string word = _text.Words[_word++];
        if (!isUsed) return double.NaN;
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
