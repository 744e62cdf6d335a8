using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// The path of a box that is translated, or of a point, which makes it a ray; and the test of which boxes it meets:
/// slabs (Kay and Kajiya, "Ray tracing complex scenes", 1986) about the sum of the two boxes. Immutable.
/// </summary>
/// <remarks>
/// The test is conservative: it never misses a box that the path touches, and the entry is never later than the true
/// one. It may take in a box that the path misses by about 1e-13 of the way.
/// </remarks>
public readonly struct SweptBox
{
    /// <summary>
    /// Ratio to the farthest coordinate of a box as seen from the start: by so much boxes are widened. The test itself
    /// rounds by 4 units of 2^-53; the rest of the 512 is for the queries that ask about what is in the box, whose
    /// rounding grows with the way too. Pinned by SweptBoxTests.
    /// </summary>
    private const double WaySlack = 512.0 / (1L << 53);

    /// <summary>
    /// Ratio to a fraction: what rounding to float, once as a fraction, once as a distance and once as a limit, does to
    /// it, with a factor of 5 to spare. Pinned by SweptBoxTests.
    /// </summary>
    private const double FractionSlack = 16.0 / (1 << 24);

    /// <summary>Fraction: the same where floats have a fixed step.</summary>
    private const double LeastFraction = 4 * (double)float.Epsilon;

    /// <summary>
    /// Stands for 1/0: more than any 1/d of floats, and times any difference of floats still a double, so that 0 times
    /// it is 0 and a path along the side of a box touches it.
    /// </summary>
    private const double NoMotion = 1e200;

    private readonly Vector3D _min, _max, _inverse;
    private readonly bool _isBackX, _isBackY, _isBackZ;

    /// <summary>The path of a box.</summary>
    /// <param name="box">Where it begins.</param>
    /// <param name="translation">Its motion over the fractions from 0 to 1; may be zero.</param>
    /// <param name="maxFraction">How much of the motion there is: at least 0, +infinity for all the way.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// The motion is not finite, or the fraction is negative or NaN.
    /// </exception>
    public SweptBox(in Aabb box, Vector3 translation, float maxFraction = 1)
        : this(box.Min, box.Max, Guard.Finite(translation, nameof(translation)), Checked(maxFraction))
    {
    }

    /// <summary>The path of a point: a ray.</summary>
    /// <param name="origin">Where it begins.</param>
    /// <param name="direction">Where the fraction 1 is, seen from the origin.</param>
    /// <param name="maxFraction">How much of it there is: at least 0, +infinity for all the way.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// The origin or the direction is not finite, or the fraction is negative or NaN.
    /// </exception>
    public SweptBox(Vector3 origin, Vector3 direction, float maxFraction = float.PositiveInfinity)
        : this(
            Guard.Finite(origin, nameof(origin)), origin, Guard.Finite(direction, nameof(direction)),
            Checked(maxFraction))
    {
    }

    /// <summary>As the others; the arguments were checked.</summary>
    internal SweptBox(Vector3 min, Vector3 max, Vector3 motion, double maxFraction)
    {
        _min = min;
        _max = max;
        _inverse = new Vector3D(Inverse(motion.X), Inverse(motion.Y), Inverse(motion.Z));
        (_isBackX, _isBackY, _isBackZ) = (motion.X < 0, motion.Y < 0, motion.Z < 0);
        if (motion == Vector3.Zero) maxFraction = 0;
        Limit = maxFraction > float.MaxValue / 2 ? double.PositiveInfinity : After(maxFraction);
    }

    /// <summary>The largest fraction, and a little more for rounding: where a search begins.</summary>
    public double Limit { get; }

    /// <summary>
    /// A limit that leaves out only boxes that begin clearly later than a fraction, so that a hit at the same fraction,
    /// rounded to float, is found.
    /// </summary>
    /// <param name="fraction">At least 0.</param>
    public static double After(double fraction) => fraction * (1 + FractionSlack) + LeastFraction;

    /// <summary>Whether the path meets a box, touching included.</summary>
    /// <param name="box">The box.</param>
    /// <param name="limit">The largest fraction that is of interest.</param>
    /// <param name="entry">Where the two first touch, or a little before it; at least 0.</param>
    public bool Meets(in Aabb box, double limit, out double entry) => Meets(box.Min, box.Max, limit, out entry);

    /// <summary>As the other; infinite ends are admitted.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal bool Meets(Vector3 min, Vector3 max, double limit, out double entry)
    {
        // How far the start is behind each end of the sum of the boxes: the farthest of them is positive.
        double lowX = _max.X - min.X, lowY = _max.Y - min.Y, lowZ = _max.Z - min.Z;
        double highX = max.X - _min.X, highY = max.Y - _min.Y, highZ = max.Z - _min.Z;
        double slack = WaySlack * Larger(
            Larger(Larger(lowX, highX), Larger(lowY, highY)), Larger(lowZ, highZ));
        (lowX, lowY, lowZ) = (-slack - lowX, -slack - lowY, -slack - lowZ);
        (highX, highY, highZ) = (highX + slack, highY + slack, highZ + slack);
        double nearX = (_isBackX ? highX : lowX) * _inverse.X, farX = (_isBackX ? lowX : highX) * _inverse.X;
        double nearY = (_isBackY ? highY : lowY) * _inverse.Y, farY = (_isBackY ? lowY : highY) * _inverse.Y;
        double nearZ = (_isBackZ ? highZ : lowZ) * _inverse.Z, farZ = (_isBackZ ? lowZ : highZ) * _inverse.Z;
        entry = Larger(Larger(nearX, nearY), Larger(nearZ, 0));
        return entry <= Smaller(Smaller(farX, farY), Smaller(farZ, limit));
    }

    private static double Checked(float maxFraction) => maxFraction >= 0
        ? maxFraction
        : throw new ArgumentOutOfRangeException(nameof(maxFraction), maxFraction, "Must not be negative or NaN.");

    private static double Inverse(float x) => x == 0 ? NoMotion : 1.0 / x;

    /// <summary>One instruction; none of the numbers is a NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Larger(double a, double b) => a > b ? a : b;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Smaller(double a, double b) => a < b ? a : b;
}
