namespace Gjk.Core;

/// <summary>How a scale acts on a support map. A scale of the same size along every axis (mirrored or not) maps balls
/// to balls, so the margin stays a margin; any other one makes the margin an ellipsoid, which then belongs to the
/// support.</summary>
internal readonly struct AxisScale
{
    public readonly Double3 Factors;
    public readonly bool KeepsBalls;

    public AxisScale(in Double3 factors)
    {
        Factors = factors;
        KeepsBalls = Math.Abs(factors.X) == Math.Abs(factors.Y) && Math.Abs(factors.Y) == Math.Abs(factors.Z);
    }

    public double Largest => Factors.LargestMagnitude;

    public double Margin(double innerMargin) => KeepsBalls ? innerMargin * Math.Abs(Factors.X) : 0;

    /// <summary>Scales the corners of a face outward.</summary>
    /// <param name="corners">The corners, measured from the centre.</param>
    /// <param name="centerError">What is added to each.</param>
    public void Outward(ref FaceCorners corners, in Double3 centerError)
    {
        if (corners.Side != RoundSide.None) ScaleSide(ref corners);
        for (int i = 0; i < corners.Count; i++) corners[i] = Outward(corners[i]) + centerError;
    }

    /// <summary>How a face inside the scale is seen, and from where; it counts where balls are not kept.</summary>
    public unsafe OuterFrame Frame(in FaceCorners corners, in Double3 direction) => KeepsBalls ? default
        : corners.Outer == null ? new OuterFrame(Factors, direction) : corners.Outer->Stretched(Factors);

    /// <summary>The radius of a round side after the scale, which is known where the side is still round: the axis is
    /// the one that a cylinder's line lies along, or that has the tip of a cone on it.</summary>
    private void ScaleSide(ref FaceCorners corners)
    {
        double x = Math.Abs(Factors.X), y = Math.Abs(Factors.Y), z = Math.Abs(Factors.Z);
        Double3 line = corners[1] - corners[0], on = corners.Side == RoundSide.Cone ? corners[0] : line;
        double along = x == z && on.X == 0 && on.Z == 0 ? y
            : y == z && on.Y == 0 && on.Z == 0 ? x
            : x == y && on.X == 0 && on.Y == 0 ? z : 0;
        if (KeepsBalls) along = x;
        if (along == 0) corners.Side = RoundSide.Unknown;
        corners.SideRadius *= along == 0 ? 0 : x == z || x == y ? x : y;
        if (corners.Side == RoundSide.Cone)
            corners.SideRadius *= Outward(line).Length / (line.Length * along);
    }

    /// <summary>Scales a shape's centre; what rounding takes from it is to be added to each support.</summary>
    public void ScaleCenter(in Double3 innerCenter, out Double3 center, out Double3 error)
    {
        var x = DoubleDouble.Product(Factors.X, innerCenter.X);
        var y = DoubleDouble.Product(Factors.Y, innerCenter.Y);
        var z = DoubleDouble.Product(Factors.Z, innerCenter.Z);
        center = new Double3(x.High, y.High, z.High);
        error = new Double3(x.Low, y.Low, z.Low);
    }

    /// <summary>The direction as the unscaled shape sees it, or a multiple of it. A support direction changes with the
    /// transpose of the map, which for a scale along the axes is the map itself.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Double3 Inward(in Double3 direction)
    {
        Double3 inward = Double3.Multiply(Factors, direction);
        return DirectionRange.IsOrdinary(inward) ? inward : FromUnit(direction);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private Double3 FromUnit(in Double3 direction) => Double3.Multiply(Factors, DirectionRange.ToUnit(direction));

    /// <summary>Scales a support point outward; a margin that is an ellipsoid now is added here, and the vertex loses
    /// its id.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Outward(int id, double innerMargin, in Double3 inward, ref Double3 point)
    {
        if (innerMargin > 0 && !KeepsBalls)
        {
            Double3 unit = DirectionRange.ToUnit(inward);
            double length = unit.Length;
            if (length > 0) point += unit * (innerMargin / length);
            id = -1;
        }

        point = Outward(point);
        return id;
    }

    /// <summary>Scales a point outward.</summary>
    public Double3 Outward(in Double3 point) => Double3.Multiply(Factors, point);
}
