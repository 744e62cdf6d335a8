namespace Gjk.Core;

// The supports of shapes that are placed or scaled are methods of their own: Mono clears a method's locals whenever it
// is called, needed or not.
public readonly partial struct ConvexShape
{
    [MethodImpl(MethodImplOptions.NoInlining)]
    private int PlacedSupport(in Double3 direction, out Double3 point)
    {
        Double3 inward = _parts.Placement!.Inward(direction);
        int id = _parts.Layer is null
            ? ScaledSupport(inward, out point)
            : _parts.Layer.Support(inward, out point);
        point = _parts.Placement.Outward(point);
        return id;
    }

    /// <summary>The support of the core after the scale, if there is one, in the core's axes.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private int ScaledSupport(in Double3 direction, out Double3 point)
    {
        ShapeScale? scaling = _parts.Scaling;
        Double3 inward = scaling is null ? direction : scaling.Axes.Inward(direction);
        int id = CoreSupport(inward, out point);
        point -= CoreCenter(_parts);
        if (scaling is null) return id;
        id = scaling.Axes.Outward(id, _parts.InnerMargin, inward, ref point);
        point += scaling.CenterError;
        return id;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool TryGetPlacedVertex(int id, out Double3 point)
    {
        bool found = _parts.Layer is null
            ? TryGetScaledVertex(id, out point)
            : _parts.Layer.TryGetVertex(id, out point);
        point = _parts.Placement!.Outward(point);
        return found;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool TryGetScaledVertex(int id, out Double3 point)
    {
        ShapeScale? scaling = _parts.Scaling;
        point = default;
        if (scaling is not null && _parts.InnerMargin > 0 && !scaling.Axes.KeepsBalls) return false;
        bool found = CoreVertex(id, out point);
        point -= CoreCenter(_parts);
        if (scaling is not null) point = scaling.Axes.Outward(point) + scaling.CenterError;
        return found;
    }
}
