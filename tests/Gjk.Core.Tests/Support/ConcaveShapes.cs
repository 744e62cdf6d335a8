namespace Gjk.Core.Tests.Support;

/// <summary>Meshes and compounds that are not convex, and what single queries say of all their parts.</summary>
internal static class ConcaveShapes
{
    public static TriangleMesh Torus(int around, int across, float radius = 1, float tube = 0.35f) =>
        Surfaces.Torus(around, across, radius, tube).Build();

    /// <inheritdoc cref="Surfaces.Grid"/>
    public static TriangleMesh Grid(int n, Func<float, float, float>? height = null) =>
        Surfaces.Grid(n, height).Build();

    /// <inheritdoc cref="Surfaces.Box"/>
    public static TriangleMesh Box(Vector3 half) => Surfaces.Box(half).Build();

    /// <inheritdoc cref="Surfaces.Soup"/>
    public static TriangleMesh Soup(Rng random, int count, double size) =>
        Surfaces.Soup(random, count, size).Build();

    public static CompoundShape Compound(Rng random, int count)
    {
        var parts = new CompoundPart[count];
        for (int i = 0; i < count; i++)
        {
            var pose = new RigidPose(random.Rotation(), random.Vector(1));
            float size = random.Float(0.05f, 0.2f);
            parts[i] = new CompoundPart(
                random.Below(5) switch
                {
                    0 => ConvexShape.Sphere(size),
                    1 => ConvexShape.Capsule(size, size),
                    2 => ConvexShape.Box(new Vector3(size, size / 2, size / 4)),
                    3 => ConvexShape.Triangle(random.Vector(size), random.Vector(size), random.Vector(size)),
                    _ => ConvexShape.Mesh([.. RandomPoints(random, 12, size)]),
                }, pose);
        }

        return new CompoundShape(parts);
    }

    /// <summary>A compound of convex shapes, surfaces and compounds.</summary>
    /// <param name="random">What draws it.</param>
    /// <param name="depth">How many compounds may be in each other.</param>
    /// <param name="parts">To which each part is added as a shape of its own, placed once for each compound around
    /// it.</param>
    /// <param name="children">To which is added of which child a part is, and which of it.</param>
    public static CompoundShape Nested(
        Rng random, int depth, List<ConvexShape> parts, List<(int Child, int Part)>? children = null)
    {
        var list = new CompoundPart[1 + random.Below(4)];
        for (int i = 0; i < list.Length; i++)
        {
            RigidPose pose = random.OneIn(4) ? RigidPose.Identity : Pose(random, 0.6);
            AnyShape shape = Child(random, depth, out List<ConvexShape> own);
            list[i] = new CompoundPart(shape, pose);
            for (int part = 0; part < own.Count; part++)
            {
                parts.Add(own[part].Placed(pose));
                children?.Add((i, part));
            }
        }

        return new CompoundShape(list);
    }

    private static AnyShape Child(Rng random, int depth, out List<ConvexShape> parts)
    {
        if (depth > 0 && random.OneIn(2))
        {
            parts = [];
            CompoundShape nested = Nested(random, depth - 1, parts);
            if (random.OneIn(2)) return AnyShape.Of(nested);
            Vector3 scale = random.Factors(0.5, 1.5);
            parts = parts.ConvertAll(part => part.Scaled(scale));
            return AnyShape.Of(nested.Scaled(scale));
        }

        AnyShape shape = random.Below(4) switch
        {
            0 => AnyShape.Surface(Soup(random, random.Of(1, 5, 12), 0.3)),
            1 => AnyShape.Surface(Torus(4, 3).Scaled(random.Factors(0.2, 0.6))),
            2 => AnyShape.Of(ConvexShape.Capsule(0.1f, 0.2f)),
            _ => AnyShape.Of(ConvexShape.Box(random.Vector(0.1) + new Vector3(0.2f)).Rounded(random.Of(0, 0.05f))),
        };
        parts = Parts(shape);
        return shape;
    }

    /// <summary>Any of the kinds.</summary>
    public static AnyShape Any(Rng random) => random.Below(6) switch
    {
        0 => AnyShape.Surface(Soup(random, random.Of(1, 3, 20, 60), random.Magnitude(0.02, 0.5))),
        1 => AnyShape.Surface(Torus(random.Of(4, 9), random.Of(3, 7))),
        2 => AnyShape.Surface(Torus(7, 5).Scaled(random.Factors(0.3, 3))),
        3 => AnyShape.Of(Compound(random, random.Of(1, 2, 9, 20))),
        4 => AnyShape.Of(Compound(random, 5).Scaled(random.Factors(0.5, 2))),
        _ => AnyShape.Of(ConvexShape.Box(new Vector3(0.3f, 0.2f, 0.1f)).Rounded(random.Of(0, 0.1f))),
    };

    public static RigidPose Pose(Rng random, double reach) => new(Rotations.Any(random), random.Vector(reach));

    /// <summary>The parts as they were given, each as a convex shape of its own.</summary>
    public static List<ConvexShape> Parts(in AnyShape shape)
    {
        var parts = new List<ConvexShape>();
        if (shape.Mesh is { } mesh)
        {
            for (int i = 0; i < mesh.TriangleCount; i++)
            {
                mesh.GetTriangle(i, out int a, out int b, out int c);
                var triangle = ConvexShape.Triangle(mesh.GetVertex(a), mesh.GetVertex(b), mesh.GetVertex(c));
                parts.Add(mesh.Scale == Vector3.One ? triangle : triangle.Scaled(mesh.Scale));
            }
        }
        else if (shape.Compound is { } compound)
        {
            for (int i = 0; i < compound.PartCount; i++) parts.Add(compound.GetPart(i));
        }
        else
        {
            parts.Add(shape.Convex);
        }

        return parts;
    }

    private static IEnumerable<Vector3> RandomPoints(Rng random, int count, double size)
    {
        for (int i = 0; i < count; i++) yield return random.Vector(size);
    }
}
