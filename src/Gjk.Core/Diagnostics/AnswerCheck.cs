namespace Gjk.Core.Diagnostics;

/// <summary>Checks an answer of <see cref="ConvexQuery"/>, without its solvers: proved, refuted or open, with bounds
/// that hold whatever the answer says. For those who must not trust a solver.</summary>
/// <remarks>
/// <para>
/// What is proved, is proved by two kinds of witness. A direction: two supports show that the shapes are no nearer than
/// the planes across it. Two points that are weighted means of supports: the shapes are no further apart than these.
/// What is trusted are the shapes' supports and margins, the poses, and double arithmetic, whose rounding is bounded.
/// The answer's normal says where to look first; a walk of its own looks further, and may fail: then it says
/// <see cref="CheckStatus.Open"/>.
/// </para>
/// <para>
/// All that an answer says is held to it: the number, the lower bound, the normal, and that the points lie on their
/// shapes and differ by the distance along the normal. Nothing is allocated, nothing is thrown, and every check ends
/// after at most some hundreds of supports.
/// </para>
/// </remarks>
public static partial class AnswerCheck
{
    /// <summary>Ratio to the distance: its rounding to float, 2^-24 and then some, as promised. Pinned by
    /// AnswerToleranceTests.</summary>
    private const double DistanceRatio = 1.2e-7;

    /// <summary>Length, as a fraction of the size: ten times the promised 1e-14, since the check's own rounding comes
    /// on top. Shapes that are nearer share a point as far as it can tell. Pinned by AnswerToleranceTests.</summary>
    private const double LengthRatio = 1e-13;

    /// <summary>Length, as a fraction of the larger of the size and the distance: what is promised for curved cores.
    /// The size is at least half the scale that promises are measured by, so it is doubled. Pinned by
    /// AnswerToleranceTests.</summary>
    private const double CurvedRatio = 2e-6;

    /// <summary>Length, as a fraction of the size: curved shapes that are nearer touch, as is promised, 1e-9 of the
    /// scale. Pinned by AnswerToleranceTests.</summary>
    private const double CurvedTouch = 2e-9;

    /// <summary>Lengths, as fractions of the size: shapes that overlap by about as much may not be said to be apart;
    /// 1e-9 of the scale is promised, of curved cores 1e-6. Pinned by AnswerToleranceTests.</summary>
    private const double Deep = 1e-8, CurvedDeep = 1e-5;

    /// <summary>Ratio to what counts as touching: a tetrahedron with corners so far out holds a ball of several times
    /// that. Two would do; a larger one refutes less.</summary>
    private const double BallRatio = 8;

    /// <summary>Length, as a fraction of the size: how far a point may be off its shape beside its rounding to float;
    /// 1.2e-7 of the scale is promised. Pinned by AnswerToleranceTests.</summary>
    private const double PointRatio = 2.4e-7;

    /// <summary>Length, as a fraction of size and distance: by how much the planes across a normal that was rounded to
    /// float can be nearer: 1.1e-7 radians times the width, which is at most twice the size. Pinned by
    /// AnswerToleranceTests.</summary>
    private const double TiltRatio = 3e-7;

    /// <summary>A pure number: how far a normal's length may be from 1. Pinned by AnswerToleranceTests.</summary>
    private const double UnitLength = 1e-6;

    /// <summary>Ratio: what rounding a point's three coordinates to float can move it by.</summary>
    private const double FloatRatio = 1.0 / (1 << 24);

    /// <summary>Ratio: what the way from the world into a local frame can move a point by in double, some ten
    /// roundings. It is seen only where both shapes are points, and a larger one is as good.</summary>
    private const double DoubleRatio = 32 * RoundOff.Unit;

    /// <summary>Length: below it a float has no digits; the least one is 1.4e-45.</summary>
    private const double LeastFloat = 1.5e-45;

    /// <summary>Checks whether two shapes overlap, touching included.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="answer">What was said.</param>
    /// <returns>Bounds of the signed distance. Shapes that are nearer than 1e-13 of their size (curved: 2e-9) may be
    /// said to overlap: that is open where a plane proves them apart, and else proved; that they do not is open
    /// then.</returns>
    public static CheckedAnswer Overlaps<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, bool answer)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        TA shapeA = a;
        TB shapeB = b;
        PosedPair.Of(ref shapeA, poseA, ref shapeB, poseB, out PosedPair pair);
        double touch = Touch(pair);
        WitnessWalk walk = WitnessWalk.Of(ref shapeA, ref shapeB, pair, default, double.NegativeInfinity, touch);
        var claims = default(AnswerClaims);
        if (answer) claims.Add(walk.Upper <= touch && walk.Lower <= 0, walk.Lower > touch);
        else claims.Add(walk.Lower > 0, IsDeep(ref shapeA, ref shapeB, pair, walk));
        return new CheckedAnswer(claims.Status, walk.Lower, walk.Upper);
    }

    /// <summary>How far apart shapes may be that count as touching.</summary>
    private static double Touch(in PosedPair pair) =>
        (pair.IsCurved ? CurvedTouch : LengthRatio) * pair.Size + 2 * pair.Noise;

    /// <summary>How much a distance may be off.</summary>
    private static double Allowed(in PosedPair pair, double distance) => LeastFloat + 2 * pair.Noise + (pair.IsCurved
        ? CurvedRatio * Math.Max(pair.Size, Math.Abs(distance))
        : DistanceRatio * Math.Abs(distance) + LengthRatio * pair.Size);

    /// <summary>How far a point may be off its shape, and the points' difference off the distance.</summary>
    private static double PointSlack(in PosedPair pair, double distance) => 4 * LeastFloat + (pair.IsCurved
        ? CurvedRatio * Math.Max(pair.Size, Math.Abs(distance))
        : PointRatio * pair.Size);

    /// <summary>A local point lies in a shape.</summary>
    private static void AddPoint<T>(ref AnswerClaims claims, ref T shape, in Double3 local, double slack)
        where T : struct, ISupportMap
    {
        PosedPair.OfPoint(ref shape, local, out PosedPair pair);
        PointShape point = default;
        WitnessWalk walk = WitnessWalk.Of(ref shape, ref point, pair, default, double.NegativeInfinity, slack);
        claims.Add(walk.Upper <= slack, walk.Lower > slack);
    }

    /// <summary>Whether the shapes overlap by more than any rounding, that of a depth to float included: a ball lies in
    /// their difference, since the corners of a regular tetrahedron do.</summary>
    private static bool IsDeep<TA, TB>(ref TA a, ref TB b, in PosedPair pair, in WitnessWalk walk)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double touch = Touch(pair);
        double reach = Math.Max(LeastFloat + (pair.IsCurved ? CurvedDeep : Deep) * pair.Size, BallRatio * touch);
        return walk.Upper <= touch
            && IsTouching(ref a, ref b, pair, new Double3(reach, reach, reach), touch)
            && IsTouching(ref a, ref b, pair, new Double3(reach, -reach, -reach), touch)
            && IsTouching(ref a, ref b, pair, new Double3(-reach, reach, -reach), touch)
            && IsTouching(ref a, ref b, pair, new Double3(-reach, -reach, reach), touch);
    }

    private static bool IsTouching<TA, TB>(ref TA a, ref TB b, in PosedPair pair, in Double3 by, double touch)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        WitnessWalk.Of(
            ref a, ref b, pair.Moved(by, pair.Sweep), default, double.NegativeInfinity, touch).Upper <= touch;

    /// <summary>Whether a vector is there where there is nothing to tell.</summary>
    private static bool IsNothing(Vector3 v) => float.IsNaN(v.X) && float.IsNaN(v.Y) && float.IsNaN(v.Z);

    /// <summary>A normal is of unit length.</summary>
    private static bool IsUnit(in Double3 normal) => Math.Abs(normal.Length - 1) <= UnitLength;
}
