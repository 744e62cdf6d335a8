namespace Gjk.Core;

/// <summary>The answer of <see cref="ConvexQuery"/>'s distance and signed distance. Lengths and points are in world
/// units and the world frame unless the name says otherwise. What is valid under which status: see
/// <see cref="GjkStatus"/>.</summary>
public readonly struct DistanceResult
{
    /// <summary>What was found.</summary>
    public readonly GjkStatus Status;

    /// <summary>The distance between the shapes, rounded to float: at least 0; 0 when overlapping. A signed distance is
    /// then minus the depth.</summary>
    public readonly float Distance;

    /// <summary>A lower bound of the distance: the gap between two parallel planes that separate the shapes, evaluated
    /// in double and lowered by twice what rounding did to the worst pose that was found. Of a signed distance it is
    /// negative when the shapes overlap, and the true signed distance is not below it.</summary>
    public readonly float LowerBound;

    /// <summary>The point of A that is closest to B; of a signed distance, when overlapping, the one that is deepest in
    /// B.</summary>
    public readonly Vector3 PointA;

    /// <summary>The point of B that is closest to A, or deepest in it.</summary>
    public readonly Vector3 PointB;

    /// <summary>The unit vector from A to B, perpendicular to the separating planes; zero when overlapping. Of a signed
    /// distance it is then the direction in which B leaves A by the shortest way.</summary>
    public readonly Vector3 Normal;

    /// <summary><see cref="PointA"/> in A's own frame, where far from the world's origin a float holds it
    /// better.</summary>
    public readonly Vector3 LocalPointA;

    /// <summary><see cref="PointB"/> in B's own frame.</summary>
    public readonly Vector3 LocalPointB;

    /// <summary>How many times both shapes were asked for a support point, the one that proved the end
    /// included.</summary>
    public readonly int Iterations;

    internal DistanceResult(
        GjkStatus status, float distance, float lowerBound, Vector3 pointA, Vector3 pointB, Vector3 normal,
        Vector3 localPointA, Vector3 localPointB, int iterations)
    {
        Status = status;
        Distance = distance;
        LowerBound = lowerBound;
        PointA = pointA;
        PointB = pointB;
        Normal = normal;
        LocalPointA = localPointA;
        LocalPointB = localPointB;
        Iterations = iterations;
    }

    /// <summary>Writes a result where it is to be, without the copies that a constructor makes on Mono, each of which
    /// costs as much as a support.</summary>
    internal static unsafe void Write(
        out DistanceResult result, GjkStatus status, float distance, float lowerBound, in Xyz pointA, in Xyz pointB,
        in Xyz normal, in Xyz localPointA, in Xyz localPointB, int iterations)
    {
        fixed (DistanceResult* same = &result)
        {
            var to = (Fields*)same;
            to->Status = status;
            to->Distance = distance;
            to->LowerBound = lowerBound;
            pointA.Round(out to->PointA);
            pointB.Round(out to->PointB);
            normal.Round(out to->Normal);
            localPointA.Round(out to->LocalPointA);
            localPointB.Round(out to->LocalPointB);
            to->Iterations = iterations;
        }
    }

    /// <summary>The fields of a result, to be written.</summary>
    private struct Fields
    {
        public GjkStatus Status;
        public float Distance, LowerBound;
        public Vector3 PointA, PointB, Normal, LocalPointA, LocalPointB;
        public int Iterations;
    }

    /// <summary>True when the status says that the shapes share a point, touching included. Where a query ended at its
    /// limit, they do if the distance is below 0.</summary>
    public bool IsOverlapping => Status == GjkStatus.Overlapping;

    /// <summary>The same answer with A and B exchanged.</summary>
    public DistanceResult Swapped
    {
        get
        {
            DistanceResult swapped = this;
            Exchange(ref swapped);
            return swapped;
        }
    }

    /// <summary>Exchanges A and B.</summary>
    internal static unsafe void Exchange(ref DistanceResult result)
    {
        fixed (DistanceResult* same = &result)
        {
            var to = (Fields*)same;
            (to->PointA, to->PointB) = (to->PointB, to->PointA);
            (to->LocalPointA, to->LocalPointB) = (to->LocalPointB, to->LocalPointA);
            to->Normal = Opposite.Of(to->Normal);
        }
    }

    /// <summary>Of a surface and a point beside it, what the solid and the point inside it have.</summary>
    internal DistanceResult Inside(float lowerBound) => new(
        GjkStatus.Overlapping, 0 - Distance, lowerBound, PointA, PointB, Opposite.Of(Normal), LocalPointA, LocalPointB,
        Iterations);

    internal DistanceResult WithLowerBound(float bound) => new(
        Status, Distance, bound, PointA, PointB, Normal, LocalPointA, LocalPointB, Iterations);

    /// <summary>The status and the fields that are valid with it, as text.</summary>
    public override string ToString()
    {
        if (Status is GjkStatus.Separated or GjkStatus.IterationLimit)
            return FormattableString.Invariant($"{Status}, {Distance:G9} from {Text(PointA)} to {Text(PointB)}");
        if (Status == GjkStatus.Overlapping && Normal != Vector3.Zero)
            return FormattableString.Invariant($"{Status} by {0 - Distance:G9}, B leaves A along {Text(Normal)}");
        if (Status == GjkStatus.Overlapping) return $"{Status} at {Text(PointA)}";
        return Status == GjkStatus.BeyondMaxDistance
            ? FormattableString.Invariant($"{Status}, more than {LowerBound:G9} along {Text(Normal)}")
            : Status.ToString();
    }

    private static string Text(Vector3 v) => ((Double3)v).ToText();

    internal static DistanceResult Invalid(GjkStatus status, int iterations)
    {
        var nan = new Vector3(float.NaN);
        return new(status, float.NaN, float.NaN, nan, nan, nan, nan, nan, iterations);
    }

    internal static DistanceResult Beyond(float lowerBound, Vector3 normal, int iterations)
    {
        var nan = new Vector3(float.NaN);
        return new(
            GjkStatus.BeyondMaxDistance, float.PositiveInfinity, lowerBound, nan, nan, normal, nan, nan, iterations);
    }
}
