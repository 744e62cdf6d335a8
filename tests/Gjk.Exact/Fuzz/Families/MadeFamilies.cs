namespace Gjk.Exact.Fuzz.Families;

/// <summary>Pairs of meshes as people and programs make them: plain, baked, far from their own origin, and scaled back
/// to size.</summary>
internal static class MadeFamilies
{
    /// <summary>At random beside each other.</summary>
    public static FuzzPair Near(Rng random) =>
        Placement.Near(random, Shapes.Made(random), random.OneIn(3) ? Shapes.Any(random) : Shapes.Made(random));

    /// <summary>Planes stand a gap apart that is small, about the shapes' size, or up to a thousand times
    /// that.</summary>
    public static FuzzPair Apart(Rng random)
    {
        FuzzShape a = random.OneIn(2) ? Shapes.Made(random) : FuzzShape.Mesh(MadeMeshes.Baked(random));
        FuzzShape b = random.OneIn(2) ? Shapes.Made(random) : Shapes.Any(random);
        var poseA = new RigidPose(Rotations.Any(random), random.OneIn(2) ? Vector3.Zero : random.Vector(1));
        double gap = random.OneIn(2) ? Placement.AnyGap(random) : random.Magnitude(1e-2, 1e3);
        return Placement.Gap(a, poseA, b, Rotations.Any(random), Placement.AnyNormal(random, a, poseA), gap);
    }

    /// <summary>Ten to ten million sizes away from their local origin, where their last places are coarse; turned and
    /// placed so that they meet.</summary>
    public static FuzzPair OffsetMeshes(Rng random)
    {
        FuzzShape a = Offset(random);
        FuzzShape b = random.Below(3) switch
        {
            0 => Offset(random),
            1 => Shapes.Made(random),
            _ => Shapes.Polytope(random),
        };
        if (random.OneIn(2)) (a, b) = (b, a);
        var poseA = new RigidPose(Rotations.Any(random), random.OneIn(2) ? Vector3.Zero : random.Vector(100));
        if (random.OneIn(2))
            return Placement.Gap(
                a, poseA, b, Rotations.Any(random), Placement.AnyNormal(random, a, poseA), Placement.AnyGap(random));
        return Placement.Between(
            a, poseA, b, Rotations.Any(random), random.Direction() * Placement.Apart(random, a, b));
    }

    /// <summary>Meshes that were divided by a scale and are scaled back by it: powers of two, which round nothing, or
    /// other factors.</summary>
    public static FuzzPair Uneven(Rng random)
    {
        FuzzShape a = Stretched(random);
        FuzzShape b = random.Below(3) switch
        {
            0 => Stretched(random),
            1 => Shapes.Made(random),
            _ => Shapes.Any(random),
        };
        if (random.OneIn(2)) (a, b) = (b, a);
        return random.OneIn(2) ? Placement.Near(random, a, b) : Placement.Touching(random, a, b);
    }

    private static FuzzShape Offset(Rng random)
    {
        Vector3[] cloud = random.OneIn(2)
            ? MadeMeshes.Any(random)
            : Clouds.InBox(random, 4 + random.Below(9), Vector3.One);
        Vector3 offset = (Vector3)(random.Direction() * random.Magnitude(10, 1e7));
        if (random.OneIn(3)) offset *= new Vector3(random.Below(2), random.Below(2), 1);
        return FuzzShape.Mesh(Clouds.Placed(cloud, 1, offset));
    }

    /// <summary>Divided by factors and scaled back by them.</summary>
    public static FuzzShape Stretched(Rng random)
    {
        bool even = random.OneIn(4), exact = !random.OneIn(3);
        float x = Factor(random, exact);
        float y = even ? x * random.Sign() : Factor(random, exact);
        float z = even ? x * random.Sign() : Factor(random, exact);
        var factors = new Vector3(x, y, z);
        if (random.OneIn(6)) return ((FuzzShape)Curved(random, factors)).Scaled(factors);
        Vector3[] cloud = random.OneIn(2)
            ? MadeMeshes.Any(random)
            : Clouds.InBox(random, 4 + random.Below(20), Vector3.One);
        return FuzzShape.Mesh(Array.ConvertAll(cloud, p => p / factors)).Scaled(factors);
    }

    /// <summary>Of about unit size when it is scaled; its round sides by the factor of x alone.</summary>
    private static ConvexShape Curved(Rng random, Vector3 factors)
    {
        float across = random.Float(0.1, 1) / Math.Max(Math.Abs(factors.X), Math.Abs(factors.Z));
        float up = random.Float(0.1, 1) / Math.Abs(factors.Y);
        return random.Below(3) switch
        {
            0 => ConvexShape.Cylinder(across, up),
            1 => ConvexShape.Cone(across, up),
            _ => ConvexShape.Ellipsoid(Vector3.One / Vector3.Abs(factors)),
        };
    }

    private static float Factor(Rng random, bool exact) =>
        random.Sign() * (
            exact ? (float)Math.ScaleB(1, random.Below(49) - 24) : (float)random.Magnitude(1.0 / (1 << 24), 1 << 24));
}
