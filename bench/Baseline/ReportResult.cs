namespace Gjk.Bench.Baseline;

/// <summary>The answer of the report's distance query.</summary>
public readonly struct ReportResult
{
    public readonly bool Intersects;
    public readonly float Distance;
    public readonly Vector3 PointA;
    public readonly Vector3 PointB;
    public readonly int Iterations;

    public ReportResult(bool intersects, float distance, Vector3 pointA, Vector3 pointB, int iterations)
    {
        Intersects = intersects;
        Distance = distance;
        PointA = pointA;
        PointB = pointB;
        Iterations = iterations;
    }
}
