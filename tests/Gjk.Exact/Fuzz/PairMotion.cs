namespace Gjk.Exact.Fuzz;

/// <summary>How the shapes of a pair move, without turning, over the fractions from 0 to 1.</summary>
/// <param name="A">Of the first shape, in world units.</param>
/// <param name="B">Of the second shape.</param>
internal readonly record struct PairMotion(Vector3 A, Vector3 B)
{
    /// <summary>Of B, seen from A.</summary>
    public Double3 Relative => (Double3)B - A;

    /// <summary>The way that B goes, seen from A, over the fraction 1.</summary>
    public double Length => Relative.Length;
}
