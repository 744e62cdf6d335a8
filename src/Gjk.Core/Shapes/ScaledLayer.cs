namespace Gjk.Core;

/// <summary>A <see cref="ConvexShape"/> that was rounded or placed before it was scaled, which its own numbers cannot
/// express. Immutable. It holds the decorator that callers of the typed shapes use, so both give the same
/// bits.</summary>
internal sealed class ScaledLayer(in Scaled<ConvexShape> shape) : ISupportMap
{
    /// <summary>The scaled shape.</summary>
    public readonly Scaled<ConvexShape> Shape = shape;

    /// <summary>The shape before the scale.</summary>
    public ConvexShape Inner => Shape.Inner;

    /// <summary>The scale.</summary>
    public Vector3 Factors => Shape.Factors;

    public Double3 Center => Shape.Center;

    public double Margin => Shape.Margin;

    public double BoundingRadius => Shape.BoundingRadius;

    public int Support(in Double3 direction, out Double3 point) => Shape.Support(direction, out point);

    public void GetFace(in Double3 direction, ref FaceCorners corners) => Shape.GetFace(direction, ref corners);

    public bool TryGetVertex(int id, out Double3 point) => Shape.TryGetVertex(id, out point);

    /// <summary>Whether two layers are the same shape, or do the same to equal shapes.</summary>
    public static bool AreEqual(ISupportMap? a, ISupportMap? b) =>
        ReferenceEquals(a, b)
        || (a is ScaledLayer one && b is ScaledLayer other && one.Factors == other.Factors
            && one.Inner.Equals(other.Inner));
}
