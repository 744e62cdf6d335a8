using System.Collections.Concurrent;
using System.Globalization;
using System.Text.Json;

namespace Gjk.Core.Tests.Support;

/// <summary>A hard pair and its proved answer.</summary>
internal sealed record HardCase(int IndexA, int IndexB, TestPair Pair, bool Overlap, double Distance, double Depth);

/// <summary>One file of tests/Cases with its answers, read once, each mesh hulled once.</summary>
internal sealed class CaseFamily
{
    private static readonly ConcurrentDictionary<string, Lazy<CaseFamily>> Loaded = new();

    private CaseFamily(string name)
    {
        Name = name;
        using var scene = JsonDocument.Parse(Read($"{name}.json"));
        (TestShape Shape, RigidPose Pose)[] objects = Objects(scene.RootElement);
        string[] rows = Read($"{name}.expected.csv").Split('\n', StringSplitOptions.RemoveEmptyEntries);
        bool isDepth = rows[0].Trim() == "a,b,depth,nx,ny,nz,ties,case";
        if (!isDepth && rows[0].Trim() != "a,b,overlap,distance,depth,case")
            throw new InvalidDataException($"{name}: unexpected header '{rows[0]}'.");
        Cases = [.. rows.Skip(1).Select(row => Case(row.Trim().Split(','), objects, isDepth))];
    }

    public static IEnumerable<string> Names =>
    [
        "parallel", "align", "touch", "deep", "aspect", "large", "degenerate", "dense", "everyday", "offset", "uneven",
    ];

    /// <summary>The families whose answers are depths.</summary>
    public static IEnumerable<string> DepthNames =>
    [
        "depth_box_deep", "depth_box_shallow", "depth_concentric", "depth_far", "depth_flush", "depth_hull128",
        "depth_hull32", "depth_hull8", "depth_needle", "depth_nested", "depth_ratio", "depth_round",
    ];

    public string Name { get; }

    public IReadOnlyList<HardCase> Cases { get; }

    public static CaseFamily Load(string name) =>
        Loaded.GetOrAdd(name, n => new Lazy<CaseFamily>(() => new CaseFamily(n))).Value;

    /// <summary>Fails with the first few of the cases in which something is found wrong.</summary>
    public static void Each(string family, Func<HardCase, string?> examine)
    {
        var failures = new List<string>();
        foreach (HardCase c in Load(family).Cases)
        {
            if (examine(c) is { } problem)
                failures.Add($"{c.Pair.Name}: {problem}; truth: distance {c.Distance:R}, depth {c.Depth:R}");
        }

        string worst = string.Join("\n", failures.Take(5));
        Assert.True(failures.Count == 0, $"{family}: {failures.Count} pairs fail.\n{worst}");
    }

    /// <summary>A scene's shapes and where they are.</summary>
    public static (TestShape Shape, RigidPose Pose)[] Objects(JsonElement scene)
    {
        Dictionary<string, TestShape> meshes = scene.TryGetProperty("meshes", out JsonElement given)
            ? given.EnumerateObject().ToDictionary(m => m.Name, Mesh)
            : [];
        return [.. scene.GetProperty("objects").EnumerateArray().Select(o => Object(o, meshes))];
    }

    /// <summary>The text of a file of tests/Cases.</summary>
    public static string Read(string file)
    {
        using Stream stream = typeof(CaseFamily).Assembly.GetManifestResourceStream($"Cases/{file}")
            ?? throw new FileNotFoundException("Not embedded: " + file);
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }

    private static TestShape Mesh(JsonProperty mesh)
    {
        Vector3[] points = [.. mesh.Value.EnumerateArray().Select(Vector)];
        return TestShape.Mesh(mesh.Name, new ConvexHull(points), points);
    }

    private static (TestShape Shape, RigidPose Pose) Object(JsonElement o, Dictionary<string, TestShape> meshes)
    {
        TestShape unscaled = Shape(o.GetProperty("shape"), meshes);
        Quaternion rotation = o.TryGetProperty("rotation", out JsonElement q)
            ? new Quaternion(q[0].GetSingle(), q[1].GetSingle(), q[2].GetSingle(), q[3].GetSingle())
            : Quaternion.Identity;
        TestShape shape = o.TryGetProperty("scale", out JsonElement scale)
            ? unscaled.Scaled(Vector(scale))
            : unscaled;
        return (shape, new RigidPose(rotation, Vector(o.GetProperty("position"))));
    }

    private static TestShape Shape(JsonElement s, Dictionary<string, TestShape> meshes)
    {
        string type = s.GetProperty("type").GetString()!;
        return type switch
        {
            "mesh" => meshes[s.GetProperty("mesh").GetString()!],
            "box" => TestShape.Box(Vector(s.GetProperty("halfExtents"))),
            "sphere" => TestShape.Sphere(s.GetProperty("radius").GetSingle()),
            "capsule" => TestShape.Capsule(
                s.GetProperty("radius").GetSingle(), s.GetProperty("halfHeight").GetSingle()),
            "cylinder" => TestShape.Cylinder(
                s.GetProperty("radius").GetSingle(), s.GetProperty("halfHeight").GetSingle()),
            "point" => TestShape.Point(),
            _ => throw new InvalidDataException($"Unknown shape '{type}'."),
        };
    }

    /// <summary>Three numbers.</summary>
    public static Vector3 Vector(JsonElement e) => new(e[0].GetSingle(), e[1].GetSingle(), e[2].GetSingle());

    private HardCase Case(string[] cells, (TestShape Shape, RigidPose Pose)[] objects, bool isDepth)
    {
        int a = int.Parse(cells[0], CultureInfo.InvariantCulture);
        int b = int.Parse(cells[1], CultureInfo.InvariantCulture);
        var pair = new TestPair(
            $"{Name} {a},{b} {cells[^1]}", objects[a].Shape, objects[a].Pose, objects[b].Shape, objects[b].Pose);
        if (isDepth)
        {
            double depth = Number(cells[2]);
            return new HardCase(a, b, pair, depth >= 0, Math.Max(-depth, 0), Math.Max(depth, 0));
        }

        return new HardCase(a, b, pair, bool.Parse(cells[2]), Number(cells[3]), Number(cells[4]));
    }

    /// <summary>A number as the answers have it.</summary>
    public static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
