namespace Gjk.Core;

/// <summary>How the cost of a way out bends as its direction turns, and Newton's step to the cheapest one.</summary>
/// <param name="u">Across the direction, of unit length.</param>
/// <param name="v">Across both.</param>
/// <param name="height">What the way out costs.</param>
/// <param name="alongU">How fast its support point moves as the direction turns towards U.</param>
/// <param name="alongV">The same towards V.</param>
internal readonly struct WayBend(
    in Double3 u, in Double3 v, double height, in Double3 alongU, in Double3 alongV)
{
    private readonly Double3 _u = u, _v = v;

    private readonly double _bendU = Double3.Dot(u, alongU) - height, _bendV = Double3.Dot(v, alongV) - height;

    private readonly double _twist = (Double3.Dot(u, alongV) + Double3.Dot(v, alongU)) / 2;

    /// <summary>Whether the way out bends in all directions, by no less than a length.</summary>
    public bool IsMoreThan(double least) => _bendU > 0 && Determinant > least * (_bendU + _bendV);

    /// <summary>The step across the direction.</summary>
    /// <param name="w">The support point of the direction, or its part across it.</param>
    public Double3 Step(in Double3 w)
    {
        double slopeU = Double3.Dot(_u, w), slopeV = Double3.Dot(_v, w), determinant = Determinant;
        return _u * ((_twist * slopeV - _bendV * slopeU) / determinant)
            + _v * ((_twist * slopeU - _bendU * slopeV) / determinant);
    }

    private double Determinant => _bendU * _bendV - _twist * _twist;
}
