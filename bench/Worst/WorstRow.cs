namespace Gjk.Bench.Worst;

/// <summary>What a cloud that was made to be slow costs.</summary>
/// <param name="Family">Its name in WorstClouds.</param>
/// <param name="Points">How many points the cloud has.</param>
/// <param name="Distinct">How many different ones.</param>
/// <param name="Corners">How many corners the hull has.</param>
/// <param name="BuildMs">From the points to a hull that can be asked, in milliseconds.</param>
/// <param name="SurfaceMs">The part of it that finds the corners and triangles.</param>
/// <param name="Random">Supports in random directions.</param>
/// <param name="Normals">Supports along the normals of facets.</param>
/// <param name="NearNormals">Supports along directions that are 1e-18 to 1e-1 off such a normal.</param>
/// <param name="Query">The slowest distance between two of these hulls.</param>
internal sealed record WorstRow(
    string Family,
    int Points,
    int Distinct,
    int Corners,
    double BuildMs,
    double SurfaceMs,
    SupportCost Random,
    SupportCost Normals,
    SupportCost NearNormals,
    QueryCost Query);

/// <summary>Nanoseconds per support.</summary>
/// <param name="Mean">Over the directions.</param>
/// <param name="Worst">In the slowest direction.</param>
internal readonly record struct SupportCost(double Mean, double Worst);

/// <summary>A distance query.</summary>
/// <param name="Microseconds">What it takes.</param>
/// <param name="Placement">How the two hulls lie.</param>
/// <param name="Iterations">Of GJK.</param>
internal readonly record struct QueryCost(double Microseconds, string Placement, int Iterations);
