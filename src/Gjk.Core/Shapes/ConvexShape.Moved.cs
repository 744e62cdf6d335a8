namespace Gjk.Core;

// The supports of shapes that are placed or scaled are methods of their own: Mono clears the copy of a shape whenever
// a method that may need it is called.
public readonly partial struct ConvexShape
{
    [MethodImpl(MethodImplOptions.NoInlining)]
    private int PlacedSupport(in Double3 direction, out Double3 point)
    {
        int id = InCoreAxes(out Placement? placement).Support(placement!.Inward(direction), out point);
        point = placement.Outward(point);
        return id;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private int ScaledSupport(ShapeScale scaling, in Double3 direction, out Double3 point)
    {
        Double3 inward = scaling.Axes.Inward(direction);
        int id = CoreSupport(inward, out point);
        point -= CoreCenter(_parts);
        id = scaling.Axes.Outward(id, _parts.InnerMargin, inward, ref point);
        point += scaling.CenterError;
        return id;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool TryGetPlacedVertex(int id, out Double3 point)
    {
        bool found = InCoreAxes(out Placement? placement).TryGetVertex(id, out point);
        point = placement!.Outward(point);
        return found;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool TryGetScaledVertex(ShapeScale scaling, int id, out Double3 point)
    {
        point = default;
        if (_parts.InnerMargin > 0 && !scaling.Axes.KeepsBalls) return false;
        bool found = CoreVertex(id, out point);
        point = Double3.Multiply(scaling.Axes.Factors, point - CoreCenter(_parts)) + scaling.CenterError;
        return found;
    }
}
