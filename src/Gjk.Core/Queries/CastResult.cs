using System;
using System.Numerics;

namespace Gjk.Core;

/// <summary>When and where two moving shapes first touch. Immutable.</summary>
public readonly struct CastResult
{
    /// <summary>What was found; what is valid under it, <see cref="CastStatus"/> says.</summary>
    public readonly CastStatus Status;

    /// <summary>
    /// The part of the motion, from 0, after which the shapes first share a point, rounded to float; of a time of
    /// impact a part, rounded down, before which they share none.
    /// </summary>
    public readonly float Fraction;

    /// <summary>
    /// A point that they share then, on A as it has moved, in the world; of a time of impact A's point nearest to B.
    /// </summary>
    public readonly Vector3 Point;

    /// <summary>The unit vector from A to B at the hit, perpendicular to the planes that touch.</summary>
    public readonly Vector3 Normal;

    /// <summary>How many times both shapes were asked for a support point.</summary>
    public readonly int Iterations;

    internal CastResult(CastStatus status, float fraction, Vector3 point, Vector3 normal, int iterations)
    {
        Status = status;
        Fraction = fraction;
        Point = point;
        Normal = normal;
        Iterations = iterations;
    }

    /// <summary>True when the shapes share a point somewhere along the motion, its start included.</summary>
    public bool IsHit => Status is CastStatus.Hit or CastStatus.OverlappingAtStart;

    /// <summary>The same answer with A and B exchanged.</summary>
    public CastResult Swapped => new(Status, Fraction, Point, -Normal, Iterations);

    /// <summary>The status, and what is valid under it, for people to read.</summary>
    public override string ToString() => Status switch
    {
        CastStatus.Hit => FormattableString.Invariant(
            $"Hit after {Fraction:G9} at {((Vector3D)Point).ToString("G9")} along {((Vector3D)Normal).ToString("G9")}"),
        CastStatus.Miss or CastStatus.IterationLimit => FormattableString.Invariant($"{Status} up to {Fraction:G9}"),
        _ => Status.ToString(),
    };

    internal static CastResult Nothing(CastStatus status, float fraction, int iterations)
    {
        var nan = new Vector3(float.NaN);
        return new CastResult(status, fraction, nan, nan, iterations);
    }
}
