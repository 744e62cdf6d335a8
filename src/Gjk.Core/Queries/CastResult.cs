namespace Gjk.Core;

/// <summary>When and where two moving shapes first touch. Immutable.</summary>
public readonly struct CastResult
{
    /// <summary>What was found; see <see cref="CastStatus"/> for which fields are valid.</summary>
    public readonly CastStatus Status;

    /// <summary>The part of the motion, from 0, after which the shapes first share a point, rounded to float; of a time
    /// of impact a part, rounded down, before which they share none.</summary>
    public readonly float Fraction;

    /// <summary>A point that they share then, on A as it has moved, in the world; of a time of impact A's point nearest
    /// to B.</summary>
    public readonly Vector3 Point;

    /// <summary>The unit vector from A to B at the hit, perpendicular to the planes that touch. Of shapes that overlap
    /// at the start it is the direction in which B leaves A by the shortest way, as <c>SignedDistance</c> gives
    /// it.</summary>
    public readonly Vector3 Normal;

    /// <summary>World units: how deep the shapes overlap at the start; 0 for a hit and a miss. Moved along
    /// <see cref="Normal"/> by this, B only touches A. Where <c>SignedDistance</c> has no room for its search, the
    /// depth may be less.</summary>
    public readonly float Depth;

    /// <summary>How many times both shapes were asked for a support point.</summary>
    public readonly int Iterations;

    /// <summary>The fraction as it was solved, before rounding to float.</summary>
    private readonly double _solved;

    internal CastResult(
        CastStatus status, double solved, Vector3 point, Vector3 normal, int iterations, float depth = 0)
        : this(status, (float)solved, solved, point, normal, iterations, depth)
    {
    }

    private CastResult(
        CastStatus status, float fraction, double solved, Vector3 point, Vector3 normal, int iterations, float depth)
    {
        (Status, Fraction, _solved, Depth, Iterations) = (status, fraction, solved, depth, iterations);
        Point = point;
        Normal = normal;
    }

    /// <summary>True when a contact was found that counts: on the way, or at the start.</summary>
    public bool IsHit => Status is CastStatus.Hit or CastStatus.OverlappingAtStart;

    /// <summary>By what it is compared with other contacts of the motion.</summary>
    internal ContactOrder Order => new(_solved, Status, Depth);

    /// <summary>The same with a fraction that is rounded otherwise.</summary>
    internal CastResult At(float fraction) => new(Status, fraction, _solved, Point, Normal, Iterations, Depth);

    /// <summary>The same contact after it has been asked how deep it is.</summary>
    internal CastResult With(CastStatus status, Vector3 point, Vector3 normal, int iterations, float depth) =>
        new(status, Fraction, _solved, point, normal, iterations, depth);

    /// <summary>True also for a search that ended at its limit, apart up to the fraction.</summary>
    internal bool MayHit => IsHit || Status == CastStatus.IterationLimit;

    /// <summary>The same answer with A and B exchanged.</summary>
    public CastResult Swapped => new(Status, Fraction, _solved, Point, Opposite.Of(Normal), Iterations, Depth);

    /// <summary>The status and the fields that are valid with it, as text.</summary>
    public override string ToString() => Status switch
    {
        CastStatus.Hit => FormattableString.Invariant(
            $"Hit after {Fraction:G9} at {((Double3)Point).ToText()} along {((Double3)Normal).ToText()}"),
        CastStatus.OverlappingAtStart => FormattableString.Invariant(
            $"{Status} by {Depth:G9}, B leaves A along {((Double3)Normal).ToText()}"),
        CastStatus.Miss or CastStatus.IterationLimit => FormattableString.Invariant($"{Status} up to {Fraction:G9}"),
        _ => Status.ToString(),
    };

    internal static CastResult Nothing(CastStatus status, float fraction, int iterations)
    {
        var nan = new Vector3(float.NaN);
        float depth = status is CastStatus.Miss or CastStatus.IterationLimit ? 0 : float.NaN;
        return new CastResult(status, fraction, nan, nan, iterations, depth);
    }
}

/// <summary>Which of several contacts of a motion is the first: the one with the least fraction as it was solved; of
/// those at the start the deepest.</summary>
internal readonly struct ContactOrder(double solved, CastStatus status, float depth) : IComparable<ContactOrder>
{
    /// <summary>Count: bits of a fraction that are left out. Two parts that are met at once are solved to some 2^-45 of
    /// it, and 2^-40 is 2^-16 of what a float tells apart: two bits more or less are far from both. Without any,
    /// CastSeamTests fails.</summary>
    private const int LeftOut = 12;

    private readonly double _depth = status == CastStatus.OverlappingAtStart ? depth : -1;

    /// <summary>The fraction, or a ray's distance, as two parts' are compared.</summary>
    public double Solved { get; } = Rounded(solved);

    public int CompareTo(ContactOrder other)
    {
        int order = Solved.CompareTo(other.Solved);
        return order != 0 ? order : other._depth.CompareTo(_depth);
    }

    private static double Rounded(double x)
    {
        if (!(x > 0) || double.IsInfinity(x)) return x;
        long half = 1L << (LeftOut - 1);
        return BitConverter.Int64BitsToDouble((BitConverter.DoubleToInt64Bits(x) + half) & -(2 * half));
    }
}
