namespace Gjk.Bench.Benchmarks;

/// <summary>The question that a group of benchmarks asks, for <c>--anyCategories</c>. Each group has its own
/// baseline.</summary>
public static class Categories
{
    public const string Distance = "Distance";
    public const string Overlap = "Overlap";
    public const string Depth = "Depth";
    public const string Cast = "Cast";
    public const string Support = "Support";
    public const string SphereSphere = "SphereSphere";
    public const string CapsuleCapsule = "CapsuleCapsule";
    public const string Cubes = "Cubes";
    public const string Boxes = "Boxes";
}
