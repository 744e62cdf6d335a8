namespace Gjk.Core;

/// <summary>What a closed mesh encloses, in the frame of a shape of which its triangles are parts: a solid has one, a
/// compound one for each solid among its children, however deep that is nested.</summary>
/// <remarks>The parts of a compound are rounded to double one by one, and are closed but for that. So a point is taken
/// to the mesh instead, in 106 bits, and the mesh's own winding number tells.</remarks>
internal sealed class SolidInside
{
    /// <summary>Ratio to a place: 2^-40, far more than double loses of it. More costs time only.</summary>
    private const double Rounding = 1.0 / (1L << 40);

    /// <summary>The same in the child's frame, or before the scale; null in the mesh's own frame.</summary>
    private readonly SolidInside? _inner;

    private readonly RigidPose _pose;
    private readonly Vector3 _scale;

    /// <summary>A ball that holds the mesh, in the frame of the shape.</summary>
    private readonly Double3 _middle;
    private readonly double _radius;

    /// <summary>-1 where scales mirror, so that the corners run the other way round, else 1.</summary>
    private readonly int _turn;

    public readonly TriangleMesh Mesh;

    /// <summary>The number of the part that is the mesh's first triangle; the others follow it.</summary>
    public readonly int First;

    /// <summary>Of a mesh in its own frame.</summary>
    public SolidInside(TriangleMesh mesh) =>
        (Mesh, _turn, _middle, _radius) = (mesh, 1, mesh.Tree.Origin, mesh.Tree.Radius);

    /// <summary>Of a shape that is placed, and then scaled.</summary>
    public SolidInside(SolidInside inner, int first, in RigidPose pose, Vector3 scale)
    {
        (_inner, First, _pose, _scale, Mesh) = (inner, first, pose, scale, inner.Mesh);
        _turn = inner._turn * Math.Sign(scale.X) * Math.Sign(scale.Y) * Math.Sign(scale.Z);
        double most = Math.Max(Math.Max(Math.Abs(scale.X), Math.Abs(scale.Y)), Math.Abs(scale.Z));
        _middle = Double3.Multiply(new RotationD(pose.Rotation).Rotate(inner._middle) + pose.Position, scale);
        _radius = (inner._radius + Rounding * (inner._middle + pose.Position).SumOfMagnitudes) * most;
    }

    /// <summary>The number after that of its last part.</summary>
    public int End => First + Mesh.TriangleCount;

    /// <summary>The same where the child is elsewhere.</summary>
    public SolidInside Moved(in RigidPose pose) => new(_inner!, First, pose, Vector3.One);

    /// <summary>1 where the corners of a part run counter-clockwise seen from outside, else -1.</summary>
    public int OutwardOf(int part) => _turn * Mesh.OutwardOf(part - First);

    /// <summary>Whether a point of the shape's frame may be in it.</summary>
    public bool MayHold(in Double3 point) => _inner is null || (point - _middle).LengthSquared <= _radius * _radius;

    /// <summary>A point of the shape's frame in the mesh's.</summary>
    public VectorDD ToMesh(in VectorDD point)
    {
        if (_inner is null) return point;
        var unscaled = new VectorDD(point.X / _scale.X, point.Y / _scale.Y, point.Z / _scale.Z);
        return _inner.ToMesh(VectorDD.ToFrame(_pose, unscaled));
    }

    /// <summary>The direction in which the mesh reaches as the shape does along one, but for a factor.</summary>
    public Double3 AlongMesh(in Double3 direction) => _inner is null
        ? direction
        : _inner.AlongMesh(new RotationD(_pose.Rotation).InverseRotate(Double3.Multiply(direction, _scale)));
}
