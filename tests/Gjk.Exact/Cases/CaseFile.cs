using System.IO;

namespace Gjk.Exact.Cases;

/// <summary>One family of tests/Cases: its posed shapes, and the pairs with their proved answers.</summary>
public sealed class CaseFile
{
    /// <summary>Families whose answers are distances.</summary>
    public static readonly IReadOnlyList<string> Distances =
    [
        "parallel", "align", "touch", "deep", "aspect", "large", "degenerate", "dense", "everyday", "offset", "uneven",
    ];

    /// <summary>Families whose answers are depths.</summary>
    public static readonly IReadOnlyList<string> Depths =
    [
        "depth_box_deep", "depth_box_shallow", "depth_concentric", "depth_far", "depth_flush", "depth_hull128",
        "depth_hull32", "depth_hull8", "depth_needle", "depth_nested", "depth_ratio", "depth_round",
    ];

    /// <summary>Families whose answers are casts.</summary>
    public static readonly IReadOnlyList<string> Casts =
    [
        "cast_box", "cast_graze", "cast_hull32", "cast_hull8", "cast_inside", "cast_miss", "cast_ray", "cast_round",
        "cast_slide", "cast_speed", "cast_thin",
    ];

    private CaseFile(string name, IReadOnlyList<PosedShape> objects, IReadOnlyList<CasePair> pairs) =>
        (Name, Objects, Pairs) = (name, objects, pairs);

    /// <summary>The family.</summary>
    public string Name { get; }

    /// <summary>What its answers are.</summary>
    public CaseKind Kind =>
        Depths.Contains(Name) ? CaseKind.Depth : Casts.Contains(Name) ? CaseKind.Cast : CaseKind.Distance;

    /// <summary>What the pairs are made of.</summary>
    public IReadOnlyList<PosedShape> Objects { get; }

    /// <summary>In the order of the answers.</summary>
    public IReadOnlyList<CasePair> Pairs { get; }

    /// <summary>Reads a family.</summary>
    /// <param name="folder">Where the files are: tests/Cases.</param>
    /// <param name="name">The family.</param>
    public static CaseFile Read(string folder, string name)
    {
        Dictionary<string, object> scene = Json.ReadObject(File.ReadAllText(Path.Combine(folder, name + ".json")));
        Dictionary<string, CaseMesh> meshes = scene.TryGetValue("meshes", out object? given)
            ? ((Dictionary<string, object>)given).ToDictionary(m => m.Key, m => new CaseMesh((List<object>)m.Value))
            : [];
        var listed = (List<object>)scene["objects"];
        PosedShape[] objects = [.. listed.Select(o => new PosedShape((Dictionary<string, object>)o, meshes))];
        string[][] rows = [.. File.ReadLines(Path.Combine(folder, name + ".expected.csv")).Select(r => r.Split(','))];
        return new CaseFile(name, objects, [.. rows.Skip(1).Select(r => new CasePair(name, rows[0], r, objects))]);
    }
}

/// <summary>What a family's answers are.</summary>
public enum CaseKind
{
    Distance,
    Depth,
    Cast,
}

/// <summary>A pair of a family, with the row of its answer.</summary>
public sealed class CasePair
{
    private readonly string[] _columns, _cells;

    internal CasePair(string family, string[] columns, string[] cells, PosedShape[] objects)
    {
        (_columns, _cells) = (columns, cells);
        (IndexA, IndexB) = ((int)Number("a"), (int)Number("b"));
        (A, B) = (objects[IndexA], objects[IndexB]);
        Name = $"{family} {IndexA},{IndexB} {this["case"]}";
    }

    /// <summary>The family, the objects' places in it, and what they are.</summary>
    public string Name { get; }

    public int IndexA { get; }

    public int IndexB { get; }

    public PosedShape A { get; }

    public PosedShape B { get; }

    /// <summary>The longest side of the two local boxes.</summary>
    public double Scale => Math.Max(A.LongestSide, B.LongestSide);

    /// <summary>A cell of the answer.</summary>
    public string this[string column]
    {
        get
        {
            int i = Array.IndexOf(_columns, column);
            return i >= 0 ? _cells[i] : throw new InvalidDataException($"{Name}: there is no column '{column}'.");
        }
    }

    /// <summary>A cell as a number.</summary>
    public double Number(string column) => Json.Number(this[column]);
}

/// <summary>A shape where it is, and how it moves.</summary>
public sealed class PosedShape
{
    public readonly ConvexShape Shape;
    public readonly RigidPose Pose;

    /// <summary>Over the fractions from 0 to 1, in the world.</summary>
    public readonly Vector3 Velocity;

    internal PosedShape(Dictionary<string, object> o, Dictionary<string, CaseMesh> meshes)
    {
        var given = (Dictionary<string, object>)o["shape"];
        ConvexShape shape = Make(given, meshes, out Vector3 size);
        if (o.TryGetValue("scale", out object? factors))
        {
            Vector3 scale = Json.Vector(factors);
            shape = shape.Scaled(scale);
            size = Vector3.Abs(scale * size);
        }

        Shape = shape;
        LongestSide = Math.Max(size.X, Math.Max(size.Y, size.Z));
        var q = o.TryGetValue("rotation", out object? r) ? (List<object>)r : null;
        Quaternion rotation = q is null
            ? Quaternion.Identity
            : new Quaternion(Json.Float(q[0]), Json.Float(q[1]), Json.Float(q[2]), Json.Float(q[3]));
        Pose = new RigidPose(rotation, Json.Vector(o["position"]));
        if (o.TryGetValue("velocity", out object? velocity)) Velocity = Json.Vector(velocity);
    }

    /// <summary>Of the local box, margin included.</summary>
    public double LongestSide { get; }

    private static ConvexShape Make(
        Dictionary<string, object> s, Dictionary<string, CaseMesh> meshes, out Vector3 size)
    {
        var type = (string)s["type"];
        float radius = s.TryGetValue("radius", out object? r) ? Json.Float(r) : 0;
        float half = s.TryGetValue("halfHeight", out object? h) ? Json.Float(h) : 0;
        float halfLength = type == "cylinder" ? half : half + radius;
        size = 2 * new Vector3(radius, halfLength, radius);
        switch (type)
        {
            case "point": return ConvexShape.Point();
            case "sphere": return ConvexShape.Sphere(radius);
            case "capsule": return ConvexShape.Capsule(radius, half);
            case "cylinder": return ConvexShape.Cylinder(radius, half);
            case "box":
                size = 2 * Json.Vector(s["halfExtents"]);
                return ConvexShape.Box(size / 2);
            case "mesh":
                CaseMesh mesh = meshes[(string)s["mesh"]];
                size = mesh.Size;
                return mesh.Shape;
            default: throw new InvalidDataException($"There is no shape '{type}'.");
        }
    }
}

/// <summary>A mesh, hulled once.</summary>
internal sealed class CaseMesh
{
    public readonly ConvexShape Shape;

    /// <summary>Of its box.</summary>
    public readonly Vector3 Size;

    public CaseMesh(List<object> vertices)
    {
        Shape = ConvexShape.Mesh(vertices.ConvertAll(Json.Vector));
        Size = Shape.Hull!.Bounds.Max - Shape.Hull.Bounds.Min;
    }
}
