namespace Gjk.Core;

/// <summary>A shape without its margin as the searches for a depth know it, however it is written: a hull, or a round
/// body, that is a point, a segment, an ellipsoid or another body of revolution.</summary>
internal struct BodyForm
{
    /// <summary>Whether it is a round body.</summary>
    public bool IsRound;

    /// <summary>Whether a round body has no vertices; false for points and segments.</summary>
    public bool IsCurved;

    /// <summary>Whether a round body is a cylinder.</summary>
    public bool IsCylinder;

    /// <summary>Turned about this line through the centre, a round body stays the same; 0 where it does about every
    /// line. Of any length.</summary>
    public Double3 Axis;

    /// <summary>Whether it is an ellipsoid that has no such line.</summary>
    public bool HasNoAxis;

    /// <summary>The radii of an ellipsoid; else 0.</summary>
    public Double3 Radii;

    /// <summary>The rotation of the ellipsoid in the shape's local frame.</summary>
    public QuaternionD Turn;

    /// <summary>The hull of a solid mesh that is not placed; else null.</summary>
    public ConvexHull? Hull;

    /// <summary>How many vertices a body that has nothing else has, with ids from 0 on; else 0.</summary>
    public int CornerCount;

    /// <summary>The hull that tells which corners have an edge between them; without one, any may have.</summary>
    private ConvexHull? _edges;

    /// <summary>A ball of this radius about its centre is inside the mesh; negative where that is outside.</summary>
    public double InnerRadius;

    /// <summary>Whether the mesh's scale has turned the winding of its triangles.</summary>
    public bool IsMirrored;

    /// <summary>Whether it is a box, of which the edges at one corner have the directions of all.</summary>
    public readonly bool IsBox => CornerCount == 8 && _edges is null;

    /// <summary>Whether it is a point.</summary>
    public readonly bool IsPoint => IsRound && !IsCurved && Axis == default;

    /// <summary>How many triangles the mesh has; 0 without one.</summary>
    public readonly int TriangleCount => Hull is null ? 0 : Hull.TriangleCount;

    /// <summary>The form of a shape; neither round nor a hull where there is nothing to say.</summary>
    /// <param name="shape">In world units.</param>
    /// <param name="unit">The form's unit of length, in world units.</param>
    /// <param name="form">Gets it.</param>
    public static void Get<T>(ref T shape, double unit, out BodyForm form)
        where T : struct, ISupportMap
    {
        form = default;
        if (ShapeTraits<T>.Instance.TryGetForm(ref shape, out ShapeForm body)) form.Set(body, unit);
    }

    private void Set(in ShapeForm body, double unit)
    {
        Turn = body.IsPlaced ? body.Turn : QuaternionD.Identity;
        switch (body.Kind)
        {
            case FormKind.Hull:
                Double3 factors = body.IsScaled ? body.Factors : new Double3(1, 1, 1);
                SetHull(body.Hull!, factors * (1 / unit), body.IsPlaced);
                break;
            case FormKind.Box or FormKind.Triangle:
                CornerCount = body.Kind == FormKind.Box ? 8 : 3;
                break;
            case FormKind.Ball or FormKind.Segment or FormKind.Cylinder or FormKind.Cone or FormKind.Swollen:
                IsRound = body.TryGetAxis(out Double3 axis);
                IsCylinder = IsRound && body.Kind == FormKind.Cylinder;
                IsCurved = body.IsScaled || (body.Kind != FormKind.Ball && body.Kind != FormKind.Segment);
                Axis = new RotationD(Turn).Rotate(axis);
                CornerCount = IsCurved ? 0 : IsPoint ? 1 : 2;
                break;
            case FormKind.Ellipsoid:
                IsRound = IsCurved = true;
                HasNoAxis = !body.TryGetAxis(out axis);
                if (!HasNoAxis) Axis = new RotationD(Turn).Rotate(axis);
                Radii = body.A * (1 / unit);
                break;
        }
    }

    /// <summary>How many corners may have an edge with this one, those with lower ids first.</summary>
    public readonly int NeighborCount(int corner) => _edges is null ? corner : _edges.NeighborCount(corner);

    /// <summary>One of them.</summary>
    public readonly int Neighbor(int corner, int k) => _edges is null ? k : _edges.GetNeighbor(corner, k);

    private void SetHull(ConvexHull hull, in Double3 factors, bool isPlaced)
    {
        CornerCount = hull.VertexCount;
        _edges = hull;
        if (hull.Dimension < 3 || isPlaced) return;
        double x = Math.Abs(factors.X), y = Math.Abs(factors.Y), z = Math.Abs(factors.Z), inner = hull.InnerRadius;
        Hull = hull;
        IsMirrored = (factors.X < 0) ^ (factors.Y < 0) ^ (factors.Z < 0);
        InnerRadius = inner * (inner > 0 ? Math.Min(Math.Min(x, y), z) : Math.Max(Math.Max(x, y), z));
    }
}
