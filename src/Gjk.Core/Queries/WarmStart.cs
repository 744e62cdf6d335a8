namespace Gjk.Core;

/// <summary>
/// What a pair remembers from one query to the next. Keep one per pair and pass it by reference; <c>default</c> is a cold start. What it holds only
/// suggests where to begin: stale or foreign content costs time, never correctness.
/// </summary>
public struct WarmStart
{
    internal int CountPlusTag;
    internal int A0, A1, A2;
    internal int B0, B1, B2;
    internal float X, Y, Z;
}
