using System.Globalization;
using System.Threading;
using Gjk.Exact.Fuzz.Promises;
using Gjk.Exact.Fuzz.Shrinking;

namespace Gjk.Exact.Fuzz.HalfSpaces;

/// <summary>A half-space and a posed shape that may move, and the true gap between them: that of the shape's furthest
/// point against the normal, in integers of any size where the shape has vertices.</summary>
internal sealed class HalfSpacePair
{
    private readonly FuzzShape _plane, _other;
    private readonly PosedShape _body;
    private readonly Double3 _normal, _rounding;
    private readonly double _offset, _offsetRounding;
    private DistanceResult? _signed;

    public HalfSpacePair(
        in FuzzShape plane, in RigidPose planePose, in FuzzShape other, in RigidPose pose, in PairMotion motion)
    {
        (_plane, PlanePose, _other, Pose, Motion) = (plane, planePose, other, pose, motion);
        _body = new PosedShape(other, pose);
        double[] n = [.. ShapeWords.Of(plane.Shape).Numbers.Select(w => double.Parse(w, CultureInfo.InvariantCulture))];
        (_normal, _offset) = (new Double3(n[0], n[1], n[2]), n[3]);

        // What was decorated has a normal and an offset of two doubles each.
        if (n.Length > 4) (_offsetRounding, _rounding) = (n[4], new Double3(n[^3], n[^2], n[^1]));
        Outward = new ApproximateRotation(planePose.Rotation).Rotate(_normal * (1 / _normal.Length));
        Gap = IsCurved
            ? Height([_body.Center], pose) - _body.Height(-Outward)
            : Height(_body.Vertices, pose) - _body.Margin;
    }

    public ConvexShape Plane => _plane.Shape;

    public ConvexShape Other => _other.Shape;

    public RigidPose PlanePose { get; }

    public RigidPose Pose { get; }

    public PairMotion Motion { get; }

    /// <summary>Out of the half-space, of unit length, in the world.</summary>
    public Double3 Outward { get; }

    /// <summary>The true signed distance, to double rounding.</summary>
    public double Gap { get; }

    public bool IsCurved => _body.IsCurved;

    /// <summary>The longest side of the other's local bounding box.</summary>
    public double Scale => _body.LongestSide;

    /// <summary>What the query of the signed distance says, asked when it is first needed.</summary>
    public DistanceResult Signed => _signed ??= ConvexQuery.SignedDistance(Plane, PlanePose, Other, Pose);

    /// <summary>The pair as a line that <c>query --record</c> reads.</summary>
    public string Text => FuzzText.Of(_plane, new(PlanePose, Motion.A), _other, new(Pose, Motion.B));

    /// <summary>How much a gap may be off, but for its rounding to float.</summary>
    public double Noise => Accuracy.LeastFloat + (Accuracy.DistanceScale + (IsCurved ? Accuracy.Rounding : 0)) * Scale
        + Accuracy.Offset * (_body.Center.Length + Math.Abs(_offset / _normal.Length)
            + ((Double3)Pose.Position - PlanePose.Position).Length);

    public static HalfSpacePair Shrink(HalfSpacePair pair, Promise<HalfSpacePair> promise, CancellationToken cancel) =>
        Shrinker.Shrink(pair, pair.Text, Read, promise, cancel);

    /// <summary>Null where the text is no record of a half-space and another shape, in this order.</summary>
    public static HalfSpacePair? Read(string text) =>
        FuzzText.TryRead(text, out FuzzShape a, out FuzzShape b, out QueryRecord record)
        && a.Kind == ShapeKind.HalfSpace && b.Kind != ShapeKind.HalfSpace
            ? new(a, record.PoseA, b, record.PoseB, new(record.MotionA.Velocity, record.MotionB.Velocity))
            : null;

    /// <summary>With an answer from elsewhere, which may be wrong.</summary>
    public HalfSpacePair Answered(in DistanceResult signed) =>
        new(_plane, PlanePose, _other, Pose, Motion) { _signed = signed };

    /// <summary>The other elsewhere, with another motion.</summary>
    public HalfSpacePair At(Vector3 position, in PairMotion motion) =>
        new(_plane, PlanePose, _other, new RigidPose(Pose.Rotation, position), motion);

    /// <summary>How far a point of the world is out of the half-space, to double rounding.</summary>
    public double HeightOf(Vector3 point) => Height([default], new RigidPose(point));

    /// <summary>How fast a motion leaves the half-space, to double rounding.</summary>
    public double RateOf(in Double3 motion) =>
        Height(new RigidPose(PlanePose.Rotation, default), [motion], RigidPose.Identity);

    private double Height(Double3[] points, in RigidPose pose) =>
        Height(PlanePose, points, pose, _offset, _offsetRounding);

    /// <summary>The least height of points over a plane, in integers but for the normal's length.</summary>
    private double Height(in RigidPose plane, Double3[] points, in RigidPose pose, params ReadOnlySpan<double> offsets)
    {
        var problem = new ExactProblem([default, _normal, _rounding], 0, plane, points, 0, pose);
        Int3 zero = problem.Vertex(0, 0), normal = problem.Vertex(1, 0) - zero + (problem.Vertex(2, 0) - zero);
        BigInteger least = Enumerable.Range(0, points.Length).Min(i => Int3.Dot(normal, -problem.Vertex(0, i)));
        BigInteger square = problem.Denominator * problem.Denominator;
        int exponent = 2 * problem.Exponent, common = exponent;
        foreach (double offset in offsets) common = Math.Min(common, Dyadic.Exponent(offset));
        least <<= exponent - common;
        foreach (double offset in offsets) least -= Dyadic.ToInteger(offset, common) * square;
        return Dyadic.ToDouble(least, square, common) / _normal.Length;
    }
}
