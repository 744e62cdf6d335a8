namespace Gjk.Core;

/// <summary>Any of the library's shapes that is a mesh, unscaled, with or without a margin.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct HullCore(ConvexHull hull, double radius, double margin) : ISupportMap, ILibraryShape
{
    private readonly ConvexHull _hull = hull;
    private readonly double _margin = margin, _radius = radius;

    public Double3 Center => _hull.Center;

    public double Margin => _margin;

    public double BoundingRadius => _radius;

    object ILibraryShape.MakeTraits() => new LibraryTraits<HullCore>();

    public bool TryGetForm(out ShapeForm form) => ShapeForm.Of(_hull, out form);

    public int Support(in Double3 direction, out Double3 point)
    {
        int id = HullSupport.Find(_hull.Cells, direction, out point);
        Double3 center = _hull.Center;
        Double3.Write(point.X - center.X, point.Y - center.Y, point.Z - center.Z, out point);
        return id;
    }

    public bool TryGetVertex(int id, out Double3 point)
    {
        bool found = _hull.TryGetVertex(id, out point);
        point -= _hull.Center;
        return found;
    }

    public void GetFace(in Double3 direction, ref FaceCorners corners) =>
        _hull.Faces.Get(HullSupport.Find(_hull.Cells, direction, out _), direction, ref corners);

#if NET
    /// <summary>The furthest vertex, measured from the centre, and a 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<double> Support(in Double3 direction, out int id) => Support(_hull, direction, out id);

    /// <inheritdoc cref="Support(in Double3, out int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<double> Support(ConvexHull hull, in Double3 direction, out int id)
    {
        HullCells cells = hull.Cells;
        if (cells.Kind == HullCells.LookupKind.Scan)
        {
            id = HullSupport.FindByScan(cells, direction);
            return Lanes(hull, id);
        }

        // The look-up has just read the point beside its candidates; by its id it would come from far away.
        id = HullSupport.FindInCell(cells, direction, out Double3 point);
        point -= hull.Center;
        return Vector256.Create(point.X, point.Y, point.Z, 0);
    }

    /// <summary>A vertex, measured from the centre, and a 0; some vertex where there is none with the id.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<double> Lanes(int id) => Lanes(_hull, id);

    /// <inheritdoc cref="Lanes(int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<double> Lanes(ConvexHull hull, int id)
    {
        double[] centered = hull.Centered;
        uint at = 4 * (uint)id;
        Debug.Assert(centered.Length > 0 && centered.Length % 4 == 0);
        return Vector256.LoadUnsafe(
            ref MemoryMarshal.GetArrayDataReference(centered), at < (uint)centered.Length ? at : 0);
    }

    /// <summary>Whether there is a vertex with the id.</summary>
    public bool HasVertex(int id) => (uint)id < (uint)_hull.VertexCount;
#endif
}
