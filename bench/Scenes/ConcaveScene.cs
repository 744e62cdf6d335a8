using Gjk.Exact.Meshes;

namespace Gjk.Bench.Scenes;

/// <summary>Two shapes of which one is a surface at least, in poses that have the same gap.</summary>
public sealed class ConcaveScene
{
    /// <summary>Poses of B in every set.</summary>
    private const int Count = 16;

    /// <summary>World units, along with the names of the sets that have them; the last is how deep.</summary>
    private static readonly (string Name, float Gap)[] s_gaps =
        [("touching", 1e-4f), ("near", 0.01f), ("middle", 0.3f), ("far", 5), ("overlapping", -0.2f)];

    private readonly ConcaveScratch _scratch = new();

    private ConcaveScene(in AnyShape a, in AnyShape b, double size)
    {
        A = a;
        B = b;
        Size = size;
    }

    /// <summary>The sets: two meshes, their triangles, how near they are; plates; and convex shapes near a
    /// mesh.</summary>
    public static IEnumerable<string> Names =>
    [
        .. from mesh in (string[])["torus 10k", "bumpy 10k", "torus 100k", "bumpy 100k"]
           from gap in s_gaps
           select $"{mesh} {gap.Name}",
        "plates 100k", "sphere by bumpy 100k", "box by bumpy 100k",
    ];

    public AnyShape A { get; }

    public AnyShape B { get; }

    /// <summary>Of the larger shape.</summary>
    public double Size { get; }

    /// <summary>Poses of B; A's is the identity.</summary>
    public RigidPose[] Poses { get; private set; } = [];

    public static ConcaveScene Create(string name)
    {
        string[] words = name.Split(' ');
        if (words[0] == "plates") return Plates();
        int triangles = name.Contains("100k", StringComparison.Ordinal) ? 100_000 : 10_000;
        if (words[1] == "by")
        {
            ConvexShape convex = words[0] == "box" ? ConvexShape.Box(new Vector3(0.3f)) : ConvexShape.Sphere(0.3f);
            return Placed(AnyShape.Of(convex), AnyShape.Surface(Bumpy(triangles)), 0.01f);
        }

        float gap = s_gaps.Single(g => g.Name == words[^1]).Gap;
        var shape = AnyShape.Surface(words[0] == "torus" ? Torus(triangles) : Bumpy(triangles));
        return Placed(shape, shape, gap);
    }

    public float SumOfDistances()
    {
        float sum = 0;
        for (int i = 0; i < Poses.Length; i++) sum += Distance(i);
        return sum;
    }

    public float CountOfOverlaps()
    {
        int count = 0;
        foreach (RigidPose pose in Poses)
            count += ConcaveQuery.Overlaps(A, RigidPose.Identity, B, pose, _scratch) ? 1 : 0;
        return count;
    }

    public float Distance(int pose) =>
        ConcaveQuery.Distance(A, RigidPose.Identity, B, Poses[pose], _scratch).Distance;

    /// <summary>Turned at random, and moved towards A until the gap is left.</summary>
    private static ConcaveScene Placed(in AnyShape a, in AnyShape b, float gap)
    {
        var scene = new ConcaveScene(a, b, 3);
        var rng = new Prng(31);
        scene.Poses = new RigidPose[Count];
        for (int i = 0; i < Count; i++)
        {
            Quaternion turn = rng.Rotation();
            Vector3 way = rng.UnitVector();
            float along = 12;
            for (int round = 0; round < 200; round++)
            {
                scene.Poses[i] = new RigidPose(turn, way * along);
                float left = scene.Distance(i) - Math.Max(gap, 1e-4f);
                if (left <= 1e-3f * Math.Abs(gap)) break;
                along -= left;
            }

            if (gap < 0) scene.Poses[i] = new RigidPose(turn, way * (along + gap));
        }

        return scene;
    }

    /// <summary>Two flat grids, from flush to a millionth apart.</summary>
    private static ConcaveScene Plates()
    {
        const int Cells = 223;
        TriangleSoup grid = Surfaces.Sheet(
            Cells, Cells, (i, j) => new Vector3(2 * (i / (float)Cells) - 1, 0, 2 * (j / (float)Cells) - 1));
        var plate = AnyShape.Surface(grid.Build());
        return new ConcaveScene(plate, plate, 2)
        {
            Poses = [.. Enumerable.Range(0, Count).Select(i => new RigidPose(new Vector3(0.01f * i, i * 1e-6f, 0)))],
        };
    }

    private static TriangleMesh Torus(int triangles) => Ring(triangles, (u, v) =>
    {
        double a = 2 * Math.PI * u, b = 2 * Math.PI * v, r = 1 + 0.35 * Math.Cos(b);
        return new Vector3((float)(r * Math.Cos(a)), (float)(0.35 * Math.Sin(b)), (float)(r * Math.Sin(a)));
    });

    private static TriangleMesh Bumpy(int triangles) => Ring(triangles, (u, v) =>
    {
        double a = 2 * Math.PI * u, b = Math.PI * (v * 0.98 + 0.01);
        double r = 1 + 0.08 * Math.Sin(9 * a) * Math.Sin(11 * b);
        return new Vector3(
            (float)(r * Math.Sin(b) * Math.Cos(a)), (float)(r * Math.Cos(b)),
            (float)(r * Math.Sin(b) * Math.Sin(a)));
    });

    /// <summary>A grid over the unit square, twice as many cells along u as along v, closed along u.</summary>
    private static TriangleMesh Ring(int triangles, Func<float, float, Vector3> at)
    {
        int across = (int)Math.Sqrt(triangles / 4.0), around = 2 * across;
        return Surfaces.Sheet(
            around, across, (i, j) => at(i / (float)around, j / (float)across), closesAround: true).Build();
    }
}
