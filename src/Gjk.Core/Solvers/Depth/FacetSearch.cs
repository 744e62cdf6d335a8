namespace Gjk.Core;

/// <summary>What a search over facets knows, and how much it may still do.</summary>
internal struct FacetSearch
{
    /// <summary>The cheapest way out.</summary>
    public DepthBounds Depth;

    /// <summary>Supports asked.</summary>
    public int Supports;

    /// <summary>Balls of these radii about their centres are inside the shapes.</summary>
    public readonly double InnerA, InnerB;

    /// <summary>Length: what rounding does to a height.</summary>
    public readonly double Noise;

    private int _looks;

    public FacetSearch(in PairForm form, in SolverState state, int looks)
    {
        InnerA = form.A.InnerRadius;
        InnerB = form.B.InnerRadius;
        Depth = DepthBounds.Of(state);
        Supports = 0;
        Noise = state.DepthNoise;
        _looks = looks;
    }

    /// <summary>Whether nothing may be looked at any more.</summary>
    public readonly bool AreSpent => _looks < 0;

    /// <summary>What is as high is no cheaper than the cheapest way out, but for rounding.</summary>
    public readonly double Limit => Depth.Above - Noise;

    /// <summary>Takes note of a direction whose way out costs at least so much. Where that seems to be the least,
    /// supports of both shapes say what it does cost.</summary>
    /// <returns>False when the looks are spent, or the supports do not agree.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryLook<TA, TB>(ref TA a, ref TB b, in PairFrame frame, in Double3 normal, double height)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (--_looks < 0) return false;
        Supports++;
        if (height >= Depth.Above) return true;
        Simplex.Begin(out Simplex simplex);
        Double3 unit = normal * (1 / normal.Length);
        MinkowskiDifference.Support(ref a, ref b, frame, -unit, ref simplex, 0, out Double3 w);
        Depth.See(unit, Double3.Dot(unit, w));
        return height >= Limit;
    }
}
