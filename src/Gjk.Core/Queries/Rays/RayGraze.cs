namespace Gjk.Core;

/// <summary>Lines that run along a face of a body, or nearly touch a round one: rounding, not geometry, would say where
/// they enter. Such a ray is measured again, exactly; along the facet of a hull, whose plane is rounded too, it is
/// cast.</summary>
internal static class RayGraze
{
    /// <summary>Sine: along a plane that is steeper, what rounding does to the foot (1e-13 of the size) moves the
    /// crossing by less than a tenth of the promise. Pinned by RayGrazeTests.</summary>
    public const double LeastSlope = 1e-5;

    /// <summary>Ratio to the size: four times what rounding does to the foot. Pinned by RayGrazeTests.</summary>
    public const double FootError = 4e-13;

    /// <summary>Squared ratio of half the chord to the radius: a line with a shorter chord is a tangent. At it, what
    /// rounding does to the foot moves the entry by a tenth of the promise. Pinned by RayGrazeTests.</summary>
    private const double Tangent = 1e-10;

    /// <summary>Ratio of the shortest half extent to the longest: in a flatter body the foot's rounding shows, seen by
    /// a line along it. Pinned by RayThinTests.</summary>
    private const double Flat = 1e-3;

    /// <summary>Whether a line runs along a body that is flat and round.</summary>
    /// <param name="size">The half extents, of either sign.</param>
    /// <param name="direction">The line's.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsAlongFlat(in Double3 size, in Double3 direction)
    {
        double flat = Flat * size.LargestMagnitude, slope = LeastSlope * direction.LargestMagnitude;
        return (Math.Abs(size.X) <= flat & Math.Abs(direction.X) <= slope)
            | (Math.Abs(size.Y) <= flat & Math.Abs(direction.Y) <= slope)
            | (Math.Abs(size.Z) <= flat & Math.Abs(direction.Z) <= slope);
    }

    /// <summary>Whether a line nearly touches a round body.</summary>
    /// <param name="squared">Half the chord, squared; negative where it misses.</param>
    /// <param name="most">What that is for a line through the middle; 0 along the axis.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsTangent(double squared, double most) => Math.Abs(squared) < Tangent * most;

    /// <summary>Whether a line runs along the side of a cylinder.</summary>
    /// <param name="slope">How fast it leaves the axis, squared.</param>
    /// <param name="outside">The squared distance of the foot from the axis, less that of the side.</param>
    /// <param name="direction">The line's.</param>
    /// <param name="radius">The cylinder's.</param>
    /// <param name="size">How far the body reaches from its centre, at least.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsAlongSide(double slope, double outside, in Double3 direction, double radius, double size)
    {
        double length = direction.LargestMagnitude;
        return slope <= LeastSlope * LeastSlope * length * length
            && IsAlong(outside / (2 * radius), Math.Sqrt(slope), length, size);
    }

    /// <summary>Whether a line crosses a plane within the body's reach, and too flatly.</summary>
    /// <param name="below">How far the line's foot is inside the plane, of either sign.</param>
    /// <param name="slope">How that changes with the line's parameter.</param>
    /// <param name="length">Of the direction, or its largest component.</param>
    /// <param name="size">How far the body reaches from its centre, at least.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsAlong(double below, double slope, double length, double size)
    {
        double flat = Math.Abs(slope);
        return flat <= LeastSlope * length & Math.Abs(below) * length <= (2 * flat + FootError * length) * size;
    }

    /// <summary>The same for both planes of a slab about the centre.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsAlongSlab(double half, double foot, double slope, double length, double size) =>
        IsAlong(half - Math.Abs(foot), slope, length, size);
}
