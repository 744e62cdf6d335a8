using Gjk.Demo.Trace;

namespace Gjk.Bench.Baseline;

/// <summary>A vertex of the Minkowski difference, with the two points that it comes from.</summary>
internal readonly struct MinkowskiPoint : ITextbookVertex
{
    public readonly Vector3 OnA;
    public readonly Vector3 OnB;

    public MinkowskiPoint(Vector3 onA, Vector3 onB)
    {
        W = onA - onB;
        OnA = onA;
        OnB = onB;
    }

    public Vector3 W { get; }
}
