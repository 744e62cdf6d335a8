namespace Gjk.Exact.Scenes;

/// <summary>One of the report's two scenes, or a scene of the same kind. The objects are copies of one mesh of unit
/// size, each with its own pose.</summary>
public sealed class BuiltInScene
{
    internal BuiltInScene(string name, string objectName, Vector3[] vertices, RigidPose[] poses, in Aabb room)
    {
        Room = room;
        Name = name;
        Vertices = vertices;
        Poses = poses;
        var names = new string[poses.Length];
        for (int i = 0; i < names.Length; i++) names[i] = $"{objectName} ({i + 1})";
        ObjectNames = names;
    }

    /// <summary>"cubes" or "spheres".</summary>
    public string Name { get; }

    /// <summary>The mesh as given, before deduplication.</summary>
    public IReadOnlyList<Vector3> Vertices { get; }

    /// <summary>The positions and rotations of the objects.</summary>
    public IReadOnlyList<RigidPose> Poses { get; }

    /// <summary>The box that the objects' centres do not leave when they move.</summary>
    public Aabb Room { get; }

    /// <summary>The names of the objects, in the order of <see cref="Poses"/>.</summary>
    public IReadOnlyList<string> ObjectNames { get; }
}

/// <summary>Generates the report's experiment: 20 objects of unit size in pseudo-random orientations, of which exactly
/// five pairs overlap. It also generates the same kind of scene with any number of objects, placed anywhere in a cubic
/// room where about half of them touch another, as in the report's. It only uses additions, multiplications, divisions
/// and square roots, whose rounding IEEE 754 defines. So the bits are the same on every machine.</summary>
public static class BuiltInScenes
{
    /// <summary>Objects in a scene of the report. Each grid has half of them.</summary>
    public const int ObjectCount = Columns * 2 * 2;

    /// <summary>How many pairs of a report scene overlap: one per column of the upper grid.</summary>
    public const int OverlappingPairs = Columns;

    private const int Columns = 5;

    /// <summary>Units. The distance between neighbours that must not touch. It is more than twice the 0.866 from a unit
    /// cube's centre to its corner.</summary>
    private const float Apart = 2f;

    /// <summary>Units. The distance between the two objects of a column of the upper grid. It is less than twice 0.49,
    /// the radius of a ball that fits into the coarsest of the shapes. So the two overlap in any orientation.</summary>
    private const float Close = 0.75f;

    /// <summary>Units. The height of the upper grid. It keeps clear of the lower grid for the same reason as
    /// <see cref="Apart"/>.</summary>
    private const float UpperHeight = 2.25f;

    /// <summary>Units. The radius of the spheres, and half the side of the cubes.</summary>
    private const float Half = 0.5f;

    /// <summary>Cubic units. The volume in which one unit cube's centre lies when it touches another cube and both are
    /// turned at random. This is the mean volume of their Minkowski sum, V + V' + (S M' + S' M) / 4 pi, with the volume
    /// 1, the surface 6 and the mean curvature 3 pi (Schneider and Weil 2008, section 6.1).</summary>
    private const double CubeContactVolume = 11;

    /// <summary>Cubic units. The volume of a ball of twice the radius. The polyhedron's volume is one percent
    /// less.</summary>
    private const double SphereContactVolume = 4.0 / 3 * Math.PI;

    /// <summary>A box around the centres of both grids, with a margin of the distance between neighbours.</summary>
    private static readonly Aabb GridRoom =
        new(new Vector3(-Apart), new Vector3(Columns * Apart, UpperHeight + Apart, 2 * Apart));

    private const ulong CubeSeed = 0x43_75_62_65_73;
    private const ulong SphereSeed = 0x53_70_68_65_72_65_73;

    /// <summary>Cubes of 24 vertices. Each corner appears once for each of its three faces, as in an engine's
    /// mesh.</summary>
    public static BuiltInScene Cubes() => new("cubes", "Cube", CubeMesh(), GridPoses(CubeSeed), GridRoom);

    /// <summary>The same cubes in any number.</summary>
    public static BuiltInScene Cubes(int objects)
    {
        Aabb room = RoomFor(objects, CubeContactVolume);
        return new("cubes", "Cube", CubeMesh(), PosesIn(room, objects, CubeSeed), room);
    }

    /// <summary>Spheres. Each distinct vertex is a corner of the hull.</summary>
    public static BuiltInScene Spheres(SphereMesh mesh = SphereMesh.Even) =>
        new("spheres", "Sphere", SphereMeshes.Vertices(mesh, Half), GridPoses(SphereSeed), GridRoom);

    /// <summary>The same spheres in any number.</summary>
    public static BuiltInScene Spheres(int objects, SphereMesh mesh = SphereMesh.Even)
    {
        Aabb room = RoomFor(objects, SphereContactVolume);
        return new(
            "spheres", "Sphere", SphereMeshes.Vertices(mesh, Half), PosesIn(room, objects, SphereSeed), room);
    }

    private static Vector3[] CubeMesh()
    {
        var vertices = new List<Vector3>();
        for (int axis = 0; axis < 3; axis++)
        {
            for (int corner = 0; corner < 8; corner++)
            {
                // The bits of the corner. The axis of the face comes first, so that each face's four corners are
                // neighbours in the list.
                float along = (corner & 4) == 0 ? -Half : Half;
                float u = (corner & 2) == 0 ? -Half : Half, v = (corner & 1) == 0 ? -Half : Half;
                vertices.Add(axis switch { 0 => new(along, u, v), 1 => new(v, along, u), _ => new(u, v, along) });
            }
        }

        return vertices.ToArray();
    }

    private static RigidPose[] GridPoses(ulong seed)
    {
        var random = new Rng(seed);
        var poses = new RigidPose[ObjectCount];
        for (int i = 0; i < poses.Length; i++)
        {
            bool upper = i >= poses.Length / 2;
            int column = i % (poses.Length / 2) / 2, row = i % 2;
            var position = new Vector3(column * Apart, upper ? UpperHeight : 0, row * (upper ? Close : Apart));
            poses[i] = new RigidPose(random.Rotation(), position);
        }

        return poses;
    }

    /// <summary>Poses with uniformly distributed positions in the room.</summary>
    private static RigidPose[] PosesIn(in Aabb room, int count, ulong seed)
    {
        var random = new Rng(seed);
        var poses = new RigidPose[count];
        Vector3 middle = (room.Min + room.Max) / 2, half = (room.Max - room.Min) / 2;
        for (int i = 0; i < poses.Length; i++)
        {
            var place = new Vector3(
                (float)random.Signed(), (float)random.Signed(), (float)random.Signed());
            poses[i] = new RigidPose(random.Rotation(), middle + half * place);
        }

        return poses;
    }

    /// <summary>A cubic room in which half of the objects have no other object's centre in their contact volume. The
    /// objects are treated as a Poisson process, which needs ln 2 centres per contact volume.</summary>
    private static Aabb RoomFor(int objects, double contactVolume)
    {
        const double Ln2 = 0.6931471805599453;
        return new Aabb(Vector3.Zero, new Vector3((float)CubeRoot(objects * contactVolume / Ln2)));
    }

    /// <summary>Newton's method, starting from above. Math.Cbrt of two machines may differ in the last bit.</summary>
    private static double CubeRoot(double x)
    {
        // Each step removes a third. So 60 steps lead from any number of objects to about its root, and a few more give
        // all digits.
        const int NewtonSteps = 100;
        double root = Math.Max(x, 1);
        for (int step = 0; step < NewtonSteps; step++) root = (2 * root + x / (root * root)) / 3;
        return root;
    }
}
