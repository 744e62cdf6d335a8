namespace Gjk.Demo.Trace;

/// <summary>A vertex of A - B in float, with the two points that it comes from, in world coordinates.</summary>
internal readonly record struct TextbookVertex(int Step, Vector3 OnA, Vector3 OnB) : ITextbookVertex
{
    public Vector3 W => OnA - OnB;

    /// <summary>Whether two vertices are the same point, whichever step found them.</summary>
    public bool IsAt(in TextbookVertex other) => OnA == other.OnA && OnB == other.OnB;
}
