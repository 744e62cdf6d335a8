namespace Gjk.Core;

/// <summary>
/// A <see cref="ConvexShape"/> that is a box: half extents in double, since a scale may have been multiplied into them.
/// </summary>
internal readonly struct BoxCore : ISupportMap
{
    private readonly Vector3D _half;
    private readonly double _radius;

    public BoxCore(in Vector3D half, double radius)
    {
        _half = half;
        _radius = radius;
    }

    public Vector3D Center => default;

    public double Margin => 0;

    public double BoundingRadius => _radius;

    public int Support(in Vector3D direction, out Vector3D point) => PrimitiveSupport.Box(_half, direction, out point);

    public bool TryGetVertex(int id, out Vector3D point) => PrimitiveSupport.TryBoxVertex(_half, id, out point);
}
