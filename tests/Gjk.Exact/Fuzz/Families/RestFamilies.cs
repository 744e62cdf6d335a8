using static Gjk.Exact.Fuzz.IntegerRotation;

namespace Gjk.Exact.Fuzz.Families;

/// <summary>Bodies at rest on each other: contacts and gaps that floats hold exactly, in turned frames, too.</summary>
internal static class RestFamilies
{
    /// <summary>A below a plane that it reaches, B above it, both turned by one rational rotation and B once more about
    /// the plane's normal. The plane stands at y = 0 of the turned frame, and positions are multiples of the rotation's
    /// denominator, so nothing is rounded: they touch, or stand a known gap apart.</summary>
    public static FuzzPair Resting(Rng random)
    {
        IntegerRotation frame = Any(random), turned = random.OneIn(2) ? frame : frame.Times(AboutY(random));
        double unit = Math.ScaleB(1, -turned.Bits - random.Below(6));
        FuzzShape a = Grounded(random, -1, turned.Norm * unit, out double topA);
        FuzzShape b = Grounded(random, 1, turned.Norm * unit, out double bottomB);
        double gap = random.OneIn(2) ? 0 : random.Sign() * turned.Norm * Math.ScaleB(1, -random.Below(40));
        var aside = new Double3(random.Below(9) - 4, 0, random.Below(9) - 4) * (turned.Norm * unit);
        Vector3 home = gap == 0 || Math.Abs(gap) > 1e-3
            ? new Vector3(random.Below(65) - 32, random.Below(65) - 32, random.Below(65) - 32) * (float)unit
            : Vector3.Zero;
        Double3 up = frame.Exactly(aside + new Double3(0, topA + gap - bottomB, 0));
        return new FuzzPair(
            a, new RigidPose(frame.ToQuaternion(random), home), b,
            new RigidPose(turned.ToQuaternion(random), home + (Vector3)up));
    }

    /// <summary>Curved and flat shapes with lattice sizes at lattice places: rims on faces, axes side by side, slopes
    /// on edges.</summary>
    public static FuzzPair CurvedLattice(Rng random)
    {
        IntegerRotation frame = random.OneIn(2) ? Identity : Any(random);
        IntegerRotation other = random.OneIn(2) ? frame : frame.Times(Any(random));
        double unit = Math.ScaleB(1, -other.Bits);
        Vector3 home = new Vector3(random.Below(9) - 4, random.Below(9) - 4, random.Below(9) - 4) * (float)unit;
        var steps = new Double3(random.Below(17) - 8, random.Below(17) - 8, random.Below(17) - 8);
        Double3 away = frame.Exactly(steps * (0.25 * other.Norm * unit));
        FuzzShape a = LatticeShape(random, (float)(other.Norm * unit));
        FuzzShape b = LatticeShape(random, (float)(other.Norm * unit));
        return new FuzzPair(
            a, new RigidPose(frame.ToQuaternion(random), home), b,
            new RigidPose(other.ToQuaternion(random), home + (Vector3)away));
    }

    /// <summary>Shapes with and without margins whose planes stand a gap of a few last places of a double apart: what
    /// B's position loses by rounding is put into A's, which is 0 but for that.</summary>
    public static FuzzPair AtTheThreshold(Rng random)
    {
        FuzzShape a = random.OneIn(3) ? Shapes.Any(random) : Shapes.Round(random);
        FuzzShape b = random.OneIn(4) ? Shapes.Any(random) : Shapes.Round(random);
        Quaternion turnA = Rotations.Any(random), turnB = Rotations.Any(random);
        if (random.OneIn(2)) (turnA, turnB) = (Quaternion.Identity, Quaternion.Identity);
        Double3 n = random.OneIn(2) ? random.Direction() : new Double3(0, random.Sign(), 0);
        return Exactly(a, turnA, b, turnB, n, Math.ScaleB(random.Below(33) - 16, -54));
    }

    /// <summary>Plates, needles, stretched and made meshes whose planes across a face of A stand next to nothing
    /// apart.</summary>
    public static FuzzPair ThinGaps(Rng random)
    {
        FuzzShape a = Thin(random), b = random.OneIn(3) ? Shapes.Any(random) : Thin(random);
        Quaternion turnA = Rotations.Any(random);
        Quaternion turnB = random.OneIn(2) ? turnA : Rotations.Any(random);
        Double3 n = Placement.AnyNormal(random, a, new RigidPose(turnA, Vector3.Zero));
        return Exactly(a, turnA, b, turnB, n, random.Sign() * random.Magnitude(1e-16, 1e-12));
    }

    private static FuzzShape Thin(Rng random) => random.Below(4) switch
    {
        0 => MadeFamilies.Stretched(random),
        1 => Shapes.Made(random),
        2 => Shapes.Scaled(random),
        _ => Shapes.Needle(random),
    };

    /// <summary>What B's position loses by rounding is put into A's, which is 0 but for that.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="turnA">Its rotation.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="turnB">Its rotation.</param>
    /// <param name="n">The direction across the planes, of unit length.</param>
    /// <param name="gap">How far the planes stand apart, as a fraction of both shapes' size.</param>
    private static FuzzPair Exactly(
        in FuzzShape a, Quaternion turnA, in FuzzShape b, Quaternion turnB, in Double3 n, double gap)
    {
        var bodyA = new PosedShape(a, new RigidPose(turnA, Vector3.Zero));
        var bodyB = new PosedShape(b, new RigidPose(turnB, Vector3.Zero));
        double apart = bodyA.Height(n) + bodyB.Height(-n) + gap * (bodyA.LongestSide + bodyB.LongestSide);
        Double3 place = bodyA.Rotate(bodyA.Center) - bodyB.Rotate(bodyB.Center) + n * apart;
        var rounded = (Vector3)place;
        return new FuzzPair(a, new RigidPose(turnA, (Vector3)(rounded - place)), b, new RigidPose(turnB, rounded));
    }

    /// <summary>A shape that reaches a height on one side of a plane and none beyond.</summary>
    /// <param name="random">The source.</param>
    /// <param name="side">1 above, -1 below.</param>
    /// <param name="step">What sizes are multiples of.</param>
    /// <param name="height">Where it ends towards the plane.</param>
    private static FuzzShape Grounded(Rng random, int side, double step, out double height)
    {
        float half = (float)(step * (1 + random.Below(4))), width = (float)(step * (1 + random.Below(4)));
        height = -side * half;
        switch (random.Below(8))
        {
            case 0: return ConvexShape.Box(new Vector3(width, half, width));
            case 1: return ConvexShape.Cylinder(width, half);
            case 2: return FuzzShape.Mesh(Copies.Unwelded(random, Clouds.Box(new Vector3(width, half, half))));
            case 3 when side > 0: return ConvexShape.Cone(width, half);
            case 4: return ConvexShape.Sphere(half);
            default:
                height = 0;
                return FuzzShape.Mesh(OnGround(MadeMeshes.Any(random), side));
        }
    }

    /// <summary>Moved along y so that its end lies at 0; on the other side of it, mirrored.</summary>
    private static Vector3[] OnGround(Vector3[] cloud, int side)
    {
        float low = float.PositiveInfinity;
        foreach (Vector3 p in cloud) low = Math.Min(low, p.Y);
        return Array.ConvertAll(cloud, p => p with { Y = side * (p.Y - low) });
    }

    private static FuzzShape LatticeShape(Rng random, float step)
    {
        float across = step * 0.25f * random.Below(5), up = step * 0.25f * random.Below(5);
        return random.Below(8) switch
        {
            0 => ConvexShape.Box(new Vector3(across, up, step * 0.25f * random.Below(5))),
            1 => ConvexShape.Cone(across, up),
            2 => ConvexShape.Ellipsoid(new Vector3(across, up, across)),
            3 => ConvexShape.Sphere(across),
            4 => ConvexShape.Capsule(across, up),
            5 => FuzzShape.Mesh(Clouds.Placed(Clouds.Lattice(random), step, Vector3.Zero)),
            _ => ConvexShape.Cylinder(across, up),
        };
    }
}
