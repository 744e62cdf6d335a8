namespace Gjk.Bench.Worst;

/// <summary>The cost of a cloud that was made to be slow.</summary>
/// <param name="Family">Its name in WorstClouds.</param>
/// <param name="Points">How many points the cloud has.</param>
/// <param name="Distinct">How many distinct points there are.</param>
/// <param name="Corners">How many corners the hull has.</param>
/// <param name="BuildMs">Milliseconds from the points to a hull that is ready for queries.</param>
/// <param name="SurfaceMs">The part of that time that finds the corners and triangles.</param>
/// <param name="Random">Supports in random directions.</param>
/// <param name="Normals">Supports along the normals of facets.</param>
/// <param name="NearNormals">Supports along directions that differ from such a normal by 1e-18 to 1e-1.</param>
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
/// <param name="Mean">The mean over the directions.</param>
/// <param name="Worst">The time of the slowest direction.</param>
internal readonly record struct SupportCost(double Mean, double Worst);

/// <summary>The cost of a distance query.</summary>
/// <param name="Microseconds">The time of the query.</param>
/// <param name="Placement">How the two hulls are placed.</param>
/// <param name="Iterations">The iterations of GJK.</param>
internal readonly record struct QueryCost(double Microseconds, string Placement, int Iterations);
