namespace Gjk.Bench.Scenes;

/// <summary>Draws the pairs of <see cref="DepthPairs"/>. Every method gets what is drawn once for a set, and returns
/// what adds a pair.</summary>
internal static class DepthSets
{
    /// <summary>As many hulls as a set for distances draws from.</summary>
    private const int Pool = 64;

    /// <summary>The largest share of the way from the middle to the surface at which the middle of another body lies in
    /// deep pairs.</summary>
    private const float DeepShare = 0.35f;

    /// <summary>What a thin body is divided by on its short sides.</summary>
    private const float Thinness = 0.001f;

    public static Action<BenchScene> ShallowBoxes(Prng prng) => scene =>
    {
        DepthBody a = Box(prng), b = Box(prng);
        DepthContact contact = prng.Index(3) switch
        {
            0 => DepthContact.AtFace(prng, a, b),
            1 => DepthContact.AtEdges(prng, a, b),
            _ => DepthContact.AtCorners(prng, a, b),
        };
        Add(scene, contact.Sunk(prng.OneOf(1e-6f, 1e-5f, 1e-4f, 1e-3f) * prng.Range(1, 10)));
    };

    public static Action<BenchScene> DeepBoxes(Prng prng) => scene => Add(scene, Deep(prng, Box(prng), Box(prng)));

    /// <summary>Equally turned boxes, face to face. Along each of the other axes they are centred, off by a part, flush
    /// on one side, or overlap no deeper than on the first: then they meet at an edge or a corner.</summary>
    public static Action<BenchScene> FlushBoxes(Prng prng) => scene =>
    {
        Vector3 a = FlushHalf(prng), b = FlushHalf(prng), sum = a + b;
        float depth = prng.OneOf(1e-5f, 1e-4f, 1e-3f, 1e-2f) * prng.Range(1, 10);
        float Off(float halfA, float halfB) => prng.Index(4) switch
        {
            0 => 0,
            1 => prng.Range(0.1f, 0.9f) * (halfA + halfB),
            2 => halfA - halfB,
            _ => halfA + halfB - depth,
        };
        Vector3 offset = prng.Index(3) switch
        {
            0 => new Vector3(sum.X - depth, Off(a.Y, b.Y), Off(a.Z, b.Z)),
            1 => new Vector3(Off(a.X, b.X), sum.Y - depth, Off(a.Z, b.Z)),
            _ => new Vector3(Off(a.X, b.X), Off(a.Y, b.Y), sum.Z - depth),
        };
        Quaternion rotation = prng.OneOf(Quaternion.Identity, new Quaternion(0.5f, 0.5f, 0.5f, 0.5f), prng.Rotation());
        int first = scene.Add(ConvexShape.Box(a), new RigidPose(rotation, Vector3.Zero));
        var position = (Vector3)new RotationD(rotation).Rotate(offset);
        scene.AddPair(first, scene.Add(ConvexShape.Box(b), new RigidPose(rotation, position)));
    };

    /// <summary>Hulls on ellipsoids that are up to twice as long as wide.</summary>
    public static Action<BenchScene> Hulls(Prng prng, int vertices)
    {
        DepthBody[] pool = PoolOf(() => DepthBody.Hull(prng, vertices, RandomVector(prng, 0.5f, 1)));
        return scene =>
        {
            DepthBody a = prng.OneOf<DepthBody>(pool), b = prng.OneOf<DepthBody>(pool);
            Add(scene, prng.Index(3) switch
            {
                0 => DepthContact.AtFace(prng, a, b).Sunk(prng.OneOf(1e-4f, 1e-3f, 1e-2f) * prng.Range(1, 5)),
                1 => DepthContact.AtFace(prng, a, b).Sunk(prng.Range(0.05f, 0.3f)),
                _ => Deep(prng, a, b),
            });
        };
    }

    /// <summary>Half of them cross at points inside, the others meet at a face.</summary>
    public static Action<BenchScene> Needles(Prng prng)
    {
        DepthBody[] thin =
        [
            DepthBody.Box(new Vector3(50, 0.05f, 0.05f)), DepthBody.Box(new Vector3(50, 50, 0.05f)),
            DepthBody.Hull(prng, 24, new Vector3(50, 50 * Thinness, 50 * Thinness)),
            DepthBody.Hull(prng, 24, new Vector3(50, 50, 50 * Thinness)),
            Spike(10, 1e-3f), Spike(100, 0.08f),
        ];
        DepthBody[] all = [.. thin, DepthBody.Box(new Vector3(0.5f)), DepthBody.Hull(prng, 16, Vector3.One)];
        return scene =>
        {
            DepthBody a = prng.OneOf<DepthBody>(thin), b = prng.OneOf<DepthBody>(all);
            DepthContact contact = prng.Index(2) == 0
                ? DepthContact.Inside(prng, a, b, 0.9f, 0.9f)
                : DepthContact.AtFace(prng, a, b).Sunk(prng.OneOf(1e-2f, 1e-1f) * prng.Range(1, 10));
            contact.AddTo(scene, Vector3.Zero, prng.Index(2) == 0);
        };
    }

    public static Action<BenchScene> Nested(Prng prng) => scene =>
    {
        DepthBody outer = Solid(prng, 1), inner = Solid(prng, prng.OneOf(1e-3f, 1e-2f, 0.1f, 0.5f));
        DepthContact contact = DepthContact.Inside(prng, outer, inner, 0.15f, 0);
        contact.AddTo(scene, Vector3.Zero, prng.Index(2) == 0);
    };

    /// <summary>Half of the pairs are equally turned and off by 1e-7 to 0.1, along an axis or a diagonal. The others
    /// have the same place and are turned not at all, by 1e-6 to 1e-2, or in any way.</summary>
    public static Action<BenchScene> Concentric(Prng prng)
    {
        ConvexShape[] shapes = ConcentricShapes(prng);
        return scene =>
        {
            ConvexShape shape = prng.OneOf<ConvexShape>(shapes);
            Quaternion first = prng.Rotation(), second = first;
            Vector3 position = Vector3.Zero;
            if (prng.Index(2) == 0)
            {
                Vector3 course =
                    prng.OneOf(Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ, new Vector3(1, 1, 0), Vector3.One);
                position = course * prng.OneOf(1e-7f, 1e-5f, 1e-3f, 0.1f);
            }
            else
            {
                var little = new Quaternion(prng.UnitVector() * prng.OneOf(0f, 1e-6f, 1e-4f, 1e-2f), 1);
                second = prng.Index(2) == 0 ? Quaternion.Normalize(little * first) : prng.Rotation();
            }

            int a = scene.Add(shape, new RigidPose(first, Vector3.Zero));
            scene.AddPair(a, scene.Add(shape, new RigidPose(second, position)));
        };
    }

    public static Action<BenchScene> Ratio(Prng prng)
    {
        DepthBody[] small = PoolOf(() => Solid(prng, 1));
        DepthBody[] large = PoolOf(() => Large(prng, prng.OneOf(1e3f, 1e4f)));
        return scene =>
        {
            DepthBody a = prng.OneOf<DepthBody>(large), b = prng.OneOf<DepthBody>(small);
            DepthContact contact = prng.Index(2) == 0
                ? DepthContact.AtFace(prng, a, b)
                : DepthContact.AtCorners(prng, a, b);
            contact.Sunk(prng.Range(0.01f, 0.2f)).AddTo(scene, Vector3.Zero, prng.Index(2) == 0);
        };
    }

    /// <summary>Their positions are 1/128 apart there, so that shallower pairs cannot be placed.</summary>
    public static Action<BenchScene> Far(Prng prng) => scene =>
    {
        DepthBody a = Solid(prng, 1), b = Solid(prng, 1);
        DepthContact contact = prng.Index(2) == 0
            ? DepthContact.AtFace(prng, a, b)
            : DepthContact.AtCorners(prng, a, b);
        contact.Sunk(prng.Range(0.02f, 0.2f)).AddTo(scene, 1e5f * prng.UnitVector(), false);
    };

    public static Action<BenchScene> Round(Prng prng) => scene =>
    {
        DepthBody a = prng.Index(2) == 0 ? RoundBody(prng) : Solid(prng, 1), b = RoundBody(prng);
        DepthContact contact = prng.Index(6) switch
        {
            0 or 1 => DepthContact.AtFace(prng, a, b).Sunk(prng.OneOf(1e-6f, 1e-5f, 1e-4f, 1e-3f) * prng.Range(1, 5)),
            2 or 3 => DepthContact.AtFace(prng, a, b).Sunk(prng.Range(0.03f, 0.1f)),
            4 => DepthContact.AtFace(prng, a, b).Sunk(prng.Range(0.3f, 0.5f)),
            _ => Deep(prng, a, b),
        };
        contact.AddTo(scene, Vector3.Zero, prng.Index(2) == 0);
    };

    private static void Add(BenchScene scene, in DepthContact contact) => contact.AddTo(scene, Vector3.Zero, false);

    private static DepthContact Deep(Prng prng, DepthBody a, DepthBody b) =>
        DepthContact.Inside(prng, a, b, DeepShare, 0);

    private static DepthBody[] PoolOf(Func<DepthBody> draw)
    {
        var pool = new DepthBody[Pool];
        for (int i = 0; i < pool.Length; i++) pool[i] = draw();
        return pool;
    }

    private static Vector3 RandomVector(Prng prng, float low, float high) =>
        new(prng.Range(low, high), prng.Range(low, high), prng.Range(low, high));

    private static DepthBody Box(Prng prng) => DepthBody.Box(RandomVector(prng, 0.3f, 1));

    private static Vector3 FlushHalf(Prng prng) =>
        prng.OneOf(new Vector3(0.5f), new Vector3(1.5f, 2, 1), new Vector3(2, 1, 0.5f));

    /// <summary>A box or a hull of 8 to 32 corners.</summary>
    private static DepthBody Solid(Prng prng, float size) => prng.Index(2) == 0
        ? DepthBody.Box(size * RandomVector(prng, 0.3f, 1))
        : DepthBody.Hull(prng, prng.OneOf(8, 16, 32), new Vector3(size));

    /// <summary>As a solid, or a plate of thickness 2.</summary>
    private static DepthBody Large(Prng prng, float size) =>
        prng.Index(4) == 0 ? DepthBody.Box(new Vector3(size, size, 1)) : Solid(prng, size);

    private static DepthBody RoundBody(Prng prng) => prng.Index(2) == 0
        ? DepthBody.Sphere(prng.Range(0.2f, 0.5f))
        : DepthBody.Capsule(prng.Range(0.2f, 0.5f), prng.Range(0.1f, 0.8f));

    /// <summary>A long tetrahedron.</summary>
    private static DepthBody Spike(float length, float width) => DepthBody.Mesh(
        [Vector3.Zero, new(length, 0, 0), new(0.5f * length, width, 0), new(0.5f * length, 0, width)]);

    private static ConvexShape[] ConcentricShapes(Prng prng)
    {
        Vector3[] cube = MeshVertices.Box(new Vector3(0.5f)), octahedron =
            [Vector3.UnitX, -Vector3.UnitX, Vector3.UnitY, -Vector3.UnitY, Vector3.UnitZ, -Vector3.UnitZ];
        return
        [
            ConvexShape.Box(new Vector3(0.5f)), ConvexShape.Box(new Vector3(1, 0.75f, 0.5f)),
            ConvexShape.Box(new Vector3(1, 1, 0.1f)), ConvexShape.Mesh(MeshVertices.Cube(0.5f)),
            ConvexShape.Mesh([cube[0], cube[3], cube[5], cube[6]]), ConvexShape.Mesh(octahedron),
            ConvexShape.Mesh(MeshVertices.Sphere(1, rings: 3, perRing: 8)),
            ConvexShape.Mesh(MeshVertices.OnEllipsoid(prng, 8, Vector3.One)),
            ConvexShape.Mesh(MeshVertices.OnEllipsoid(prng, 32, Vector3.One)),
        ];
    }
}
