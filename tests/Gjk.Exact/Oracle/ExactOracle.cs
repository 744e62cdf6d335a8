namespace Gjk.Exact.Oracle;

/// <summary>The exact flag, and the exact distance rounded to double (0 when overlapping).</summary>
public readonly record struct ExactAnswer(bool Overlap, double Distance);

/// <summary>The true answer for two posed point clouds with margins, in integers: slow, and independent of the library.
/// A float is an integer times a power of two, and a rotation by an unnormalised quaternion is a matrix of integers
/// over |q|², so every Minkowski vertex is an integer vector over one common denominator. GJK on those, with exact
/// signs, ends after finitely many steps, because the distance falls strictly. Doubles only propose: where to start,
/// and which points cannot be furthest.</summary>
public static class ExactOracle
{
    /// <summary>Fraction bits kept of a square root: far more than a double can show.</summary>
    private const int RootBits = 256;

    /// <param name="a">The first cloud, in its own frame.</param>
    /// <param name="marginA">How far its shape reaches beyond the cloud's hull.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second cloud.</param>
    /// <param name="marginB">How far its shape reaches beyond the cloud's hull.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="shiftB">Moves B further, in the world.</param>
    public static ExactAnswer Solve(
        Double3[] a, double marginA, in RigidPose poseA, Double3[] b, double marginB, in RigidPose poseB,
        in Double3 shiftB = default)
    {
        var problem = new ExactProblem(a, marginA, poseA, b, marginB, poseB, shiftB);
        ExactFeature feature = Nearest(problem);
        if (feature.Direction.IsZero) return new ExactAnswer(true, 0);

        // distance² = P / Q in the problem's unit, squared.
        BigInteger p = feature.SquaredNumerator;
        BigInteger q = feature.SquaredDenominator * problem.Denominator * problem.Denominator;
        if (p <= problem.Margins * problem.Margins * q) return new ExactAnswer(true, 0);

        int shift = RootBits + System.Math.Max(0, (int)(q.GetBitLength() - p.GetBitLength()));
        BigInteger root = SquareRoot((p << (2 * shift)) / q);
        return new ExactAnswer(false, Dyadic.ToDouble(root - (problem.Margins << shift), problem.Exponent - shift));
    }

    private static ExactFeature Nearest(ExactProblem problem)
    {
        Int3[] simplex = ExactGuess.Feature(problem);
        while (true)
        {
            ExactFeature feature = ExactFeature.Nearest(simplex);
            if (feature.Direction.IsZero) return feature;
            Int3 w = problem.Support(-feature.Direction);
            if (Int3.Dot(feature.Direction, w) >= Int3.Dot(feature.Direction, feature.Points[0])) return feature;
            simplex = [.. feature.Points, w];
        }
    }

    /// <summary>Newton's iteration from above: falls until it reaches the floor of the root.</summary>
    private static BigInteger SquareRoot(BigInteger n)
    {
        if (n.IsZero) return n;
        BigInteger x = BigInteger.One << (int)((n.GetBitLength() + 1) / 2);
        while (true)
        {
            BigInteger y = (x + n / x) >> 1;
            if (y >= x) return x;
            x = y;
        }
    }
}
