namespace Gjk.Core;

/// <summary>The path of a box that is translated, or of a point, which makes it a ray; and the test of which boxes it
/// meets: slabs (Kay and Kajiya, "Ray tracing complex scenes", 1986) about the sum of the two boxes.
/// Immutable.</summary>
/// <remarks>The test is conservative: it never misses a box that the path touches, and the entry is never later than
/// the true one. It may take in a box that the path misses by about 1e-13 of the way.</remarks>
public readonly struct SweptBox
{
    /// <summary>Ratio to the farthest coordinate of a box as seen from the start: by so much boxes are widened. The
    /// test itself rounds by 4 units of 2^-53 (proofs/swept-box.g); the rest of the 512 is for the queries that ask
    /// about what is in the box, whose rounding grows with the way too. Pinned by SweptBoxTests.</summary>
    private const double WaySlack = 512.0 / (1L << 53);

    /// <summary>Ratio to a fraction: what rounding to float, once as a fraction, once as a distance and once as a
    /// limit, does to it, with a factor of 5 to spare. Pinned by SweptBoxTests.</summary>
    private const double FractionSlack = 16.0 / (1 << 24);

    /// <summary>Fraction: the same where floats have a fixed step.</summary>
    private const double LeastFraction = 4 * (double)float.Epsilon;

    /// <summary>Stands for 1/0: more than any 1/d of floats, and times any difference of floats still a double, so that
    /// 0 times it is 0 and a path along the side of a box touches it.</summary>
    private const double NoMotion = 1e200;

    private readonly Double3 _min, _max, _inverse;
#if NET
    private readonly Vector256<double> _wideMin, _wideMax, _wideInverse;
#endif

    /// <summary>The path of a box.</summary>
    /// <param name="box">Where it begins.</param>
    /// <param name="translation">Its motion over the fractions from 0 to 1; may be zero.</param>
    /// <param name="maxFraction">How much of the motion there is: at least 0, +infinity for all the way.</param>
    /// <exception cref="ArgumentOutOfRangeException">The motion is not finite, or the fraction is negative or
    /// NaN.</exception>
    public SweptBox(in Aabb box, Vector3 translation, float maxFraction = 1)
        : this(
            box.Min, box.Max, Guard.Finite(translation, nameof(translation)),
            Guard.NonNegativeOrInfinite(maxFraction, nameof(maxFraction)))
    {
    }

    /// <summary>The path of a point: a ray.</summary>
    /// <param name="origin">Where it begins.</param>
    /// <param name="direction">Where the fraction 1 is, seen from the origin.</param>
    /// <param name="maxFraction">How much of it there is: at least 0, +infinity for all the way.</param>
    /// <exception cref="ArgumentOutOfRangeException">The origin or the direction is not finite, or the fraction is
    /// negative or NaN.</exception>
    public SweptBox(Vector3 origin, Vector3 direction, float maxFraction = float.PositiveInfinity)
        : this(
            Guard.Finite(origin, nameof(origin)), origin, Guard.Finite(direction, nameof(direction)),
            Guard.NonNegativeOrInfinite(maxFraction, nameof(maxFraction)))
    {
    }

    /// <summary>As the others; the arguments were checked.</summary>
    internal SweptBox(Vector3 min, Vector3 max, Vector3 motion, double maxFraction)
    {
        _min = min;
        _max = max;
        _inverse = new Double3(Inverse(motion.X), Inverse(motion.Y), Inverse(motion.Z));
#if NET
        _wideMin = Vector256.Create(_min.X, _min.Y, _min.Z, 0);
        _wideMax = Vector256.Create(_max.X, _max.Y, _max.Z, 0);
        _wideInverse = Vector256.Create(_inverse.X, _inverse.Y, _inverse.Z, 0);
#endif
        if (motion == Vector3.Zero) maxFraction = 0;
        Limit = maxFraction > float.MaxValue / 2 ? double.PositiveInfinity : After(maxFraction);
    }

    /// <summary>The largest fraction, and a little more for rounding: where a search begins.</summary>
    public double Limit { get; }

    /// <summary>A limit that leaves out only boxes that begin clearly later than a fraction, so that a hit at the same
    /// fraction, rounded to float, is found.</summary>
    /// <param name="fraction">At least 0.</param>
    public static double After(double fraction) => fraction * (1 + FractionSlack) + LeastFraction;

    /// <summary>Whether the path meets a box, touching included.</summary>
    /// <param name="box">The box.</param>
    /// <param name="limit">The largest fraction that is of interest.</param>
    /// <param name="entry">Where the two first touch, or a little before it; at least 0.</param>
    public bool Meets(in Aabb box, double limit, out double entry) => Meets(box.Min, box.Max, limit, out entry);

    /// <summary>As the other; the ends are finite, or an infinite one times a motion of 0 would be no number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal bool Meets(Vector3 min, Vector3 max, double limit, out double entry)
    {
#if NET
        if (Avx.IsSupported) return MeetsWide(min, max, limit, out entry);
#endif
        return MeetsScalar(min, max, limit, out entry);
    }

    /// <summary>As <see cref="Meets(in Aabb, double, out double)"/>, an axis at a time.</summary>
    internal bool MeetsScalar(Vector3 min, Vector3 max, double limit, out double entry)
    {
        // How far the start has passed the lower end, and how far it is from the upper one: the larger is positive.
        double passedX = _max.X - min.X, passedY = _max.Y - min.Y, passedZ = _max.Z - min.Z;
        double leftX = max.X - _min.X, leftY = max.Y - _min.Y, leftZ = max.Z - _min.Z;
        double slack = WaySlack * Math.Max(
            Math.Max(Math.Max(passedX, leftX), Math.Max(passedY, leftY)), Math.Max(passedZ, leftZ));
        double lowX = -(passedX + slack) * _inverse.X, highX = (leftX + slack) * _inverse.X;
        double lowY = -(passedY + slack) * _inverse.Y, highY = (leftY + slack) * _inverse.Y;
        double lowZ = -(passedZ + slack) * _inverse.Z, highZ = (leftZ + slack) * _inverse.Z;
        entry = Math.Max(Math.Max(Math.Min(lowX, highX), Math.Min(lowY, highY)), Math.Max(Math.Min(lowZ, highZ), 0));
        double exit = Math.Min(
            Math.Min(Math.Max(lowX, highX), Math.Max(lowY, highY)), Math.Min(Math.Max(lowZ, highZ), limit));
        return entry <= exit;
    }

#if NET
    /// <summary>The same numbers, three axes at a time; the fourth lane has 0 for the entry and the limit for the exit.
    /// There is no NaN among the numbers, and a zero's sign does not matter, so these minima and maxima need no
    /// care.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool MeetsWide(Vector3 min, Vector3 max, double limit, out double entry)
    {
        Vector256<double> passed = _wideMax - Avx.ConvertToVector256Double(min.AsVector128());
        Vector256<double> left = Avx.ConvertToVector256Double(max.AsVector128()) - _wideMin;
        Vector256<double> largest = Avx.Max(passed, left);
        largest = Avx.Max(largest, Avx.Permute2x128(largest, largest, 1));
        largest = Avx.Max(largest, Avx.Permute(largest, 0b0101));
        Vector256<double> slack = largest * WaySlack;
        Vector256<double> low = -(passed + slack) * _wideInverse, high = (left + slack) * _wideInverse;
        Vector256<double> near = Avx.Min(low, high);
        Vector256<double> far = Avx.Blend(Avx.Max(low, high), Vector256.Create(limit), 0b1000);
        Vector128<double> entries = Sse2.Max(near.GetLower(), near.GetUpper());
        Vector128<double> exits = Sse2.Min(far.GetLower(), far.GetUpper());
        entry = Sse2.MaxScalar(entries, Sse2.UnpackHigh(entries, entries)).ToScalar();
        return entry <= Sse2.MinScalar(exits, Sse2.UnpackHigh(exits, exits)).ToScalar();
    }
#endif

    private static double Inverse(float x) => x == 0 ? NoMotion : 1.0 / x;
}
