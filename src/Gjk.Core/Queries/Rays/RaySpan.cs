namespace Gjk.Core;

/// <summary>The part of a line that is in a convex body: an interval of its parameter, and the outward normal where it
/// begins. Bodies that are intersections are clipped one by one (Cyrus and Beck 1978).</summary>
internal struct RaySpan
{
    /// <summary>Where the line enters and leaves.</summary>
    public double Enter, Exit;

    /// <summary>The body's outward normal where the line enters, of any length.</summary>
    public Double3 Normal;

    /// <summary>Whether the line so nearly touches the body, or runs along it, that what rounding did to the foot moves
    /// the entry.</summary>
    public bool IsClose;

    /// <summary>Nothing is cut off yet.</summary>
    public static RaySpan Everything => new() { Enter = double.NegativeInfinity, Exit = double.PositiveInfinity };

    /// <summary>Measures it from another point of the line, so far before the one at hand.</summary>
    public void Move(double shift) => (Enter, Exit) = (Enter + shift, Exit + shift);

    /// <summary>Cuts off what is above a half extent along one axis, and below its opposite (Ericson, Real-Time
    /// Collision Detection, 2005, section 5.3.3).</summary>
    /// <param name="half">The half extent.</param>
    /// <param name="foot">The line's coordinate at the parameter 0.</param>
    /// <param name="slope">Its change with the parameter.</param>
    /// <param name="axis">The axis.</param>
    /// <returns>False where nothing is left.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Clip(double half, double foot, double slope, in Double3 axis)
    {
        if (slope == 0) return foot <= half && -foot <= half;
        double near = slope > 0 ? -half : half, inverse = 1 / slope;
        double enter = (near - foot) * inverse, exit = (-near - foot) * inverse;
        if (enter > Enter)
        {
            Enter = enter;
            Normal = slope > 0 ? -axis : axis;
        }

        if (exit < Exit) Exit = exit;
        return Enter <= Exit;
    }
}
