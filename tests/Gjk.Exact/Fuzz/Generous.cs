namespace Gjk.Exact.Fuzz;

/// <summary>A shape as a user might write it: the same supports, a bounding radius that is larger than need be, and no
/// kind that the library could recognise.</summary>
internal readonly struct Generous : ISupportMap
{
    private readonly ConvexShape _inner;
    private readonly double _factor;

    /// <param name="inner">The shape.</param>
    /// <param name="factor">At least 1: what the bounding radius is multiplied by.</param>
    public Generous(in ConvexShape inner, double factor)
    {
        _inner = inner;
        _factor = factor;
    }

    public Double3 Center => _inner.Center;

    public double Margin => _inner.Margin;

    public double BoundingRadius => _inner.BoundingRadius * _factor;

    public int Support(in Double3 direction, out Double3 point) =>
        _inner.Support(direction, out point);

    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
    }

    public bool TryGetVertex(int id, out Double3 point) => _inner.TryGetVertex(id, out point);
}
