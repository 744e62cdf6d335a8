namespace Gjk.Core;

/// <summary>The contact of a triangle's face with another shape's tip: the point furthest against the face's
/// normal.</summary>
/// <remarks>If a corner or a round side is nearer to a seam than it is deep, the pair's shortest way out leads over the
/// seam, where the surface goes on. What the surface shows there is the face under the tip.</remarks>
internal readonly ref struct TipContact
{
    private readonly PartSide _mesh, _other;
    private readonly Double3 _face, _tip;
    private readonly TriangleColumn _column;
    private readonly int _corner = -1;

    /// <summary>The tip of a part.</summary>
    /// <param name="mesh">The side of the triangle.</param>
    /// <param name="triangle">Its number.</param>
    /// <param name="other">The other side.</param>
    /// <param name="shape">Its part.</param>
    /// <param name="face">The triangle's normal on the side of the contact, in its frame.</param>
    public TipContact(PartSide mesh, int triangle, PartSide other, in ConvexShape shape, in Double3 face)
        : this(mesh, triangle, other, face)
    {
        Double3 against = other.ToLocalDirection(mesh.ToWorldDirection(-face));
        _corner = shape.Support(against, out Double3 point);
        _tip = InMesh(shape.Center + point) - face * shape.Margin;
        Gap = Double3.Dot(face, _tip - _column.Corner);
    }

    /// <summary>The tip that is a corner of the other side's mesh.</summary>
    public TipContact(PartSide mesh, int triangle, PartSide other, int corner, in Double3 face)
        : this(mesh, triangle, other, face)
    {
        _tip = InMesh(other.Mesh!.GetCorner(corner));
        Gap = Double3.Dot(face, _tip - _column.Corner);
    }

    private TipContact(PartSide mesh, int triangle, PartSide other, in Double3 face)
    {
        (_mesh, _other, _face) = (mesh, other, face);
        _column = new TriangleColumn(mesh, triangle, face);
        (_tip, Gap) = (default, 0);
    }

    /// <summary>How far the tip is from the triangle's plane, in world units; negative behind it.</summary>
    public double Gap { get; }

    /// <summary>Whether the tip is over the triangle, or under it.</summary>
    public bool IsOver => _column.Holds(_tip);

    /// <summary>Whether a part of the other side is wholly beside the triangle, in spite of rounding. The face meets
    /// no point of it then.</summary>
    public bool IsBeside(in ConvexShape shape) =>
        _column.IsBeside(InMesh(shape.Center), SeamContacts.Beside * shape.BoundingRadius);

    /// <summary>The tip in the world.</summary>
    public Double3 TipInWorld => _mesh.ToWorld(_tip);

    /// <summary>A manifold of the tip.</summary>
    /// <param name="isMeshA">Whether the mesh is the first side.</param>
    public ContactManifold Manifold(bool isMeshA)
    {
        RotationD toWorld = new(_mesh.Pose.Rotation);
        Double3 foot = _tip - _face * Gap, normal = toWorld.Rotate(_face), placed = toWorld.Rotate(_tip);
        var onMesh = (Vector3)(toWorld.Rotate(foot) + _mesh.Pose.Position);
        var onOther = (Vector3)(placed + _mesh.Pose.Position);
        var local = (Vector3)_other.ToLocalDirection(placed - Offset);
        uint corner = _corner >= 0 ? ContactFeature.Corner(_corner) : ContactFeature.None;
        var point = new ManifoldPoint(
            onMesh, onOther, (Vector3)foot, local, (float)Gap, ContactFeature.Of(ContactFeature.None, corner));
        ContactManifold manifold = default;
        manifold.Begin((Vector3)(isMeshA ? normal : -normal));
        manifold.Add(isMeshA ? point : point.Swapped);
        return manifold;
    }

    /// <summary>From the mesh to the other side, in the world.</summary>
    private Double3 Offset => (Double3)_other.Pose.Position - _mesh.Pose.Position;

    /// <summary>A point of the other side in the mesh's frame.</summary>
    private Double3 InMesh(in Double3 point) => _mesh.ToLocalDirection(_other.ToWorldDirection(point) + Offset);
}
