using Gjk.Core;

namespace Gjk.Exact.Fuzz;

/// <summary>
/// A shape as a user might write it: the same supports, a bounding radius that is larger than need be, and no kind that
/// the library could recognise.
/// </summary>
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

    public Vector3D Center => _inner.Center;

    public double Margin => _inner.Margin;

    public double BoundingRadius => _inner.BoundingRadius * _factor;

    public int Support(in Vector3D direction, out Vector3D point) =>
        _inner.Support(direction, out point);

    public void GetFace(in Vector3D direction, ref FaceCorners corners)
    {
    }

    public bool TryGetVertex(int id, out Vector3D point) => _inner.TryGetVertex(id, out point);
}
