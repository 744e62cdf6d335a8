namespace Gjk.Core;

/// <summary>The contact of a triangle's face with another shape's tip: the point that is furthest against the face's
/// normal.</summary>
/// <remarks>Where a corner or a round side is nearer to a seam than it is deep, the pair's shortest way out leads over
/// the seam, where the surface goes on. What the surface shows there is a face: that of the triangle over which the tip
/// lies.</remarks>
internal readonly ref struct TipContact
{
    private readonly RotationD _toMesh, _toOther;
    private readonly Double3 _offset, _a, _b, _c, _tip;
    private readonly int _corner;

    /// <param name="mesh">The side of the triangle.</param>
    /// <param name="triangle">Its number.</param>
    /// <param name="other">The other side.</param>
    /// <param name="shape">Its part.</param>
    /// <param name="face">The triangle's normal on the side of the contact, in its frame.</param>
    public TipContact(PartSide mesh, int triangle, PartSide other, in ConvexShape shape, in Double3 face)
        : this(mesh, triangle, other, face)
    {
        _tip = Furthest(shape, face, out _corner);
        Gap = Double3.Dot(face, _tip - _a);
    }

    /// <summary>As the other, of a corner of the other side's mesh.</summary>
    public TipContact(PartSide mesh, int triangle, PartSide other, int corner, in Double3 face)
        : this(mesh, triangle, other, face)
    {
        _tip = _toMesh.InverseRotate(_toOther.Rotate(other.Mesh!.GetCorner(corner))) + _offset;
        _corner = -1;
        Gap = Double3.Dot(face, _tip - _a);
    }

    private TipContact(PartSide mesh, int triangle, PartSide other, in Double3 face)
    {
        _toMesh = new RotationD(mesh.Pose.Rotation);
        _toOther = new RotationD(other.Pose.Rotation);
        _offset = _toMesh.InverseRotate((Double3)other.Pose.Position - mesh.Pose.Position);
        mesh.Mesh!.GetCorners(triangle, out _a, out _b, out _c);
        Face = face;
        (_tip, _corner, Gap) = (default, -1, 0);
    }

    /// <summary>The triangle's normal on the side to which it pushes.</summary>
    public Double3 Face { get; }

    /// <summary>How far the tip is from the triangle's plane, in world units; negative behind it.</summary>
    public double Gap { get; }

    /// <summary>Makes a manifold of the tip.</summary>
    /// <param name="isMeshA">Whether the mesh is the first side.</param>
    /// <param name="mesh">The side of the triangle.</param>
    /// <param name="maxGap">In world units.</param>
    /// <param name="manifold">Gets the point.</param>
    /// <param name="isAnywhere">Whether it need not be over the triangle.</param>
    /// <returns>False where the tip is not over the triangle, or too far away.</returns>
    public bool TryAdd(
        bool isMeshA, PartSide mesh, float maxGap, ref ContactManifold manifold, bool isAnywhere = false)
    {
        if (!(Gap <= Math.Max(maxGap, 0)) || !(isAnywhere || IsOver(_tip))) return false;
        Double3 foot = _tip - Face * Gap, normal = _toMesh.Rotate(Face);
        var onMesh = (Vector3)(_toMesh.Rotate(foot) + mesh.Pose.Position);
        var onOther = (Vector3)(_toMesh.Rotate(_tip) + mesh.Pose.Position);
        var local = (Vector3)_toOther.InverseRotate(_toMesh.Rotate(_tip - _offset));
        uint corner = _corner >= 0 ? ContactFeature.Corner(_corner) : ContactFeature.None;
        var point = new ManifoldPoint(
            onMesh, onOther, (Vector3)foot, local, (float)Gap, ContactFeature.Of(ContactFeature.None, corner));
        manifold.Begin((Vector3)(isMeshA ? normal : -normal));
        manifold.Add(isMeshA ? point : point.Swapped);
        return true;
    }

    /// <summary>The furthest point against a direction, in the mesh's frame, and its corner's id.</summary>
    private Double3 Furthest(in ConvexShape shape, in Double3 direction, out int corner)
    {
        corner = shape.Support(_toOther.InverseRotate(_toMesh.Rotate(-direction)), out Double3 point);
        return _toMesh.InverseRotate(_toOther.Rotate(shape.Center + point)) + _offset - direction * shape.Margin;
    }

    /// <summary>Whether the tip is over the triangle, or beside it by what its seams may bend without counting as
    /// bent.</summary>
    public bool IsOver(in Double3 tip)
    {
        double sign = Double3.Dot(Double3.Cross(_b - _a, _c - _a), Face) < 0 ? -1 : 1;
        return IsInside(_a, _b, sign, tip) && IsInside(_b, _c, sign, tip) && IsInside(_c, _a, sign, tip);
    }

    private bool IsInside(in Double3 from, in Double3 to, double sign, in Double3 tip)
    {
        Double3 edge = to - from;
        return sign * Double3.Dot(Double3.Cross(Face, edge), tip - from) >= -ContactCone.Slack * edge.LengthSquared;
    }
}
