namespace Gjk.Core;

/// <summary>What a query knows about its pair before it solves: B's pose in A's frame, the margins, the sizes and
/// whether all of it is valid. A's centre is the origin.</summary>
/// <remarks>It is composed once per query, in double, from the differences of the positions and rotations. Positions
/// far from the world's origin cancel before anything is rounded, and shapes far from their own local origin are
/// measured from their centres. Lengths are in solver units. One unit is <see cref="Unit"/> world units, which is 1 for
/// all pairs of ordinary size (<see cref="IsOrdinary"/>); the others are brought to unit size by a power of two, which
/// rounds nothing (<see cref="UnitSized{T}"/>).</remarks>
internal struct PairFrame
{
    /// <summary>Ratio of centres to radii: beyond it, rotating the centres in double would cost more than the promised
    /// 1e-14 of the scale, so it is done in double-double. A smaller ratio would only cost time. Pinned by
    /// PairFrameTests.CentersThatAreEightRadiiOffAreFar.</summary>
    public const double FarCenter = 4;

    /// <summary>Ratio to the centres' distances from their local origins: 2^-90, more than double-double loses when it
    /// rotates them (proofs/extended-place.g). Centres no further apart coincide. No shape with an extent is so small:
    /// its corners are floats, at least 2^-25 of the offset apart. Pinned by
    /// PairFrameTests.CentersThatNearlyCoincideDo.</summary>
    private const double ExtendedError = 1.0 / (1L << 45) / (1L << 45);

    /// <summary>Length: larger sizes and distances count as invalid input. It is far above every shape that is made of
    /// floats, and its square is a finite double. Pinned by PairFrameTests.LengthsEndAtTheLargestMagnitude.</summary>
    public const double MaxMagnitude = 1e150;

    /// <summary>Lengths: 2^-60 and 2^60. In between, the eighth power of a length, the highest that a solver forms,
    /// neither overflows nor comes near the denormal numbers. Pinned by
    /// PairFrameTests.SizesOfUpToSixtyPowersOfTwoAreOrdinary.</summary>
    private const double LeastOrdinary = 1.0 / (1L << 60), MostOrdinary = 1L << 60;

    /// <summary>B's axes in A's frame.</summary>
    public RotationD Rotation;

    /// <summary>A's axes in B's frame.</summary>
    public RotationD Inverse;

    /// <summary>A's axes in the world.</summary>
    public RotationD RotationA;

    /// <summary>From A's centre to B's, in A's frame.</summary>
    public Double3 Translation;

    /// <summary>The vertex of A - B that a point of each makes, measured from its centre in its own axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Between(in Xyz onA, in Xyz onB, out Double3 w) =>
        Rotation.Subtract(onA, onB, Translation, out w);

    /// <summary>The shapes' centres in their own frames.</summary>
    public Double3 CenterA, CenterB;

    /// <summary>The shapes' margins.</summary>
    public double MarginA, MarginB;

    /// <summary>The shapes' bounding radii, which may be generous: good for early rejections, not for
    /// tolerances.</summary>
    public double RadiusA, RadiusB;

    /// <summary>World units per solver unit: a power of two.</summary>
    public double Unit;

    /// <summary>An upper bound of every length in the frame, at most a few times the largest; NaN for invalid
    /// input.</summary>
    public double Magnitude;

    /// <summary>Whether both poses are rotations.</summary>
    private bool _areRotations;

    /// <summary>Whether a core has axes of its own in its shape's frame: those of A and B are the cores'.</summary>
    public bool IsPlaced;

    /// <summary>The rotations of the cores in the shapes' frames, if one is placed.</summary>
    private QuaternionD _turnA, _turnB;

    /// <summary>Whether both poses are rotations, and every length is finite, not negative and below the largest
    /// magnitude.</summary>
    public readonly bool IsValid =>
        _areRotations & Magnitude <= MaxMagnitude & MarginA >= 0 & MarginB >= 0 & RadiusA >= 0 & RadiusB >= 0;

    /// <summary>Whether the pair can be solved in its own units.</summary>
    public readonly bool IsOrdinary => Magnitude <= MostOrdinary & Magnitude >= LeastOrdinary;

    /// <summary>Whether a squared distance is one of a pair that can be solved in its own units.</summary>
    public static bool IsOrdinarySize(double distanceSquared) =>
        distanceSquared >= LeastOrdinary * LeastOrdinary & distanceSquared <= MostOrdinary * MostOrdinary;

#if NET
    /// <summary>Lanes of magnitudes of pairs that can be solved in their own units.</summary>
    public static Vector256<double> AreOrdinary(Vector256<double> magnitudes) =>
        Vector256.LessThanOrEqual(magnitudes, Vector256.Create(MostOrdinary))
            & Vector256.GreaterThanOrEqual(magnitudes, Vector256.Create(LeastOrdinary));
#endif

    /// <summary>Both bounding radii.</summary>
    public readonly double Radius => RadiusA + RadiusB;

    /// <summary>Both margins.</summary>
    public readonly double Margins => MarginA + MarginB;

    /// <summary>Whether both cores are points: without its margin nothing is left of either shape.</summary>
    public readonly bool ArePoints => Radius == Margins;

    /// <summary>The first search direction: from B's centre to A's, or any where they coincide.</summary>
    public readonly Double3 FirstNormal
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            Double3 normal = -Translation;
            return normal.LengthSquared > 0 ? normal : new Double3(1, 0, 0);
        }
    }

    /// <summary>Writes the frame where it is to be: a copy of its three hundred bytes would cost as much as the
    /// composition.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Compose<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out PairFrame frame)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        Fill(ref a, poseA, null, ref b, poseB, null, out frame);

    /// <summary>The same for cores of which one is placed in its shape's frame, in the cores' axes.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void ComposePlaced<TA, TB>(
        ref TA a, in RigidPose poseA, Placement? placedA, ref TB b, in RigidPose poseB, Placement? placedB,
        out PairFrame frame)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        Fill(ref a, poseA, placedA, ref b, poseB, placedB, out frame);

    /// <summary>Inlined into both: without placements the compiler leaves their branches out.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Fill<TA, TB>(
        ref TA a, in RigidPose poseA, Placement? placedA, ref TB b, in RigidPose poseB, Placement? placedB,
        out PairFrame frame)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        bool isPlaced = placedA is not null || placedB is not null;
        PoseComposition.Compose(
            poseA, poseB, placedA, placedB, out frame.RotationA, out frame.Rotation, out frame.Inverse,
            out frame._areRotations);
        Double3 centerA = a.Center, centerB = b.Center;
        UnsafeRef.SkipInit(out frame._turnA);
        UnsafeRef.SkipInit(out frame._turnB);
        if (placedA is not null || placedB is not null)
        {
            ToCore(placedA, ref frame._turnA, ref centerA);
            ToCore(placedB, ref frame._turnB, ref centerB);
        }

        Double3.Write(centerA.X, centerA.Y, centerA.Z, out frame.CenterA);
        Double3.Write(centerB.X, centerB.Y, centerB.Z, out frame.CenterB);
        frame.RadiusA = a.BoundingRadius;
        frame.RadiusB = b.BoundingRadius;
        frame.MarginA = a.Margin;
        frame.MarginB = b.Margin;
        frame.Unit = 1;
        frame.IsPlaced = isPlaced;
        double radius = frame.RadiusA + frame.RadiusB, offset = centerA.SumOfMagnitudes + centerB.SumOfMagnitudes;
        if (offset == 0 || !(offset > FarCenter * TightRadius<TA, TB>(frame.RadiusA, frame.RadiusB)))
        {
            Double3.Between(poseA.Position, poseB.Position, out Double3 between);
            frame.RotationA.InverseRotate(between, out double x, out double y, out double z);
            if (offset != 0 || isPlaced)
            {
                frame.Rotation.Rotate(centerB, out double toX, out double toY, out double toZ);
                x += toX - centerA.X;
                y += toY - centerA.Y;
                z += toZ - centerA.Z;
            }

            Double3.Write(x, y, z, out frame.Translation);
        }
        else
        {
            Double3 far = BetweenFarCenters(poseA, poseB, a.Center, b.Center, placedA, placedB);
            frame.Translation = frame.RotationA.InverseRotate(far);
        }

        frame.Magnitude = radius + (frame.MarginA + frame.MarginB) + frame.Translation.SumOfMagnitudes;
    }

    /// <summary>The sum of the bounding radii that are tight.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double TightRadius<TA, TB>(double radiusA, double radiusB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        (ShapeTraits<TA>.AreTight ? radiusA : 0) + (ShapeTraits<TB>.AreTight ? radiusB : 0);

    /// <summary>The power of two that brings the magnitude to between 1 and 2.</summary>
    public readonly double UnitFactor => Magnitude > 0 ? 1 / PowerOfTwo.AtMost(Magnitude) : 1;

    /// <summary>Measures the shapes whose bounding radii may be generous, by a support in each direction of each axis.
    /// What takes a tolerance or a band from the radii begins with it.</summary>
    public void TightenRadii<TA, TB>(ref TA a, ref TB b)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (ShapeTraits<TA>.AreTight && ShapeTraits<TB>.AreTight) return;
        if (!ShapeTraits<TA>.AreTight) Tighten(ref a, MarginA, ref RadiusA);
        if (!ShapeTraits<TB>.AreTight) Tighten(ref b, MarginB, ref RadiusB);
        Magnitude = RadiusA + RadiusB + (MarginA + MarginB) + Translation.SumOfMagnitudes;
    }

    private static void Tighten<T>(ref T shape, double margin, ref double radius)
        where T : struct, ISupportMap
    {
        T core = ShapeTraits<T>.Instance.InCoreAxes(shape);
        radius = Math.Min(radius, CoreExtent.Radius(ref core) + margin);
    }

    /// <summary>The frame in units in which its magnitude is between 1 and 2, for <see cref="UnitSized{T}"/>
    /// shapes.</summary>
    public void ToUnitSize(double factor)
    {
        Translation *= factor;
        CenterA *= factor;
        CenterB *= factor;
        MarginA *= factor;
        MarginB *= factor;
        RadiusA *= factor;
        RadiusB *= factor;
        Magnitude *= factor;
        Unit = 1 / factor;
    }

    /// <summary>A point of A's core and the margin along a unit normal, in the world, with A at a position.</summary>
    public readonly Double3 SurfaceOfA(in Double3 onCore, in Double3 normal, in Double3 position) =>
        RotationA.Rotate((onCore + normal * MarginA + CenterA) * Unit) + position;

    /// <summary>From A's centre to B's, in the world's axes, as exact as the poses are.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double3 BetweenCenters(
        in RigidPose poseA, in Double3 centerA, in RigidPose poseB, in Double3 centerB)
    {
        if (centerA.SumOfMagnitudes + centerB.SumOfMagnitudes != 0)
            return BetweenFarCenters(poseA, poseB, centerA, centerB, null, null);
        Double3.Between(poseA.Position, poseB.Position, out Double3 between);
        return between;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Double3 BetweenFarCenters(
        in RigidPose poseA, in RigidPose poseB, in Double3 inA, in Double3 inB, Placement? placedA, Placement? placedB)
    {
        VectorDD centerA = placedA?.ExactCenter ?? inA, centerB = placedB?.ExactCenter ?? inB;
        VectorDD between = (VectorDD)(Double3)poseB.Position - (Double3)poseA.Position;
        between += VectorDD.Rotate(poseB.Rotation, centerB) - VectorDD.Rotate(poseA.Rotation, centerA);
        var rounded = (Double3)between;
        double error = ExtendedError * (((Double3)centerA).SumOfMagnitudes + ((Double3)centerB).SumOfMagnitudes);
        return rounded.SumOfMagnitudes > error ? rounded : default;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void ToCore(Placement? placed, ref QuaternionD turn, ref Double3 center)
    {
        turn = (placed ?? Placement.None).UnitRotation;
        if (placed is not null) center = placed.CenterInCore;
    }

    /// <summary>The rotation of A's core in A's frame; null where neither core is placed.</summary>
    public readonly QuaternionD? TurnOfA => IsPlaced ? _turnA : null;

    /// <summary>The rotation of B's core in B's frame; null where neither core is placed.</summary>
    public readonly QuaternionD? TurnOfB => IsPlaced ? _turnB : null;

    /// <summary>A point or direction in the axes of A's core, in A's frame, if one of the cores is placed.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public readonly Xyz OutOfA(Xyz v) => _turnA.Rotate(v);

    /// <summary>The same for B's core.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public readonly Xyz OutOfB(Xyz v) => _turnB.Rotate(v);
}
