using System;
using System.Numerics;
using Gjk.Core;
using Gjk.Exact.Answers;
using Gjk.Exact.Oracle;

namespace Gjk.Exact.Certificates;

/// <summary>
/// Proves a result from the shapes' supports alone, without another solver: the planes across the returned normal must
/// stand as far apart as the distance says, and the points must lie on their shapes and differ by it. Works for any
/// support map.
/// </summary>
public static class Certificate
{
    /// <summary>
    /// Ratio: what the rounding of a unit normal to float (2^-24 a component) can tilt it by, with room for the three
    /// components.
    /// </summary>
    private const double Tilt = 1.5e-7;

    /// <summary>Room for a least float where products vanish.</summary>
    private const double Denormal = 1e-44;

    /// <summary>What is wrong with the result, or null.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Where it is.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Where it is.</param>
    /// <param name="r">What the query said.</param>
    /// <param name="scale">Of the pair, contract 6.</param>
    /// <param name="curved">Whether the pair is held to the curved shapes' accuracy.</param>
    public static string? Problem<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, in DistanceResult r, double scale,
        bool curved = false)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (r.Status is not (GjkStatus.Separated or GjkStatus.Overlapping))
            return $"status is {r.Status} after {r.Iterations} iterations";

        // Contract 6: where there is no scale (two points), errors are relative to the distance.
        if (scale == 0) scale = r.Distance;
        var bodyA = new Body<TA>(a, poseA);
        var bodyB = new Body<TB>(b, poseB);
        double slack = curved ? Accuracy.CurvedRatio * Math.Max(scale, r.Distance) : Accuracy.WitnessScale * scale;
        return Points(bodyA, bodyB, r, slack)
            ?? (r.IsOverlapping ? Overlapping(bodyA, bodyB, r, scale) : Separated(bodyA, bodyB, r, scale, curved));
    }

    /// <summary>
    /// What is wrong with a signed distance, or null. Of an overlap it proves that the way out is one, that it is as
    /// long as the result says and that it ends at the points; not that no other is shorter.
    /// </summary>
    /// <inheritdoc cref="Problem"/>
    public static string? ProblemOfSigned<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, in DistanceResult r, double scale,
        bool curved = false)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (!r.IsOverlapping) return Problem(a, poseA, b, poseB, r, scale, curved);
        if (!(r.Distance <= 0)) return $"overlapping with the distance {r.Distance:R}";
        var bodyA = new Body<TA>(a, poseA);
        var bodyB = new Body<TB>(b, poseB);
        double slack = curved ? Accuracy.CurvedRatio * scale : Accuracy.WitnessScale * scale;
        return Points(bodyA, bodyB, r, slack) ?? Planes(bodyA, bodyB, r, scale, curved);
    }

    /// <summary>Each point lies in its shape, and the world's point is the local one, rounded.</summary>
    private static string? Points<TA, TB>(Body<TA> a, Body<TB> b, in DistanceResult r, double slack)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double outsideA = a.Outside(r.LocalPointA), outsideB = b.Outside(r.LocalPointB);
        if (!(outsideA <= slack + Rounding(r.LocalPointA))) return $"LocalPointA lies {outsideA:R} outside of A";
        if (!(outsideB <= slack + Rounding(r.LocalPointB))) return $"LocalPointB lies {outsideB:R} outside of B";
        double offA = (a.ToWorld(r.LocalPointA) - r.PointA).Length, offB = (b.ToWorld(r.LocalPointB) - r.PointB).Length;
        if (!(offA <= slack + Rounding(r.LocalPointA) + Rounding(r.PointA)))
            return $"PointA is {offA:R} off the world position of LocalPointA";
        if (!(offB <= slack + Rounding(r.LocalPointB) + Rounding(r.PointB)))
            return $"PointB is {offB:R} off the world position of LocalPointB";
        return null;
    }

    private static string? Overlapping<TA, TB>(Body<TA> a, Body<TB> b, in DistanceResult r, double scale)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (r.Distance != 0 || r.LowerBound != 0) return "overlapping with a distance or a bound";
        if (r.PointA != r.PointB) return "overlapping with two different points";
        if (r.Normal != Vector3.Zero) return "overlapping with a normal";
        double widest = 0;
        Vector3D centers = Between(a, a.Center, b, b.Center);
        foreach (Vector3D u in Directions.Many) widest = Math.Max(widest, Gap(a, b, centers, u));
        return widest <= Accuracy.FlagScale * scale ? null : $"overlapping, yet a plane separates by {widest:R}";
    }

    private static string? Separated<TA, TB>(Body<TA> a, Body<TB> b, in DistanceResult r, double scale, bool curved)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (!(r.Distance >= 0) || float.IsInfinity(r.Distance)) return "the distance is no number";
        return Planes(a, b, r, scale, curved);
    }

    /// <summary>The planes across the normal stand as far apart as the distance says, of either sign.</summary>
    private static string? Planes<TA, TB>(Body<TA> a, Body<TB> b, in DistanceResult r, double scale, bool curved)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double d = r.Distance, size = Math.Abs(d);
        double band = curved ? Accuracy.CurvedBand(size, scale) : Accuracy.Band(size, scale);
        Vector3D n = r.Normal;
        if (!(Math.Abs(n.Length - 1) <= Accuracy.UnitLength)) return $"the normal's length is {n.Length:R}";
        n *= 1 / n.Length;

        double reach = a.Radius + b.Radius + size, gap = Gap(a, b, n);
        if (!(gap <= d + band + Denormal))
            return $"the planes across the normal are {gap:R} apart, more than the distance {d:R}";
        if (!(gap >= d - band - Tilt * reach))
            return $"the planes across the normal are only {gap:R} apart, the distance is {d:R}";
        if (!(r.LowerBound <= r.Distance))
            return $"the lower bound {r.LowerBound:R} is above the distance {r.Distance:R}";
        if (!(r.LowerBound >= d - band - Denormal - Accuracy.DistanceScale * scale))
            return $"the lower bound {r.LowerBound:R} leaves a gap to the distance {r.Distance:R}";

        double slack = curved ? Accuracy.CurvedBand(size, scale) : Accuracy.WitnessScale * scale;
        double world = ((Vector3D)r.PointB - r.PointA - n * d).Length;
        if (!(world <= slack + Rounding(r.PointA) + Rounding(r.PointB) + 4 * Accuracy.HalfFloat * size))
            return $"PointB - PointA is {world:R} off Normal * Distance";
        double local = (Between(a, r.LocalPointA, b, r.LocalPointB) - n * d).Length;
        if (!(local <= slack + Rounding(r.LocalPointA) + Rounding(r.LocalPointB) + 4 * Accuracy.HalfFloat * size))
            return $"the local points' difference is {local:R} off Normal * Distance";
        return null;
    }

    /// <summary>
    /// How far apart the planes across a unit direction stand that touch A and B; negative where the shapes reach past
    /// each other.
    /// </summary>
    public static double Gap<TA, TB>(Body<TA> a, Body<TB> b, in Vector3D n)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        Gap(a, b, Between(a, a.Center, b, b.Center), n);

    private static double Gap<TA, TB>(Body<TA> a, Body<TB> b, in Vector3D centers, in Vector3D n)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        Vector3D.Dot(n, centers) - a.HeightOverCenter(n) - b.HeightOverCenter(-n);

    /// <summary>From a local point of A to one of B, in the world's axes, to the last place of a double.</summary>
    private static Vector3D Between<TA, TB>(Body<TA> a, in Vector3D localA, Body<TB> b, in Vector3D localB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        new ExactProblem([localB], 0, b.Pose, [localA], 0, a.Pose).FirstVertex();

    private static double Rounding(Vector3 p) => 2 * Accuracy.HalfFloat * ((Vector3D)p).Length + Denormal;
}
