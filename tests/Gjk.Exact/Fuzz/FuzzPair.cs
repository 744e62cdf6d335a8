using System.Diagnostics.CodeAnalysis;

namespace Gjk.Exact.Fuzz;

/// <summary>Two posed shapes and the library's cold answer for them: what a promise is held to.</summary>
internal sealed class FuzzPair
{
    private readonly FuzzShape _a, _b;
    private FuzzTruth? _truth;
    private DistanceResult? _signed;
    private CastResult? _cast;
    private FuzzSweep? _sweep;

    public FuzzPair(in FuzzShape a, in RigidPose poseA, in FuzzShape b, in RigidPose poseB)
        : this(a, poseA, b, poseB, ConvexQuery.Distance(a.Shape, poseA, b.Shape, poseB))
    {
    }

    /// <summary>With answers from elsewhere, which may be wrong.</summary>
    public FuzzPair(
        in FuzzShape a, in RigidPose poseA, in FuzzShape b, in RigidPose poseB, in DistanceResult answer,
        in DistanceResult? signed = null)
    {
        (_a, PoseA, _b, PoseB) = (a, poseA, b, poseB);
        Answer = answer;
        _signed = signed;
        BodyA = new PosedShape(a, poseA);
        BodyB = new PosedShape(b, poseB);
        double side = Math.Max(BodyA.LongestSide, BodyB.LongestSide);
        Scale = side > 0 ? side : float.IsFinite(Answer.Distance) ? Answer.Distance : 0;
        Centers = Between(BodyA.Center, BodyB.Center);
        Noise = Accuracy.Rounding * (BodyA.LongestSide + BodyB.LongestSide + Centers.Length);
    }

    /// <summary>The same pair, that moves, with a cast from elsewhere if one is given, which may be wrong.</summary>
    private FuzzPair(FuzzPair atRest, in PairMotion motion, in CastResult? cast)
    {
        (_a, PoseA, _b, PoseB) = (atRest._a, atRest.PoseA, atRest._b, atRest.PoseB);
        (Answer, _signed, _truth) = (atRest.Answer, atRest._signed, atRest._truth);
        (BodyA, BodyB, Scale) = (atRest.BodyA, atRest.BodyB, atRest.Scale);
        (Centers, Noise) = (atRest.Centers, atRest.Noise);
        Motion = motion;
        _cast = cast;
    }

    public ConvexShape A => _a.Shape;

    public ConvexShape B => _b.Shape;

    public RigidPose PoseA { get; }

    public RigidPose PoseB { get; }

    /// <summary>What the cold query says.</summary>
    public DistanceResult Answer { get; }

    /// <summary>What the cold query of the signed distance says, asked when it is first needed.</summary>
    public DistanceResult Signed => _signed ??= ConvexQuery.SignedDistance(A, PoseA, B, PoseB);

    /// <summary>How the shapes move over the fractions from 0 to 1; they do not turn.</summary>
    public PairMotion Motion { get; }

    /// <summary>What the cold query of the cast says, asked when it is first needed.</summary>
    public CastResult Cast => _cast ??= ConvexQuery.Cast(A, PoseA, Motion.A, B, PoseB, Motion.B);

    /// <summary>The distance along the motion.</summary>
    public FuzzSweep Sweep => _sweep ??= new FuzzSweep(this);

    public PosedShape BodyA { get; }

    public PosedShape BodyB { get; }

    /// <summary>The true distance, solved when it is first asked for.</summary>
    public FuzzTruth Truth => _truth ??= new FuzzTruth(this);

    /// <summary>The longest side of the local bounding boxes, the larger of the two; of two points, their
    /// distance.</summary>
    public double Scale { get; }

    public bool IsCurved => BodyA.IsCurved || BodyB.IsCurved;

    /// <summary>From A's centre to B's, in the world's axes, to the last place of a double.</summary>
    public Double3 Centers { get; }

    /// <summary>What rounding may do to a length computed here from the shapes' sizes and the distance of their
    /// centres.</summary>
    public double Noise { get; }

    /// <summary>The pair as a line that <c>query --record</c> reads; its meshes are all the points that they were made
    /// of.</summary>
    public string Text =>
        FuzzText.Of(_a, new RigidMotion(PoseA, Motion.A), _b, new RigidMotion(PoseB, Motion.B));

    /// <summary>How much a distance may be off.</summary>
    public double Band(double distance) => Unavoidable + (IsCurved
        ? Accuracy.CurvedRatio * Math.Max(Scale, distance)
        : Accuracy.DistanceRatio * distance + Accuracy.DistanceScale * Scale);

    /// <summary>What even shapes without extent cannot be held to: corners far from their local origin are turned in
    /// 106 bits, and floats end.</summary>
    private double Unavoidable => Accuracy.LeastFloat + Accuracy.Offset * (BodyA.Center.Length + BodyB.Center.Length);

    /// <summary>How far a point of the answer may be off its own shape, before it is rounded to float.</summary>
    /// <param name="body">The shape that it belongs to.</param>
    public double WitnessSlack(PosedShape body) =>
        IsCurved ? CurvedSlack : Accuracy.WitnessScale * body.LongestSide + Accuracy.DistanceScale * Scale;

    /// <summary>How far the difference of the points may be off normal times distance, before they are rounded to
    /// float.</summary>
    public double DifferenceSlack => IsCurved ? CurvedSlack : Accuracy.WitnessScale * Scale;

    private double CurvedSlack =>
        Accuracy.CurvedRatio * Math.Max(Scale, float.IsFinite(Answer.Distance) ? Answer.Distance : 0);

    /// <summary>Reads a record; false for what <see cref="FuzzText.TryRead"/> refuses, and for half-spaces.</summary>
    public static bool TryParse(string text, [NotNullWhen(true)] out FuzzPair? pair)
    {
        pair = null;
        if (!FuzzText.TryRead(text, out FuzzShape a, out FuzzShape b, out QueryRecord record)) return false;
        if (a.Kind == ShapeKind.HalfSpace || b.Kind == ShapeKind.HalfSpace) return false;
        pair = new FuzzPair(a, record.PoseA, b, record.PoseB)
            .Moving(new PairMotion(record.MotionA.Velocity, record.MotionB.Velocity));
        return true;
    }

    /// <summary>How far apart the planes across a unit direction of the world stand that touch A and B; negative where
    /// the shapes reach past each other.</summary>
    public double Gap(in Double3 n) => Double3.Dot(n, Centers) - BodyA.Height(n) - BodyB.Height(-n);

    /// <summary>From a point in A's frame to one in B's, in the world's axes, to the last place of a double.</summary>
    public Double3 Between(in Double3 localA, in Double3 localB) =>
        new ExactProblem([localB], 0, PoseB, [localA], 0, PoseA).FirstVertex();

    /// <summary>The same pair with another motion.</summary>
    /// <param name="motion">The motion.</param>
    /// <param name="cast">An answer from elsewhere, which may be wrong; null: the query's own.</param>
    public FuzzPair Moving(in PairMotion motion, in CastResult? cast = null) => new(this, motion, cast);

    /// <summary>The same shapes in other places.</summary>
    public FuzzPair At(in RigidPose poseA, in RigidPose poseB) => new(_a, poseA, _b, poseB);
}
