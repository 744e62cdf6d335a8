using System;
using System.Numerics;

namespace Gjk.Core;

/// <summary>Where a ray first meets a shape. Immutable.</summary>
public readonly struct RayCastResult
{
    /// <summary>What was found; what is valid under it, <see cref="CastStatus"/> says.</summary>
    public readonly CastStatus Status;

    /// <summary>
    /// World units along the ray from its origin, rounded to float; 0 where it begins in the shape, the largest
    /// distance at a miss.
    /// </summary>
    public readonly float Distance;

    /// <summary>The point of the ray at that distance, in the world.</summary>
    public readonly Vector3 Point;

    /// <summary>
    /// The unit normal of the shape's surface there, outward; zero where the ray begins in the shape.
    /// </summary>
    public readonly Vector3 Normal;

    /// <summary>How many times the shape was asked for a support point: 0 where a closed form answers.</summary>
    public readonly int Iterations;

    internal RayCastResult(CastStatus status, float distance, Vector3 point, Vector3 normal, int iterations)
    {
        Status = status;
        Distance = distance;
        Point = point;
        Normal = normal;
        Iterations = iterations;
    }

    /// <summary>True when the ray meets the shape, its origin included.</summary>
    public bool IsHit => Status is CastStatus.Hit or CastStatus.OverlappingAtStart;

    /// <summary>The status, and what is valid under it, for people to read.</summary>
    public override string ToString() => Status switch
    {
        CastStatus.Hit => FormattableString.Invariant(
            $"Hit after {Distance:G9} at {Text(Point)}, normal {Text(Normal)}"),
        CastStatus.Miss or CastStatus.IterationLimit => FormattableString.Invariant($"{Status} up to {Distance:G9}"),
        _ => Status.ToString(),
    };

    private static string Text(Vector3 v) => ((Vector3D)v).ToString("G9");

    internal static RayCastResult Nothing(CastStatus status, float distance, int iterations)
    {
        var nan = new Vector3(float.NaN);
        return new RayCastResult(status, distance, nan, nan, iterations);
    }
}
