using System.Text.Encodings.Web;
using System.Text.Json;
using Gjk.Import;

namespace Gjk.Demo.Import;

/// <summary>Writes a scene as JSON, one line for each object and for each vertex. Floats have enough digits to give the
/// same bits back.</summary>
internal sealed class SceneJson
{
    private const int LinesPerLook = 4096;

    private readonly StreamWriter _out;
    private readonly CancellationToken _cancel;

    /// <summary>The meshes that are written with their triangles, and whether each is solid.</summary>
    private readonly Dictionary<ImportedMesh, bool> _surfaces = [];

    private int _untilLook;

    private SceneJson(Stream stream, CancellationToken cancel)
    {
        _out = new StreamWriter(stream, new UTF8Encoding(false)) { NewLine = "\n" };
        _cancel = cancel;
    }

    /// <param name="stream">Where to write.</param>
    /// <param name="name">The scene's name.</param>
    /// <param name="scene">What to write.</param>
    /// <param name="isConcave">Whether meshes that are not convex are written as surfaces.</param>
    /// <param name="cancel">Ends the work.</param>
    public static void Write(
        Stream stream, string name, ImportResult scene, bool isConcave, CancellationToken cancel)
    {
        var json = new SceneJson(stream, cancel);
        if (isConcave) json.FindSurfaces(scene);
        json._out.Write($"{{ \"version\": 1, \"name\": {Quoted(name)},\n");
        json.WriteMeshes(scene);
        json.WriteObjects(scene);
        json._out.Write("}\n");
        json._out.Flush();
    }

    private void FindSurfaces(ImportResult scene)
    {
        foreach (ImportedMesh mesh in scene.Meshes)
        {
            _cancel.ThrowIfCancellationRequested();
            if (mesh.IsConcave) _surfaces.Add(mesh, new TriangleMesh(mesh.Vertices, mesh.Triangles).HasInside);
        }
    }

    private void WriteMeshes(ImportResult scene)
    {
        if (scene.Meshes.Count == 0) return;
        _out.Write("  \"meshes\": {");
        string separator = "\n";
        foreach (ImportedMesh mesh in scene.Meshes)
        {
            bool isSurface = _surfaces.ContainsKey(mesh);
            _out.Write($"{separator}    {Quoted(mesh.Name)}: {(isSurface ? "{ \"vertices\": " : "")}[");
            string next = "\n      ";
            foreach (Vector3 vertex in mesh.Vertices)
            {
                Look();
                _out.Write(next);
                Write(vertex);
                next = ",\n      ";
            }

            _out.Write("]");
            if (isSurface) WriteTriangles(mesh.Triangles);
            separator = ",\n";
        }

        _out.Write(" },\n");
    }

    private void WriteTriangles(IReadOnlyList<int> corners)
    {
        _out.Write(",\n      \"triangles\": [");
        for (int i = 0; i < corners.Count; i += 3)
        {
            Look();
            _out.Write(i == 0 ? "\n      " : ",\n      ");
            _out.Write($"[{corners[i]}, {corners[i + 1]}, {corners[i + 2]}]");
        }

        _out.Write("] }");
    }

    private void WriteObjects(ImportResult scene)
    {
        _out.Write("  \"objects\": [");
        string separator = "\n";
        foreach (ImportedObject one in scene.Objects)
        {
            Look();
            _out.Write($"{separator}    {{ \"name\": {Quoted(one.Name)}, \"shape\": ");
            Write(one.Shape);
            _out.Write(", \"position\": ");
            Write(one.Position);
            if (one.Rotation != Quaternion.Identity)
            {
                _out.Write(", \"rotation\": ");
                Write(one.Rotation);
            }

            if (one.Scale != Vector3.One)
            {
                _out.Write(", \"scale\": ");
                Write(one.Scale);
            }

            _out.Write(" }");
            separator = ",\n";
        }

        _out.Write(" ]\n");
    }

    private void Write(ImportedShape shape)
    {
        bool isSolid = false;
        bool isSurface = shape is { Mesh: { } mesh, IsHull: false } && _surfaces.TryGetValue(mesh, out isSolid);
        string type = isSurface ? "surface" : shape.Kind.ToString().ToLowerInvariant();
        _out.Write($"{{ \"type\": \"{type}\"");
        switch (shape.Kind)
        {
            case ShapeKind.Mesh:
                _out.Write($", \"mesh\": {Quoted(shape.Mesh!.Name)}{(isSolid ? ", \"solid\": true" : "")}");
                break;
            case ShapeKind.Box:
                _out.Write(", \"halfExtents\": ");
                Write(shape.Sizes);
                break;
            case ShapeKind.Ellipsoid:
                _out.Write(", \"radii\": ");
                Write(shape.Sizes);
                break;
            default:
                _out.Write($", \"radius\": {Number(shape.Radius)}");
                if (shape.Kind is ShapeKind.Capsule or ShapeKind.Cylinder)
                    _out.Write($", \"halfHeight\": {Number(shape.HalfHeight)}");
                break;
        }

        if (shape.Rotation != Quaternion.Identity)
        {
            _out.Write(", \"rotation\": ");
            Write(shape.Rotation);
        }

        _out.Write(" }");
    }

    private void Write(Vector3 v) => _out.Write($"[{Number(v.X)}, {Number(v.Y)}, {Number(v.Z)}]");

    private void Write(Quaternion q) => _out.Write($"[{Number(q.X)}, {Number(q.Y)}, {Number(q.Z)}, {Number(q.W)}]");

    /// <summary>Adding 0 turns -0 into 0.</summary>
    private static string Number(float value) => (value + 0f).ToString("R", CultureInfo.InvariantCulture);

    private static string Quoted(string text) =>
        $"\"{JsonEncodedText.Encode(text, JavaScriptEncoder.UnsafeRelaxedJsonEscaping)}\"";

    private void Look()
    {
        if (--_untilLook >= 0) return;
        _cancel.ThrowIfCancellationRequested();
        _untilLook = LinesPerLook;
    }
}
