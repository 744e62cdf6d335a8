namespace Gjk.Core;

/// <summary>Prepares the direction of a support. It folds the direction into the plane of a flat hull, and it rescales
/// directions of extreme length, whose dot products would overflow or lose digits.</summary>
/// <remarks>A flat hull's vertices satisfy n · p = c. Dropping the axis k of the normal's largest (stretched) component
/// changes no comparison if the direction d is replaced by e with e_i = d_i - d_k n_i / n_k: p · d and p · e differ by
/// a constant. A support towards the plane's normal then compares what the plane leaves, not the rounding of a large
/// common term.</remarks>
internal readonly struct HullDirection
{
    /// <summary>What a prepared direction is multiplied by, along each axis: half the hull's extents; 0 for the axis
    /// that is folded away. The products say how much each component can contribute to a dot product.</summary>
    public readonly Double3 Stretch;

    /// <summary>The reach of a direction is the sum of the magnitudes of its components, without those along which the
    /// hull has no extent. From 2^-700 to 2^800 it is safe: half extents are 2^-150 to 2^128 and coordinates four times
    /// that, so that nothing overflows, and underflow costs at most 2^-1073, which is 2^-220 of the largest product.
    /// Pinned by HullDirectionLengthTests.</summary>
    private const double LeastSafe = 1.9010815379079637e-211, MostSafe = 6.6680144328798543e240;

    private readonly Double3 _extents, _fold;

    public HullDirection(HullVertices hull)
    {
        _extents = ((Double3)hull.Bounds.Max - hull.Bounds.Min) * 0.5;
        Stretch = _extents;
        _fold = default;
        IsFolded = false;
        if (hull.Dimension != 2 || !(_extents.X > 0 && _extents.Y > 0 && _extents.Z > 0)) return;
        VectorDD normal = HullNormal.Of(hull, _extents);
        Double3 sizes = Double3.Multiply((Double3)normal, _extents);
        double x = Math.Abs(sizes.X), y = Math.Abs(sizes.Y), z = Math.Abs(sizes.Z);
        if (x + y + z == 0) return;
        bool dropX = x >= y && x >= z, dropY = !dropX && y >= z, dropZ = !dropX && !dropY;
        Double3 ratios = (Double3)(normal * (-1.0 / (dropX ? normal.X : dropY ? normal.Y : normal.Z)));
        _fold = new Double3(dropX ? -1 : ratios.X, dropY ? -1 : ratios.Y, dropZ ? -1 : ratios.Z);
        Stretch = new Double3(dropX ? 0 : _extents.X, dropY ? 0 : _extents.Y, dropZ ? 0 : _extents.Z);
        IsFolded = true;
    }

    /// <summary>Whether directions are folded: the hull is flat and not orthogonal to a coordinate axis.</summary>
    public bool IsFolded { get; }

    /// <summary>Whether two components of a prepared direction matter.</summary>
    public bool IsPlanar => Components == 2;

    /// <summary>Whether all components matter, so that a direction of safe reach need not be prepared.</summary>
    public bool IsSpatial => Components == 3;

    private int Components => (Stretch.X > 0 ? 1 : 0) + (Stretch.Y > 0 ? 1 : 0) + (Stretch.Z > 0 ? 1 : 0);

    /// <summary>Whether dot products with a direction of this reach are computed without overflow and loss of digits.
    /// False for 0 and NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsSafe(double reach) => reach >= LeastSafe && reach <= MostSafe;

    /// <summary>Folds and rescales where that is needed.</summary>
    /// <param name="direction">Any; prepared when the result is true.</param>
    /// <returns>False when all vertices are level, or when the direction is none: 0, NaN or infinite.</returns>
    public bool TryPrepare(ref Double3 direction)
    {
        Double3 folded = Fold(direction);
        if (!IsSafe(Reach(folded)))
        {
            if (!TryRescale(direction, _extents, out Double3 rescaled)) return false;
            if (!TryRescale(Fold(rescaled), Stretch, out folded)) return false;
        }

        direction = WithExtent(folded, Stretch);
        return true;
    }

    private static bool TryRescale(in Double3 direction, in Double3 stretch, out Double3 rescaled)
    {
        rescaled = DirectionRange.ToUnit(WithExtent(direction, stretch));
        double largest = rescaled.LargestMagnitude;
        return largest > 0 && largest <= double.MaxValue;
    }

    /// <summary>A component along which the hull has no extent must not count, however large it is.</summary>
    private static Double3 WithExtent(in Double3 direction, in Double3 extents) => new(
        extents.X > 0 ? direction.X : 0,
        extents.Y > 0 ? direction.Y : 0,
        extents.Z > 0 ? direction.Z : 0);

    private Double3 Fold(in Double3 direction)
    {
        if (!IsFolded) return direction;
        double along = Stretch.X == 0 ? direction.X : Stretch.Y == 0 ? direction.Y : direction.Z;
        return direction + along * _fold;
    }

    private double Reach(in Double3 d) =>
        (Stretch.X > 0 ? Math.Abs(d.X) : 0) + (Stretch.Y > 0 ? Math.Abs(d.Y) : 0) + (Stretch.Z > 0 ? Math.Abs(d.Z) : 0);
}
