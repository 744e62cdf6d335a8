namespace Gjk.Core;

/// <summary>What stands for an object in the broad phase.</summary>
public enum BoundKind
{
    /// <summary>An axis-aligned box: tighter, computed anew when the object turns.</summary>
    Box = 0,

    /// <summary>A ball: turning an object about its centre leaves it as it is.</summary>
    Ball,
}
