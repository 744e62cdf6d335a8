namespace Gjk.Exact.Fuzz.Families;

/// <summary>Pairs whose difficulty is in their numbers: sizes, distances from an origin, or how many corners there
/// are.</summary>
internal static class SizeFamilies
{
    /// <summary>One shape up to a million times larger than the other, in contact or nearly.</summary>
    public static FuzzPair SizesApart(Rng random)
    {
        FuzzShape a = Shapes.Polytope(random), b = Polytope(random, (float)random.Magnitude(1e-6, 1e-1));
        if (random.OneIn(2)) (a, b) = (b, a);
        var poseA = new RigidPose(Rotations.Any(random), random.OneIn(2) ? Vector3.Zero : random.Vector(1));
        double gap = random.Sign() * random.Magnitude(1e-9, 1);
        return Placement.Gap(a, poseA, b, Rotations.Any(random), random.Direction(), gap);
    }

    /// <summary>Both of a size from 1e-15 to 1e15.</summary>
    public static FuzzPair TinyAndHuge(Rng random)
    {
        float size = (float)random.Magnitude(1e-15, 1e15);
        FuzzShape a = Polytope(random, size);
        FuzzShape b = random.OneIn(4) ? Shapes.Curved(random, size) : Polytope(random, size);
        var poseA = new RigidPose(Rotations.Any(random), random.Vector(1) * size);
        if (random.OneIn(2))
            return Placement.Gap(
                a, poseA, b, Rotations.Any(random), random.Direction(), Placement.AnyGap(random) * size);
        return Placement.Meeting(random, a, poseA, b);
    }

    /// <summary>Up to 1e5 from the origin, near each other.</summary>
    public static FuzzPair FarAway(Rng random)
    {
        FuzzShape a = Shapes.Any(random), b = Shapes.Any(random);
        var poseA = new RigidPose(Rotations.Any(random), (Vector3)(random.Direction() * random.Magnitude(1e3, 1e5)));
        if (random.OneIn(2))
            return Placement.Gap(
                a, poseA, b, Rotations.Any(random), random.Direction(), random.Sign() * random.Magnitude(1e-3, 1));
        return Placement.Meeting(random, a, poseA, b);
    }

    /// <summary>Meshes of size 1 whose own origin is up to 1e4 away, in places that bring them together.</summary>
    public static FuzzPair OffsetMeshes(Rng random)
    {
        FuzzShape a = Offset(random), b = random.OneIn(2) ? Offset(random) : Shapes.Polytope(random);
        var poseA = new RigidPose(Rotations.Any(random), random.OneIn(2) ? Vector3.Zero : random.Vector(100));
        return Placement.Meeting(random, a, poseA, b);
    }

    /// <summary>Hulls of 100 to 4096 corners, deep, near tangent and apart, against each other and against small
    /// shapes.</summary>
    public static FuzzPair LargeHulls(Rng random)
    {
        FuzzShape a = Large(random), b = random.OneIn(2) ? Large(random) : Shapes.Any(random);
        var poseA = new RigidPose(Rotations.Any(random), random.Vector(1));
        return Placement.Gap(
            a, poseA, b, Rotations.Any(random), random.Direction(),
            random.OneIn(3) ? -random.Unit() : Placement.AnyGap(random));
    }

    private static FuzzShape Large(Rng random)
    {
        int corners = random.OneIn(8) ? random.Of(2048, 4096) : random.Of(100, 128, 515, 1024);
        Vector3[] cloud = Clouds.OnSphere(random, corners);
        FuzzShape sphere = FuzzShape.Mesh(cloud);
        return random.OneIn(2) ? sphere : sphere.Scaled(random.Factors(0.3, 2));
    }

    private static FuzzShape Offset(Rng random)
    {
        Vector3 offset = (Vector3)(random.Direction() * random.Magnitude(1, 1e4));
        Vector3[] cloud = random.OneIn(2)
            ? Clouds.Lattice(random)
            : Clouds.InBox(random, 4 + random.Below(9), Vector3.One);
        return FuzzShape.Mesh(Clouds.Placed(cloud, 1, offset));
    }

    private static FuzzShape Polytope(Rng random, float size) => random.Below(5) switch
    {
        0 => ConvexShape.Box(Vector3.Abs(random.Vector(1)) * size),
        1 => ConvexShape.Sphere(random.Float(0.1, 1) * size),
        2 => FuzzShape.Mesh(Clouds.Box(Vector3.One)).Scaled(new Vector3(size)),
        _ => FuzzShape.Mesh(Clouds.Placed(Clouds.InBox(random, 4 + random.Below(9), Vector3.One), size, Vector3.Zero)),
    };
}
