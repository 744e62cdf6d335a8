namespace Gjk.Core;

/// <summary>The roots of a t² + 2 b t + c, without cancellation: q = -(b + sign(b) √(b² - a c)), q / a and c / q (Press
/// et al., Numerical Recipes, 2007, section 5.6).</summary>
internal static class RayQuadratic
{
    /// <summary>Both roots.</summary>
    /// <param name="a">The quadratic coefficient; 0 gives one root and one that is infinite.</param>
    /// <param name="b">Half of the linear one.</param>
    /// <param name="c">The constant.</param>
    /// <param name="discriminant">b² - a c, which the caller knows without cancellation; at least 0.</param>
    /// <param name="least">The smaller root.</param>
    /// <param name="most">The larger one.</param>
    /// <returns>False where all coefficients but the last are 0, so that there is no root.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TrySolve(double a, double b, double c, double discriminant, out double least, out double most)
    {
        double root = Math.Sqrt(discriminant), q = b > 0 ? -(b + root) : root - b;
        double first = q / a, second = c / q;
        if (q == 0) second = first = 0;
        least = Math.Min(first, second);
        most = Math.Max(first, second);
        return a != 0 || q != 0;
    }
}
