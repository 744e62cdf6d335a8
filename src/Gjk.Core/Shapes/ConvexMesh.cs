namespace Gjk.Core;

/// <summary>The convex hull of a cloud of vertices. Copies share the hull, so making one from a hull costs
/// nothing.</summary>
public readonly struct ConvexMesh : ISupportMap, IPlainBody
{
    private readonly ConvexHull? _hull;

    /// <summary>Makes a mesh from a hull that was built before.</summary>
    /// <exception cref="System.ArgumentNullException">The hull is null.</exception>
    public ConvexMesh(ConvexHull hull) => _hull = Guard.NotNull(hull, nameof(hull));

    /// <summary>Builds the hull of the vertices. Build it once and keep it: this is the expensive part.</summary>
    /// <exception cref="System.ArgumentNullException">The list is null.</exception>
    /// <exception cref="System.ArgumentException">The list is empty, or a coordinate is NaN or infinite.</exception>
    public ConvexMesh(IReadOnlyList<Vector3> vertices) => _hull = new ConvexHull(vertices);

    /// <summary>The hull; null in <c>default(ConvexMesh)</c> only.</summary>
    public ConvexHull? Hull => _hull;

    /// <inheritdoc/>
    public Double3 Center => _hull is null ? default : _hull.Center;

    /// <inheritdoc/>
    public double Margin => 0;

    /// <summary>NaN in <c>default(ConvexMesh)</c>, which no query accepts.</summary>
    public double BoundingRadius => _hull is null ? double.NaN : _hull.BoundingRadius;

    /// <summary>What a query may unwrap this to.</summary>
    internal FormKind Core => _hull is null ? FormKind.None : _hull.IsExactBox ? FormKind.Box : FormKind.Hull;

    /// <summary>This, known to be a box.</summary>
    internal void Get(out BoxCore box) =>
        BoxCore.Make(_hull!.Cells.Stretch, _hull.Center, _hull.Cells.Corners, _hull.BoundingRadius, 0, out box);

    /// <summary>This, known to be a mesh.</summary>
    internal void Get(out HullCore hull) => hull = new HullCore(_hull!, _hull!.BoundingRadius, 0);

    object ILibraryShape.MakeTraits() => new PlainTraits<ConvexMesh>();

    bool ILibraryShape.TryGetForm(out ShapeForm form) => ShapeForm.Of(_hull, out form);

    FormKind IPlainBody.GetPlain(out Double3 size)
    {
        size = Core == FormKind.Box ? _hull!.Cells.Stretch : default;
        return Core;
    }

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point)
    {
        int id = HullSupport.Find(_hull!.Cells, direction, out Double3 vertex);
        point = vertex - _hull!.Center;
        return id;
    }

    /// <inheritdoc/>
    public void GetFace(in Double3 direction, ref FaceCorners corners) =>
        _hull!.Faces.Get(HullSupport.Find(_hull.Cells, direction, out _), direction, ref corners);

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point)
    {
        if (_hull is null) return PrimitiveSupport.NoVertex(out point);
        bool found = _hull.TryGetVertex(id, out point);
        point -= _hull.Center;
        return found;
    }
}
