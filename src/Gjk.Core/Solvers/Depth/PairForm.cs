namespace Gjk.Core;

/// <summary>What the forms of two shapes say about their depth before anything is searched. A point leaves an ellipsoid
/// in a direction that is known; two bodies of revolution whose axes are parallel, such as a pin in its hole, leave
/// each other in a plane that is known; and of two hulls the facets are known.</summary>
internal readonly struct PairForm
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
    public readonly WayOut Way;

    /// <summary>Both shapes' forms.</summary>
    public readonly BodyForm A, B;

    /// <summary>Whether their Minkowski difference has no facets but those of hulls.</summary>
    public bool AreFaceted =>
        (A.Hull is not null || A.IsPoint) && (B.Hull is not null || B.IsPoint) && (A.Hull ?? B.Hull) is not null;

    /// <summary>Whether one is curved and round, and the other has corners.</summary>
    public bool AreRoundAndCornered =>
        (A.IsRound && A.IsCurved && B.CornerCount > 0) || (B.IsRound && B.IsCurved && A.CornerCount > 0);

    /// <summary>Whether one is an ellipsoid.</summary>
    public bool HasEllipsoid => A.Radii != default || B.Radii != default;

    private PairForm(in BodyForm a, in BodyForm b, in PairFrame frame)
    {
        A = a;
        B = b;
        bool areRound = a.IsRound && b.IsRound && (a.IsCurved || b.IsCurved);
        Way = areRound ? WayOf(a, b, frame) : default;
    }

    /// <summary>Looks at a pair.</summary>
    /// <param name="a">The first shape, in world units.</param>
    /// <param name="b">The second shape, in world units.</param>
    /// <param name="frame">Where B is, seen from A; its units are the form's.</param>
    /// <param name="form">What is known then.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Look<TA, TB>(ref TA a, ref TB b, in PairFrame frame, out PairForm form)
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
