namespace Gjk.Core;

/// <summary>The size that a pair's tolerances are fractions of: for each shape the distance of its furthest point from
/// its centre, margin included, added.</summary>
/// <remarks>The library's shapes know theirs. A shape of a user may report any bounding radius that is large enough,
/// and a tolerance must not grow with it: such a shape is measured by the support points that it gives in the course of
/// the query, which are what its rounding errors come from.</remarks>
internal struct PairSize
{
    private double _a, _b;

    /// <summary>In solver units.</summary>
    public readonly double Value => _a + _b;

    /// <summary>Starts with the bounding radii where they are tight, else with the margins.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Make<TA, TB>(in PairFrame frame, out PairSize size)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        size._a = ShapeTraits<TA>.AreTight ? frame.RadiusA : frame.MarginA;
        size._b = ShapeTraits<TB>.AreTight ? frame.RadiusB : frame.MarginB;
    }

    /// <summary>Enlarges the size to a support point of each shape, measured from its centre.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Observe(in PairFrame frame, in Double3 onA, in Double3 onB)
    {
        _a = Math.Max(_a, Math.Min(onA.Length + frame.MarginA, frame.RadiusA));
        _b = Math.Max(_b, Math.Min(onB.Length + frame.MarginB, frame.RadiusB));
    }
}
