namespace Gjk.Core;

/// <summary>The inside of a closed mesh, in the frame of a shape with its triangles as parts. A solid has one; a
/// compound has one for each solid among its children, however deeply nested.</summary>
/// <remarks>A compound's parts are rounded to double one by one, so their surface is closed only up to rounding.
/// Therefore a point is brought to the mesh's frame in 106 bits, and the mesh's own winding number decides.</remarks>
internal sealed class SolidInside
{
    /// <summary>Ratio to a position: 2^-40, far more than double rounds away. More costs time only.</summary>
    private const double Rounding = 1.0 / (1L << 40);

    /// <summary>The inside in the child's frame, or before the scale; null in the mesh's own frame.</summary>
    private readonly SolidInside? _inner;

    private readonly RigidPose _pose;
    private readonly Vector3 _scale;

    /// <summary>A ball that holds the mesh, in the frame of the shape.</summary>
    private readonly Double3 _middle;
    private readonly double _radius;

    /// <summary>-1 where scales mirror, so that the corners run the other way round, else 1.</summary>
    private readonly int _orientation;

    public readonly TriangleMesh Mesh;

    /// <summary>The number of the part that is the mesh's first triangle; the others follow it.</summary>
    public readonly int First;

    /// <summary>The inside of a mesh, in the mesh's frame.</summary>
    public SolidInside(TriangleMesh mesh) =>
        (Mesh, _orientation, _middle, _radius) = (mesh, 1, mesh.Tree.Origin, mesh.Tree.Radius);

    /// <summary>The inside of a shape that is placed, and then scaled.</summary>
    public SolidInside(SolidInside inner, int first, in RigidPose pose, Vector3 scale)
    {
        (_inner, First, _pose, _scale, Mesh) = (inner, first, pose, scale, inner.Mesh);
        _orientation = inner._orientation * Math.Sign(scale.X) * Math.Sign(scale.Y) * Math.Sign(scale.Z);
        double most = Math.Max(Math.Max(Math.Abs(scale.X), Math.Abs(scale.Y)), Math.Abs(scale.Z));
        _middle = Double3.Multiply(new RotationD(pose.Rotation).Rotate(inner._middle) + pose.Position, scale);
        _radius = (inner._radius + Rounding * (inner._middle + pose.Position).SumOfMagnitudes) * most;
    }

    /// <summary>The number after that of its last part.</summary>
    public int End => First + Mesh.TriangleCount;

    /// <summary>The inside with the child at another pose.</summary>
    public SolidInside Moved(in RigidPose pose) => new(_inner!, First, pose, Vector3.One);

    /// <summary>1 where the corners of a part run counter-clockwise seen from outside, else -1.</summary>
    public int OutwardOf(int part) => _orientation * Mesh.OutwardOf(part - First);

    /// <summary>Whether a point of the shape's frame may be in it.</summary>
    public bool MayHold(in Double3 point) => _inner is null || (point - _middle).LengthSquared <= _radius * _radius;

    /// <summary>Brings a point from the shape's frame to the mesh's.</summary>
    public VectorDD ToMesh(in VectorDD point)
    {
        if (_inner is null) return point;
        var unscaled = new VectorDD(point.X / _scale.X, point.Y / _scale.Y, point.Z / _scale.Z);
        return _inner.ToMesh(VectorDD.ToFrame(_pose, unscaled));
    }

    /// <summary>The direction of the mesh's frame with the same support as a direction of the shape's frame, up to
    /// length.</summary>
    public Double3 AlongMesh(in Double3 direction) => _inner is null
        ? direction
        : _inner.AlongMesh(new RotationD(_pose.Rotation).InverseRotate(Double3.Multiply(direction, _scale)));
}
