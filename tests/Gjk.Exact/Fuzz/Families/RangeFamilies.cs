namespace Gjk.Exact.Fuzz.Families;

/// <summary>Sizes, ratios of sizes and distances from one end of what floats hold to the other.</summary>
internal static class RangeFamilies
{
    /// <summary>The largest coordinate that leaves room for a difference of two.</summary>
    private const double Largest = 1e38;

    /// <summary>Both of a size from 1e-40, where floats have lost most of their digits, to 1e38.</summary>
    public static FuzzPair WholeRange(Rng random)
    {
        double size = random.Magnitude(1e-40, Largest);
        FuzzShape a = Sized(random, size), b = Sized(random, size * random.Magnitude(0.1, 1));
        var poseA = new RigidPose(Rotations.Any(random), random.OneIn(2) ? Vector3.Zero : random.Vector(0.1 * size));
        Double3 direction = random.Direction();
        if (random.OneIn(2))
            return Held(a, poseA, b, Rotations.Any(random), direction, Placement.AnyGap(random) * size);
        return Held(a, poseA, b, Rotations.Any(random), direction, (random.Unit() - 1) * size);
    }

    /// <summary>One up to a million million times the other's size, beside it, in it or touching it.</summary>
    public static FuzzPair Ratios(Rng random)
    {
        double ratio = random.Magnitude(1e3, 1e12), size = random.OneIn(2) ? 1 : random.Magnitude(1e-20, 1e20);
        FuzzShape a = Sized(random, size), b = Sized(random, size / ratio);
        if (random.OneIn(2)) (a, b) = (b, a);
        var poseA = new RigidPose(Rotations.Any(random), random.OneIn(2) ? Vector3.Zero : random.Vector(size));
        double gap = random.Sign() * size / (random.OneIn(2) ? ratio : 1) * random.Magnitude(1e-6, 10);
        return Held(a, poseA, b, Rotations.Any(random), random.Direction(), gap);
    }

    /// <summary>From ten to a million million sizes apart.</summary>
    public static FuzzPair Distances(Rng random)
    {
        double far = random.Magnitude(10, 1e12), size = random.OneIn(2) ? 1 : random.Magnitude(1e-20, 1e20);
        FuzzShape a = Sized(random, size), b = Sized(random, size * random.Magnitude(1e-3, 1));
        var poseA = new RigidPose(Rotations.Any(random), random.OneIn(2) ? Vector3.Zero : random.Vector(size * far));
        return Held(a, poseA, b, Rotations.Any(random), random.Direction(), size * far);
    }

    /// <summary>Planes a gap apart; at the origin where floats do not reach so far.</summary>
    private static FuzzPair Held(
        in FuzzShape a, in RigidPose poseA, in FuzzShape b, Quaternion turnB, in Double3 n, double gap)
    {
        var bodyA = new PosedShape(a, poseA);
        var bodyB = new PosedShape(b, new RigidPose(turnB, Vector3.Zero));
        double apart = bodyA.Height(n) + bodyB.Height(-n) + gap;
        return Placement.Between(a, poseA, b, turnB, Math.Abs(apart) < 2 * Largest ? n * apart : default);
    }

    private static FuzzShape Sized(Rng random, double size)
    {
        var factor = (float)size;
        return random.Below(8) switch
        {
            0 => ConvexShape.Box(Vector3.Abs(random.Vector(1)) * factor),
            1 => ConvexShape.Sphere(random.Float(0.1, 1) * factor),
            2 => ConvexShape.Capsule(random.Float(0.1, 0.5) * factor, random.Float(0.1, 0.5) * factor),
            3 => Shapes.Curved(random, factor),
            4 => FuzzShape.Mesh(Cloud(random, new Vector3(0.5f))).Scaled(new Vector3(factor)),
            5 => FuzzShape.Mesh(Clouds.Fitted(MadeMeshes.Any(random), 0.5 * size)),
            _ => FuzzShape.Mesh(Clouds.Placed(Cloud(random, Vector3.One), factor, Vector3.Zero)),
        };
    }

    private static Vector3[] Cloud(Rng random, Vector3 half) => Clouds.InBox(random, 4 + random.Below(9), half);
}
