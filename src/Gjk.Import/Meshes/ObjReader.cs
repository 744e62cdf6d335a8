using System.Linq;

namespace Gjk.Import;

/// <summary>Reads Wavefront OBJ (Alias|Wavefront, "Object Files", Advanced Visualizer manual, appendix B1). Each object
/// (o) and group (g) is a part. Only positions and faces are used. Curves and surfaces are refused, and unknown
/// statements are passed over with a warning.</summary>
internal sealed class ObjReader
{
    private const int LinesPerLook = 4096;

    private readonly string _file;
    private readonly ImportLog _log;
    private readonly MeshText _text;
    private readonly List<Vector3> _vertices = [];
    private readonly Dictionary<string, List<int>> _faces = new(StringComparer.Ordinal);
    private readonly Dictionary<string, List<Vector3>> _loose = new(StringComparer.Ordinal);
    private readonly Dictionary<string, List<Vector3>> _points = new(StringComparer.Ordinal);
    private readonly List<string> _order = [];
    private readonly PolygonTriangles _polygons = new();
    private string _object = "", _group = "";
    private string? _unknown;

    private ObjReader(string file, byte[] bytes, ImportLog log)
    {
        _file = file;
        _log = log;
        _text = new MeshText(file, bytes);
    }

    private string PartName => (_object, _group) switch
    {
        ("", "") => "default",
        ("", _) => _group,
        (_, "" or "default") => _object,
        _ => $"{_object}/{_group}",
    };

    public static List<ImportedMesh> Read(string file, byte[] bytes, ImportLog log, CancellationToken cancel)
    {
        var reader = new ObjReader(file, bytes, log);
        reader.ReadLines(cancel);
        List<ImportedMesh> parts = reader.Parts();
        if (parts.Count > 0) return parts;
        throw new ImportException(reader._unknown ?? $"{file}: there are no vertices in it");
    }

    private void ReadLines(CancellationToken cancel)
    {
        int untilLook = 0;
        while (_text.NextLine(comment: '#', continues: '\\'))
        {
            if (--untilLook < 0)
            {
                cancel.ThrowIfCancellationRequested();
                untilLook = LinesPerLook;
            }

            ReadLine(_text.Words);
        }
    }

    private void ReadLine(IReadOnlyList<string> words)
    {
        switch (words[0])
        {
            case "v":
                ReadVertex(words);
                break;
            case "f" or "fo":
                ReadFace(words);
                break;
            case "o":
                _object = NameOf(words);
                _group = "";
                break;
            case "g":
                _group = NameOf(words);
                break;
            case "l" or "p":
                ReadLoose(words);
                break;
            case "vt" or "vn" or "s" or "usemtl" or "mtllib" or "mg" or "bevel" or "c_interp"
                or "d_interp" or "lod" or "maplib" or "usemap" or "shadow_obj" or "trace_obj":
                break;
            case "vp" or "cstype" or "deg" or "bmat" or "step" or "curv" or "curv2" or "surf" or "parm" or "trim"
                or "hole" or "scrv" or "sp" or "end" or "con" or "ctech" or "stech" or "bzp" or "bsp" or "cdc"
                or "cdp" or "res":
                throw _text.Refuse($"\"{words[0]}\": curves and surfaces are not read, only faces");
            default:
                Unknown(words[0]);
                break;
        }
    }

    /// <summary>Programs write words of their own. In a file without vertices the word is the reason.</summary>
    private void Unknown(string word)
    {
        string what = $"\"{MeshText.Short(word)}\" is not a statement of an OBJ file";
        _unknown ??= _text.Refuse(what).Message;
        _log.Warn($"{_file}:{_text.Line}", what + ", and is passed over", "not a statement");
    }

    private static string NameOf(IReadOnlyList<string> words) => string.Join(" ", words.Skip(1));

    /// <summary>A weight or a colour of three or four numbers may follow the three coordinates. As nothing reads them,
    /// they may be too large or no number of their own.</summary>
    private void ReadVertex(IReadOnlyList<string> words)
    {
        if (words.Count < 4) throw _text.Refuse($"a vertex needs three coordinates, but has {words.Count - 1}");
        if (words.Count is 6 or > 8)
            throw _text.Refuse($"a vertex has 3 numbers, 4, 6 or 7, but this one has {words.Count - 1}");
        for (int i = 4; i < words.Count; i++) _text.CheckNumeric(words[i]);
        var vertex = new Vector3(_text.Number(words[1]), _text.Number(words[2]), _text.Number(words[3]));
        _vertices.Add(vertex);
        if (!_points.TryGetValue(PartName, out List<Vector3>? points)) _points[PartName] = points = [];
        points.Add(vertex);
    }

    private void ReadFace(IReadOnlyList<string> words)
    {
        var polygon = new int[words.Count - 1];
        for (int i = 0; i < polygon.Length; i++) polygon[i] = Corner(words[i + 1]);
        var triangles = new List<int>();
        PolygonFaults faults = _polygons.Append(_vertices, polygon, triangles);
        if (faults != PolygonFaults.None) _log.WarnOf($"{_file}:{_text.Line}", faults);
        if (triangles.Count == 0) return;
        if (!_faces.TryGetValue(PartName, out List<int>? corners))
        {
            _faces[PartName] = corners = [];
            if (!_loose.ContainsKey(PartName)) _order.Add(PartName);
        }

        corners.AddRange(triangles);
    }

    /// <summary>Lines and points have no faces. They count only in a part that has nothing else.</summary>
    private void ReadLoose(IReadOnlyList<string> words)
    {
        if (!_loose.TryGetValue(PartName, out List<Vector3>? points))
        {
            _loose[PartName] = points = [];
            if (!_faces.ContainsKey(PartName)) _order.Add(PartName);
        }

        for (int i = 1; i < words.Count; i++) points.Add(_vertices[Corner(words[i])]);
    }

    /// <summary>The vertex of v, v/vt, v//vn or v/vt/vn. Negative indices count back from the last vertex.</summary>
    private int Corner(string word)
    {
        int slash = word.IndexOf('/', StringComparison.Ordinal);
        int index = _text.Whole(slash < 0 ? word : word[..slash]);
        if (slash >= 0) CheckOthers(word, slash + 1);
        long vertex = index < 0 ? (long)_vertices.Count + index : (long)index - 1;
        if (vertex >= 0 && vertex < _vertices.Count) return (int)vertex;
        throw _text.Refuse($"there is no vertex {index}: {_vertices.Count} came before this face");
    }

    /// <summary>The texture coordinate and the normal: each a number or nothing, and nothing behind them.</summary>
    private void CheckOthers(string word, int start)
    {
        string[] others = word[start..].Split('/');
        bool isGood = others.Length <= 2 && Array.TrueForAll(
            others, o => o.Length == 0
                || int.TryParse(o, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out _));
        if (isGood) return;
        throw _text.Refuse($"\"{MeshText.Short(word)}\" is not a corner: must be v, v/vt, v//vn or v/vt/vn");
    }

    private List<ImportedMesh> Parts()
    {
        var parts = new List<ImportedMesh>();
        foreach (string name in _order)
        {
            if (_faces.TryGetValue(name, out List<int>? corners))
                parts.Add(ImportedMesh.Weld(name, _vertices, corners));
            else if (_loose[name].Count > 0)
                parts.Add(ImportedMesh.Weld(name, _loose[name], []));
        }

        if (parts.Count > 0) return parts;

        // Without any face the file is a cloud of points.
        foreach ((string name, List<Vector3> points) in _points)
            parts.Add(ImportedMesh.Weld(name, points, []));
        return parts;
    }
}
