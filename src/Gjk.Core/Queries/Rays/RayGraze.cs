using System;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// Lines that run along a face of a body: rounding, not geometry, would say where they cross its plane. Such a ray has
/// no closed form, and is cast.
/// </summary>
internal static class RayGraze
{
    /// <summary>
    /// Sine: along a plane that is steeper, what rounding does to the foot (1e-13 of the size) moves the crossing by
    /// less than a tenth of the promise. Pinned by RayGrazeTests.
    /// </summary>
    public const double LeastSlope = 1e-5;

    /// <summary>Ratio to the size: four times what rounding does to the foot. Pinned by RayGrazeTests.</summary>
    public const double FootError = 4e-13;

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

    /// <summary>The largest component of a direction.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double LengthOf(in Vector3D direction) =>
        Math.Max(Math.Max(Math.Abs(direction.X), Math.Abs(direction.Y)), Math.Abs(direction.Z));
}
