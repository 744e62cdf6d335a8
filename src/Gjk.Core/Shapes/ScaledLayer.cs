namespace Gjk.Core;

/// <summary>
/// A <see cref="ConvexShape"/> that was rounded or placed before it was scaled, which its own numbers cannot express.
/// Immutable. It holds the decorator that callers of the typed shapes use, so both give the same bits.
/// </summary>
internal sealed class ScaledLayer
{
    /// <summary>The scaled shape.</summary>
    public readonly Scaled<ConvexShape> Shape;

    public ScaledLayer(in Scaled<ConvexShape> shape) => Shape = shape;

    /// <summary>Whether two layers do the same to equal shapes.</summary>
    public static bool AreEqual(ScaledLayer? a, ScaledLayer? b) =>
        ReferenceEquals(a, b)
        || (a is not null && b is not null && a.Shape.Factors == b.Shape.Factors
            && a.Shape.Inner.Equals(b.Shape.Inner));
}
