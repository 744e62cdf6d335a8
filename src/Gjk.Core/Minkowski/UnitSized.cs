namespace Gjk.Core;

/// <summary>A shape multiplied by a power of two, for pairs so small or so large that the solvers' products would leave
/// the range of double. Nothing is rounded by it, so the answer has the bits that it would have if double had no
/// limits.</summary>
/// <typeparam name="T">The shape inside.</typeparam>
internal readonly struct UnitSized<T>(in T inner, double factor) : ISupportMap, ILibraryShape
    where T : struct, ISupportMap
{
    private readonly T _inner = inner;
    private readonly double _factor = factor;

    public Double3 Center => _inner.Center * _factor;

    public double Margin => _inner.Margin * _factor;

    public double BoundingRadius => _inner.BoundingRadius * _factor;

    object ILibraryShape.MakeTraits() => new LibraryTraits<UnitSized<T>>(ShapeTraits<T>.AreTight);

    /// <summary>That of the shape inside, in its units.</summary>
    bool ILibraryShape.TryGetForm(out ShapeForm form)
    {
        T inner = _inner;
        return ShapeTraits<T>.Instance.TryGetForm(ref inner, out form);
    }

    public int Support(in Double3 direction, out Double3 point)
    {
        int id = _inner.Support(direction, out point);
        point *= _factor;
        return id;
    }

    public bool TryGetVertex(int id, out Double3 point)
    {
        bool found = _inner.TryGetVertex(id, out point);
        point *= _factor;
        return found;
    }

    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
        _inner.GetFace(direction, ref corners);
        corners.SideRadius *= _factor;
        for (int i = 0; i < corners.Count; i++) corners[i] *= _factor;
    }
}
