namespace Gjk.Core;

/// <summary>What the forms of two shapes say about the shortest way out of each other before anything is searched: its
/// direction, or a plane that it lies in; the default says nothing. In A's axes.</summary>
internal readonly struct WayOut
{
    /// <summary>Ratio, squared, of the offset's part across the axis to all of it: 2^-100, far below what rounding does
    /// to it. Shapes whose axes are so near each other may leave each other in any plane. Any amount below rounding
    /// will do.</summary>
    private const double Coaxial = 1.0 / (1L << 50) / (1L << 50);

    /// <summary>Of unit length: the direction, or the side of the plane's axis that the way out lies on.</summary>
    public readonly Double3 Across;

    /// <summary>Of unit length: the plane's axis; 0 where the direction is known.</summary>
    public readonly Double3 Axis;

    /// <summary>Length per radian: how much the shortest way out in such a plane may change as the plane turns about
    /// its axis; 0 where the way out is in this one.</summary>
    public readonly double Slope;

    /// <summary>Both bodies' unit axes, less the plane's.</summary>
    private readonly Double3 _leanA, _leanB;

    private WayOut(in Double3 across, in Double3 axis, double slope, in Double3 leanA, in Double3 leanB)
    {
        Across = across;
        Axis = axis;
        Slope = slope;
        _leanA = leanA;
        _leanB = leanB;
    }

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
    public static WayOut Along(
        in Double3 axis, in Double3 offset, double slope, in Double3 leanA, in Double3 leanB)
    {
        Double3 across = offset - axis * Double3.Dot(axis, offset);
        bool isAcross = across.LengthSquared > Coaxial * offset.LengthSquared;

        // Of a short rest of a long offset rounding leaves something along the axis.
        if (isAcross) across *= 1 / across.Length;
        across -= axis * Double3.Dot(axis, across);
        return new WayOut(
            isAcross ? across * (1 / across.Length) : new PlaneBasis(axis).U, axis, slope, leanA, leanB);
    }

    /// <summary>The same plane, turned about its axis.</summary>
    public WayOut Turned(double angle)
    {
        SineCosine.Of(angle, out double sine, out double cosine);
        return new WayOut(
            Across * cosine + Double3.Cross(Axis, Across) * sine, Axis, Slope, _leanA, _leanB);
    }

    /// <summary>How a point of A - B moves against the plane as the plane turns, when each body turns about its own
    /// axis by as much, which changes neither. What is left of a Taylor series behind its first, second and third term
    /// is at most the slope times the angle, its square, and two thirds of its cube.</summary>
    /// <param name="onA">The point of A, from its centre.</param>
    /// <param name="onB">The point of B, from its own, in A's axes.</param>
    /// <param name="offset">From A's centre to B's.</param>
    /// <param name="moved">Its first derivative.</param>
    /// <param name="bent">Its second one.</param>
    public void Follow(
        in Double3 onA, in Double3 onB, in Double3 offset, out Double3 moved, out Double3 bent)
    {
        Double3 movedA = Double3.Cross(_leanA, onA), movedB = Double3.Cross(_leanB, onB);
        Double3 movedOffset = Double3.Cross(Axis, offset);
        moved = movedA - movedB + movedOffset;
        bent = Double3.Cross(_leanA, Double3.Cross(Axis + _leanA, onA))
            - Double3.Cross(_leanB, Double3.Cross(Axis + _leanB, onB))
            - Double3.Cross(Axis, moved);
    }
}
