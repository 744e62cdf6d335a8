namespace Gjk.Core;

/// <summary>Casts that pass shallow contacts, of a body that begins inside a union of parts or objects: the body is
/// moved out of the union first, by the deepest way out after the other, and what it does not get deeper into from
/// there is passed. So it slides along the union as along a single body, and a wall still stops it.</summary>
/// <remarks>What begins outside may be in parts that it passes, as it leaves them before it is too deep, when
/// the seam of the next one stops it. From just outside of them, with the rest of its motion, it meets their surface
/// there, or a wall; so the seam is told from a wall.</remarks>
internal static class UnionLift
{
    /// <summary>Count: a corner of a room takes three ways out; more are harmless.</summary>
    public const int MostLifts = 4;

    /// <summary>Ratio to the coordinates and the depth: 2^-20, some roundings of a position to float. Pinned by
    /// UnionSlideTests.</summary>
    private const float Rounding = 1f / (1 << 20);

    /// <summary>A cosine, of 2.5 degrees: normals that differ by less are of one surface. Walls are far from it; a bend
    /// that is smaller is climbed as well as stopped at.</summary>
    private const float SameWay = 0.999f;

    /// <summary>Moves a body out of what it overlaps deeper than is allowed.</summary>
    /// <param name="start">What a cast says of the start.</param>
    /// <param name="options">What is allowed.</param>
    /// <param name="sign">1 for B, -1 for A.</param>
    /// <param name="pose">Of the body.</param>
    public static bool TryMove(in CastResult start, in CastOptions options, float sign, ref RigidPose pose)
    {
        bool isDeep = start.Status == CastStatus.OverlappingAtStart && start.Depth > options.AllowedDepth;
        Vector3 moved = pose.Position + sign * start.Depth * start.Normal;
        if (!isDeep || !Guard.IsFinite(moved) || moved == pose.Position) return false;
        pose = new RigidPose(pose.Rotation, moved);
        return true;
    }

    /// <summary>World units: so far a body may be from where it was moved to.</summary>
    public static float RoundingOf(in RigidPose pose) =>
        (float)Math.Min(Rounding * ((Double3)pose.Position).SumOfMagnitudes, float.MaxValue);

    /// <summary>What is passed where a body is lifted to, and on the way there: what rounding makes. It begins deeper
    /// than is allowed, and what it gets deeper by in short steps adds up.</summary>
    public static CastOptions Within(float rounding) => CastOptions.OnlyDeeper(rounding);

    /// <summary>Whether a hit may be with a seam: the body goes deeper all the way into a surface that it has met
    /// before and passes. It is moved out of that, and a little further.</summary>
    /// <param name="hit">On the way.</param>
    /// <param name="first">The first contact of all: with the surface, as its seams come later.</param>
    /// <param name="way">How the body moves there, seen from the other.</param>
    /// <param name="options">What is passed: some depth is allowed, or no surface would be.</param>
    /// <param name="room">World units: what the poses and the contacts may be off by.</param>
    /// <param name="sign">1 where the body is B, -1 where it is A.</param>
    /// <param name="pose">Of the body where it is hit.</param>
    public static bool TryLeave(
        in CastResult hit, in CastResult first, in Double3 way, in CastOptions options, double room, float sign,
        ref RigidPose pose)
    {
        double rate = -sign * Double3.Dot(way, first.Normal), between = (double)hit.Fraction - first.Fraction;
        double deep = first.Depth + rate * between + 2 * room;
        var moved = (Vector3)((Double3)pose.Position + (Double3)first.Normal * (sign * deep));
        bool isIn = first.IsHit && rate > 0 && between >= 0
            && deep <= 2 * Math.Max(options.AllowedDepth, first.Depth) + 4 * room;
        if (!isIn || hit.Normal == first.Normal || !Guard.IsFinite(moved)) return false;
        pose = new RigidPose(pose.Rotation, moved);
        return true;
    }

    /// <summary>Whether what is met from outside of the surface is that surface, or nothing.</summary>
    public static bool IsFlush(in CastResult above, in CastResult start) => !above.MayHit || IsSameWay(above, start);

    private static bool IsSameWay(in CastResult a, in CastResult b) => Vector3.Dot(a.Normal, b.Normal) > SameWay;
}
