using Gjk.Exact.Fuzz.Families;

namespace Gjk.Exact.Fuzz.HalfSpaces;

/// <summary>Half-spaces beside every kind of shape: near and far from their origins, of all sizes, about to
/// touch.</summary>
internal static class HalfSpaceFamilies
{
    private static readonly (string Name, Func<Rng, FuzzShape> Make)[] s_all =
    [
        ("half-space and anything", Shapes.Any), ("half-space and polytopes", Shapes.Polytope),
        ("half-space and made meshes", Shapes.Made), ("half-space and curved", Shapes.Curved),
        ("half-space and tapered capsules", Shapes.Tapered), ("half-space and needles", Shapes.Needle),
        ("half-space and flat", Shapes.Degenerate), ("half-space and round", Shapes.Round),
    ];

    public static IReadOnlyList<string> Names { get; } = [.. s_all.Select(f => f.Name)];

    /// <summary>How far a decorated plane may be from the shape: scaled by a size, what is far can be further than a
    /// float holds.</summary>
    private const double Furthest = 1e38;

    /// <summary>The pair of a seed and a number, with its family's name.</summary>
    public static HalfSpacePair Draw(ulong seed, long index, out string family)
    {
        Rng random = Rng.ForPair(seed ^ 0x48414C46, index);
        (family, Func<Rng, FuzzShape> make) = random.Of(s_all);
        FuzzShape other = make(random);
        double size = random.OneIn(4) && other.Scale == Vector3.One ? random.Magnitude(1e-15, 1e15) : 1;
        if (size != 1) other = other.Scaled(new Vector3((float)size));
        Double3 normal = random.OneIn(3)
            ? random.Of(new Double3(0, 1, 0), new Double3(0, 0, -1), new Double3(1, 1, 0))
            : random.Direction() * random.Magnitude(1e-3, 1e3);
        float offset = random.OneIn(3) ? 0 : (float)(random.Range(-2, 2) * size * random.Of(1.0, 1.0, 1e6));
        double far = random.OneIn(2) ? 1 : random.Magnitude(1, 1e6);
        var at = new RigidPose(Rotations.Any(random), random.OneIn(2) ? default : random.Vector(size * far));
        var pose = new RigidPose(Rotations.Any(random), random.Vector(size * far));
        ConvexShape plane = ConvexShape.HalfSpace((Vector3)normal, offset);
        var pair = new HalfSpacePair(Decorated(random, plane, size), at, other, pose, default);
        if (Math.Abs(pair.Gap) > Furthest) pair = new HalfSpacePair(plane, at, other, pose, default);
        double gap = random.OneIn(4) ? random.Range(-2, 2) : Placement.AnyGap(random);
        Double3 position = (Double3)pose.Position + pair.Outward * (gap * size - pair.Gap);
        return pair.At((Vector3)position, Motion(random, pair.Outward, size));
    }

    /// <summary>Scaled, widened or placed, or none of it. What comes out is a plane of its own, whose record has its
    /// normal and offset in double, from which the true gap is taken.</summary>
    private static ConvexShape Decorated(Rng random, ConvexShape plane, double size)
    {
        if (random.OneIn(4))
            plane = plane.Scaled(
                (Vector3)(new Double3(random.Range(-3, 3), random.Range(0.1, 3), random.Range(-3, -0.1)) * size));
        if (random.OneIn(4)) plane = plane.Rounded((float)(random.Range(0, 2) * size));
        return random.OneIn(4) ? plane.Placed(new RigidPose(Rotations.Any(random), random.Vector(size))) : plane;
    }

    /// <summary>Any motion, one along the plane or nearly, or one straight at it; either of the two moves, or
    /// both.</summary>
    private static PairMotion Motion(Rng random, in Double3 outward, double size)
    {
        Double3 any = random.Direction() * (size * random.Magnitude(1e-3, 1e3));
        Double3 along = any - outward * Double3.Dot(any, outward);
        Double3 relative = random.Below(4) switch
        {
            0 => along,
            1 => along - outward * (along.Length * random.Magnitude(1e-16, 1e-3)),
            2 => outward * (-random.Range(0, 3) * size),
            _ => any,
        };
        Double3 shared = random.OneIn(3) ? random.Direction() * size : default;
        return new PairMotion((Vector3)shared, (Vector3)(shared + relative));
    }
}
