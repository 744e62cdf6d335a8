namespace Gjk.Core;

/// <summary>Casts that pass shallow contacts, of a body that begins inside a union of parts or objects: the body is
/// moved out of the union first, by the deepest way out after the other, and what it does not get deeper into from
/// there is passed. So it slides along the union as along a single body, and a wall still stops it.</summary>
internal static class UnionLift
{
    /// <summary>Count: a corner of a room takes three ways out; more are harmless.</summary>
    public const int MostLifts = 4;

    /// <summary>Ratio to the coordinates and the depth: 2^-20, some roundings of a position to float. Pinned by
    /// UnionSlideTests.</summary>
    private const float Rounding = 1f / (1 << 20);

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

    /// <summary>What is passed from there: also what the rounding of its pose makes.</summary>
    public static CastOptions OptionsAt(in RigidPose pose, in CastOptions options) =>
        CastOptions.OnlyDeeper(Math.Max(options.AllowedDepth, RoundingOf(pose)));
}
