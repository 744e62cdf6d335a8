namespace Gjk.Bench.Scenes;

/// <summary>Draws the pairs of <see cref="CastPairs"/>. Every method gets what is drawn once for a set, and returns
/// what adds a pair.</summary>
internal static class CastSets
{
    /// <summary>As many hulls as a set for distances draws from.</summary>
    private const int Pool = 64;

    /// <summary>How far apart bodies of about unit size begin, at most.</summary>
    private const float Apart = 3;

    public static Action<CastScene> Boxes(Prng prng) => scene => Aim(scene, prng, Box(prng), Box(prng), Apart);

    public static Action<CastScene> Hulls(Prng prng, int vertices)
    {
        DepthBody[] pool = PoolOf(() => Hull(prng, vertices));
        return scene => Aim(scene, prng, prng.OneOf<DepthBody>(pool), prng.OneOf<DepthBody>(pool), Apart);
    }

    public static Action<CastScene> Grazes(Prng prng)
    {
        DepthBody[] pool = PoolOf(() => Solid(prng));
        return scene =>
        {
            float gap = prng.OneOf(1e-7f, 1e-6f, 1e-5f, 1e-4f, 1e-3f) * prng.OneOf(-1, 1);
            new CastCourse(prng, prng.OneOf<DepthBody>(pool), prng.OneOf<DepthBody>(pool)).Pass(scene, prng, gap);
        };
    }

    /// <summary>Equally turned boxes with a face in one plane, or nearly. B slides over A's face from beside it, or
    /// begins on it, or slides in the plane of A's side until it meets a face across its way.</summary>
    public static Action<CastScene> Slides(Prng prng) => scene =>
    {
        Vector3 a = prng.OneOf(new Vector3(4, 0.25f, 1), new Vector3(2, 0.5f, 2), new Vector3(0.5f));
        Vector3 b = prng.OneOf(new Vector3(0.5f), new Vector3(0.25f, 1, 0.5f), new Vector3(1, 0.25f, 1)), sum = a + b;
        Quaternion rotation = prng.OneOf(Quaternion.Identity, new Quaternion(0.5f, 0.5f, 0.5f, 0.5f), prng.Rotation());
        float gap = prng.OneOf(0, 1e-7f, -1e-7f, 1e-6f, -1e-6f, 1e-4f, -1e-4f, 1e-2f);
        float beside = prng.Range(0.1f, 2), along = prng.Range(-0.9f, 0.9f), side = prng.OneOf(-1, 1);
        (Vector3 start, Vector3 way) = prng.Index(3) switch
        {
            0 => (new Vector3(-sum.X - beside, side * (sum.Y + gap), along * sum.Z), new Vector3(10, 0, 0)),
            1 => (new Vector3(along * sum.X, side * (sum.Y + Math.Max(gap, 0)), 0), new Vector3(0, 0, 6)),
            _ => (new Vector3(-sum.X - beside, side * (a.Y - b.Y + gap), along * sum.Z), new Vector3(8, 0, 0)),
        };
        var turn = new RotationD(rotation);
        new CastCourse(DepthBody.Box(a), rotation, DepthBody.Box(b), rotation).Add(
            scene, turn.Rotate((Double3)start), turn.Rotate((Double3)way));
    };

    /// <summary>B begins in A, by 1e-5 to 0.4.</summary>
    public static Action<CastScene> Insides(Prng prng)
    {
        DepthBody[] pool = PoolOf(() => Solid(prng));
        return scene =>
        {
            DepthBody a = prng.OneOf<DepthBody>(pool), b = prng.OneOf<DepthBody>(pool);
            float depth = prng.OneOf(1e-5f, 1e-3f, 0.1f, 0.4f);
            new CastCourse(prng, a, b).Sink(scene, prng, depth, prng.OneOf(0.01f, 0.1f, 1, 7));
        };
    }

    /// <summary>A third passes by, a third stops short, and a third goes away.</summary>
    public static Action<CastScene> Misses(Prng prng)
    {
        DepthBody[] pool = PoolOf(() => Solid(prng));
        return scene =>
        {
            var course = new CastCourse(prng, prng.OneOf<DepthBody>(pool), prng.OneOf<DepthBody>(pool));
            switch (prng.Index(3))
            {
                case 0:
                    course.Pass(scene, prng, prng.Range(0.05f, 1));
                    break;
                case 1:
                    float gap = prng.Range(0.1f, 3);
                    course.Drop(scene, prng, gap, gap * prng.Range(0.1f, 0.9f));
                    break;
                default:
                    course.Drop(scene, prng, prng.Range(0.1f, 3), -prng.Range(0.1f, 10));
                    break;
            }
        };
    }

    /// <summary>A quarter each from 1e3 and 1e5 away, a way of 1e-5 to 1e-4 onto each other, and a way of 1e6 from
    /// nearby.</summary>
    public static Action<CastScene> Speeds(Prng prng)
    {
        DepthBody[] pool = PoolOf(() => Solid(prng));
        return scene =>
        {
            var course = new CastCourse(prng, prng.OneOf<DepthBody>(pool), prng.OneOf<DepthBody>(pool));
            switch (prng.Index(4))
            {
                case 0:
                    course.Aim(scene, prng, 0, 1e3f, 2);
                    break;
                case 1:
                    course.Aim(scene, prng, 0, 1e5f, 2);
                    break;
                case 2:
                    course.Drop(scene, prng, prng.Range(1e-5f, 3e-5f), prng.Range(5e-5f, 1e-4f));
                    break;
                default:
                    course.Drop(scene, prng, prng.Range(0.1f, 1), prng.Range(1e5f, 1e6f));
                    break;
            }
        };
    }

    /// <summary>Points at shapes of every kind. A tenth begins inside.</summary>
    public static Action<CastScene> Rays(Prng prng)
    {
        DepthBody point = DepthBody.Sphere(0);
        DepthBody[] hulls = PoolOf(() => DepthBody.Hull(prng, prng.OneOf(8, 32), Vector3.One));
        return scene =>
        {
            DepthBody target = prng.Index(5) switch
            {
                0 => Box(prng),
                1 => prng.OneOf<DepthBody>(hulls),
                2 => DepthBody.Sphere(prng.Range(0.3f, 1)),
                3 => DepthBody.Capsule(prng.Range(0.2f, 0.6f), prng.Range(0.1f, 0.8f)),
                _ => DepthBody.Curved(ConvexShape.Cylinder(prng.Range(0.3f, 1), prng.Range(0.2f, 1))),
            };
            var course = new CastCourse(prng, target, point);
            if (prng.Index(10) == 0) course.Add(scene, default, 5 * prng.UnitVector());
            else course.Aim(scene, prng, prng.Range(0, 2), Apart, prng.Range(1.2f, 3));
        };
    }

    public static Action<CastScene> Rounds(Prng prng)
    {
        DepthBody[] pool = PoolOf(() => Solid(prng));
        return scene =>
        {
            DepthBody a = RoundBody(prng), b = prng.Index(2) == 0 ? RoundBody(prng) : prng.OneOf<DepthBody>(pool);
            if (prng.Index(2) == 0) (a, b) = (b, a);
            Aim(scene, prng, a, b, Apart);
        };
    }

    /// <summary>Plates, rods and spikes of 1:1000 to 1:10,000, and crumbs as small as those are thin.</summary>
    public static Action<CastScene> Thins(Prng prng)
    {
        DepthBody[] thin =
        [
            DepthBody.Box(new Vector3(5, 5, 5e-4f)), DepthBody.Box(new Vector3(50, 0.05f, 0.05f)),
            DepthBody.Box(new Vector3(50, 50, 0.05f)), DepthBody.Hull(prng, 24, new Vector3(50, 0.05f, 0.05f)),
            DepthBody.Hull(prng, 24, new Vector3(50, 50, 0.05f)),
        ];
        DepthBody[] all =
        [
            .. thin, DepthBody.Box(new Vector3(0.005f)), DepthBody.Box(new Vector3(0.5f)),
            DepthBody.Hull(prng, 16, Vector3.One),
        ];
        return scene =>
        {
            DepthBody a = prng.OneOf<DepthBody>(thin), b = prng.OneOf<DepthBody>(all);
            if (prng.Index(2) == 0) (a, b) = (b, a);
            Aim(scene, prng, a, b, Apart);
        };
    }

    /// <summary>At a point inside A, so that they meet.</summary>
    private static void Aim(CastScene scene, Prng prng, DepthBody a, DepthBody b, float apart) =>
        new CastCourse(prng, a, b).Aim(scene, prng, prng.Range(0, 0.7f), apart, prng.Range(1.2f, 2.5f));

    private static DepthBody[] PoolOf(Func<DepthBody> draw)
    {
        var pool = new DepthBody[Pool];
        for (int i = 0; i < pool.Length; i++) pool[i] = draw();
        return pool;
    }

    private static DepthBody Box(Prng prng) => DepthBody.Box(RandomVector(prng));

    private static DepthBody Hull(Prng prng, int vertices) => DepthBody.Hull(prng, vertices, RandomVector(prng));

    /// <summary>A box or a hull of 8 to 32 corners.</summary>
    private static DepthBody Solid(Prng prng) =>
        prng.Index(2) == 0 ? Box(prng) : Hull(prng, prng.OneOf(8, 16, 32));

    private static DepthBody RoundBody(Prng prng) => prng.Index(2) == 0
        ? DepthBody.Sphere(prng.Range(0.2f, 0.7f))
        : DepthBody.Capsule(prng.Range(0.2f, 0.6f), prng.Range(0.1f, 0.8f));

    private static Vector3 RandomVector(Prng prng) =>
        new(prng.Range(0.3f, 1), prng.Range(0.3f, 1), prng.Range(0.3f, 1));
}
