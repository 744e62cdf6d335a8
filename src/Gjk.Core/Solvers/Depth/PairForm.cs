namespace Gjk.Core;

/// <summary>What the forms of two shapes say about their depth before anything is searched. A point leaves an ellipsoid
/// in a direction that is known; two bodies of revolution whose axes are parallel, such as a pin in its hole, leave
/// each other in a plane that is known; and of two hulls the facets are known.</summary>
internal readonly struct PairForm(in BodyForm a, in BodyForm b, in PairFrame frame)
{
    /// <summary>Length, as a fraction of the size: axes count as parallel when turning the smaller body until they are
    /// moves no point of it further. The rounding of two quaternions does that. Twice it, and what the search in the
    /// plane leaves, are below the promise of 1e-6. Pinned by CoaxialDepthTests.</summary>
    public const double Parallel = 1e-7;

    /// <summary>Length, as a fraction of the size: bodies are nearly coaxial when that and the gap between their axes
    /// are less. Beyond, the general search has room for the valley of ways out around the axis; four times less leaves
    /// pairs that it has no room for, and four times more holds, too. Pinned by LeaningDepthTests.</summary>
    private const double NearlyCoaxial = 4e-2;

    /// <summary>What is known of the way out.</summary>
    public readonly WayOut Way = a.IsRound && b.IsRound && (a.IsCurved || b.IsCurved) ? WayOf(a, b, frame) : default;

    /// <summary>Both shapes' forms.</summary>
    public readonly BodyForm A = a, B = b;

    /// <summary>Whether their Minkowski difference has no facets but those of hulls.</summary>
    public bool AreFaceted =>
        (A.Hull is not null || A.IsPoint) && (B.Hull is not null || B.IsPoint) && (A.Hull ?? B.Hull) is not null;

    /// <summary>Whether one is curved and round, and the other has corners.</summary>
    public bool AreRoundAndCornered =>
        (A.IsRound && A.IsCurved && B.CornerCount > 0) || (B.IsRound && B.IsCurved && A.CornerCount > 0);

    /// <summary>Whether one is an ellipsoid.</summary>
    public bool HasEllipsoid => A.Radii != default || B.Radii != default;

    /// <summary>Finds what the forms of a pair say.</summary>
    /// <param name="a">The first shape, in world units.</param>
    /// <param name="b">The second shape, in world units.</param>
    /// <param name="frame">Where B is, seen from A; its units are the form's.</param>
    /// <param name="form">What is known then.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Classify<TA, TB>(ref TA a, ref TB b, in PairFrame frame, out PairForm form)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        BodyForm.Get(ref a, frame.Unit, out BodyForm formA);
        BodyForm.Get(ref b, frame.Unit, out BodyForm formB);
        form = new PairForm(formA, formB, frame);
    }

    private static WayOut WayOf(in BodyForm a, in BodyForm b, in PairFrame frame) =>
        !a.HasNoAxis && !b.HasNoAxis ? AlongAxes(a, b, frame)
            : a.IsPoint || b.IsPoint ? OutOfEllipsoid(a, b, frame, frame.Translation, default, false) : default;

    /// <summary>The ways out of a round body across one corner of the other body, or across an edge: a direction, or
    /// half a circle of them. Where points beside the corner have none that is shorter, it is among both.</summary>
    /// <param name="frame">Where B is, seen from A.</param>
    /// <param name="offset">From A's centre to the corner of B, or from that of A to B's centre.</param>
    /// <param name="edge">Along the edge, of unit length; 0 for a corner.</param>
    /// <param name="isOther">Asks for the second such direction, or the other half.</param>
    public WayOut WayAcross(in PairFrame frame, in Double3 offset, in Double3 edge, bool isOther)
    {
        if (HasEllipsoid) return OutOfEllipsoid(A, B, frame, offset, edge, isOther);
        Double3 axis = A.IsCurved ? Unit(A.Axis) : frame.Rotation.Rotate(Unit(B.Axis)), across = offset;
        if (edge != default) new PlaneBasis(edge).Deconstruct(out axis, out across);
        return WayOut.Along(axis, isOther ? -across : across, 0, default, default);
    }

    /// <summary>The way of a point out of an ellipsoid, or that of a line; none where that is flat.</summary>
    private static WayOut OutOfEllipsoid(
        in BodyForm a, in BodyForm b, in PairFrame frame, in Double3 offset, in Double3 edge, bool isOther)
    {
        bool isA = a.Radii != default;
        Double3 radii = isA ? a.Radii : b.Radii;
        if (!(radii.X > 0 && radii.Y > 0 && radii.Z > 0)) return default;
        var turn = new RotationD(isA ? a.Turn : b.Turn);
        Double3 point = turn.InverseRotate(isA ? offset : frame.Rotation.InverseRotate(-offset));
        Double3 along = turn.InverseRotate(isA ? edge : frame.Rotation.InverseRotate(edge));
        Double3 way = turn.Rotate(edge == default
            ? EllipsoidNormal.Nearest(radii, point, isOther)
            : EllipsoidNormal.Nearest(radii, point, along, isOther));
        return WayOut.In(isA ? way : -frame.Rotation.Rotate(way));
    }

    private static WayOut AlongAxes(in BodyForm a, in BodyForm b, in PairFrame frame)
    {
        double radiusA = frame.RadiusA - frame.MarginA, radiusB = frame.RadiusB - frame.MarginB;
        Double3 axisA = Unit(a.Axis), axisB = frame.Rotation.Rotate(Unit(b.Axis));
        Double3 axis = axisA == default || (axisB != default && radiusB > radiusA) ? axisB : axisA;
        if (axis == default) axis = new Double3(0, 1, 0);
        if (Double3.Dot(axisA, axis) < 0) axisA = -axisA;
        if (Double3.Dot(axisB, axis) < 0) axisB = -axisB;
        Double3 leanA = axisA == default ? default : axisA - axis, leanB = axisB == default ? default : axisB - axis;
        double moved = Math.Max(leanA.Length, leanB.Length) * Math.Min(radiusA, radiusB);
        if (moved <= Parallel * frame.Radius) return WayOut.Along(axis, frame.Translation, 0, default, default);
        double slope = moved + Double3.Cross(axis, frame.Translation).Length;
        return slope <= NearlyCoaxial * frame.Radius
            ? WayOut.Along(axis, frame.Translation, slope, leanA, leanB)
            : default;
    }

    private static Double3 Unit(in Double3 axis)
    {
        double length = axis.Length;
        return length > 0 ? axis * (1 / length) : default;
    }
}

/// <summary>What the forms of two shapes say about the shortest way out of each other before anything is searched: its
/// direction, or a plane that it lies in; the default says nothing. In A's axes.</summary>
internal readonly struct WayOut(in Double3 across, in Double3 axis, double slope, in Double3 leanA, in Double3 leanB)
{
    /// <summary>Ratio, squared, of the offset's part across the axis to all of it: 2^-100, far below what rounding does
    /// to it. Shapes whose axes are so near each other may leave each other in any plane. Any amount below rounding
    /// will do.</summary>
    private const double Coaxial = 1.0 / (1L << 50) / (1L << 50);

    /// <summary>Of unit length: the direction, or the side of the plane's axis that the way out lies on.</summary>
    public readonly Double3 Across = across;

    /// <summary>Of unit length: the plane's axis; 0 where the direction is known.</summary>
    public readonly Double3 Axis = axis;

    /// <summary>Length per radian: how much the shortest way out in such a plane may change as the plane turns about
    /// its axis; 0 where the way out is in this one.</summary>
    public readonly double Slope = slope;

    /// <summary>Both bodies' unit axes, less the plane's.</summary>
    private readonly Double3 _leanA = leanA, _leanB = leanB;

    /// <summary>Whether anything is known.</summary>
    public bool IsKnown => Across != default;

    /// <summary>Whether all of it is known.</summary>
    public bool IsDirection => Axis == default;

    /// <summary>A direction of the plane.</summary>
    public Double3 At(double across, double along) => Across * across + Axis * along;

    /// <summary>The direction is known.</summary>
    public static WayOut In(in Double3 direction) => new(direction, default, 0, default, default);

    /// <summary>The way out is in a plane along an axis: the one towards B where the slope is 0, else in any.</summary>
    /// <param name="axis">Of unit length.</param>
    /// <param name="offset">From A's centre to B's.</param>
    /// <param name="slope">See <see cref="Slope"/>.</param>
    /// <param name="leanA">A's unit axis, less the plane's.</param>
    /// <param name="leanB">The same of B.</param>
    public static WayOut Along(in Double3 axis, in Double3 offset, double slope, in Double3 leanA, in Double3 leanB)
    {
        Double3 across = offset - axis * Double3.Dot(axis, offset);
        bool isAcross = across.LengthSquared > Coaxial * offset.LengthSquared;

        // Of a short rest of a long offset rounding leaves something along the axis.
        if (isAcross) across *= 1 / across.Length;
        across -= axis * Double3.Dot(axis, across);
        return new WayOut(isAcross ? across * (1 / across.Length) : new PlaneBasis(axis).U, axis, slope, leanA, leanB);
    }

    /// <summary>The same plane, turned about its axis.</summary>
    public WayOut Turned(double angle)
    {
        SineCosine.Compute(angle, out double sine, out double cosine);
        return new WayOut(Across * cosine + Double3.Cross(Axis, Across) * sine, Axis, Slope, _leanA, _leanB);
    }

    /// <summary>How a point of A - B moves against the plane as the plane turns, when each body turns about its own
    /// axis by as much, which changes neither. What is left of a Taylor series behind its first, second and third term
    /// is at most the slope times the angle, its square, and two thirds of its cube.</summary>
    /// <param name="onA">The point of A, from its centre.</param>
    /// <param name="onB">The point of B, from its own, in A's axes.</param>
    /// <param name="offset">From A's centre to B's.</param>
    /// <param name="moved">Its first derivative.</param>
    /// <param name="bent">Its second one.</param>
    public void Follow(in Double3 onA, in Double3 onB, in Double3 offset, out Double3 moved, out Double3 bent)
    {
        Double3 movedA = Double3.Cross(_leanA, onA), movedB = Double3.Cross(_leanB, onB);
        Double3 movedOffset = Double3.Cross(Axis, offset);
        moved = movedA - movedB + movedOffset;
        bent = Double3.Cross(_leanA, Double3.Cross(Axis + _leanA, onA))
            - Double3.Cross(_leanB, Double3.Cross(Axis + _leanB, onB))
            - Double3.Cross(Axis, moved);
    }
}
