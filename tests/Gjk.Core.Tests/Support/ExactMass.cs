namespace Gjk.Core.Tests.Support;

/// <summary>Volume, centre and inertia of what triangles enclose, in integers: tetrahedra from the origin, and one
/// division at the end of each number.</summary>
internal sealed class ExactMass
{
    private readonly BigInteger _volume;
    private readonly BigInteger[] _first = new BigInteger[3], _second = new BigInteger[9];
    private readonly int _exponent;

    public ExactMass(IReadOnlyList<Double3[]> triangles)
    {
        _exponent = triangles.SelectMany(t => t).Min(
            p => Math.Min(Dyadic.Exponent(p.X), Math.Min(Dyadic.Exponent(p.Y), Dyadic.Exponent(p.Z))));
        foreach (Double3[] triangle in triangles)
        {
            BigInteger[][] p = [.. triangle.Select(Integers)];
            BigInteger[] sum = [.. Enumerable.Range(0, 3).Select(i => p[0][i] + p[1][i] + p[2][i])];
            BigInteger volume = p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1])
                + p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2])
                + p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
            _volume += volume;
            for (int i = 0; i < 3; i++)
            {
                _first[i] += volume * sum[i];
                for (int j = i; j < 3; j++)
                    _second[3 * i + j] += volume * (p.Aggregate(sum[i] * sum[j], (s, q) => s + q[i] * q[j]));
            }
        }
    }

    public double Volume => Ratio(_volume, 6, 3);

    public Double3 Center => new(First(0), First(1), First(2));

    public Double3 Diagonal => new(Second(4, 8), Second(0, 8), Second(0, 4));

    public Double3 Products => new(-Second(1), -Second(2), -Second(5));

    private BigInteger[] Integers(Double3 p) =>
        [Dyadic.ToInteger(p.X, _exponent), Dyadic.ToInteger(p.Y, _exponent), Dyadic.ToInteger(p.Z, _exponent)];

    private double First(int i) => Ratio(_first[i], 4 * _volume, 1);

    /// <summary>The sum of central second moments.</summary>
    private double Second(params int[] entries) => Ratio(
        entries.Aggregate(BigInteger.Zero, (s, e) => s + 4 * _second[e] * _volume - 5 * _first[e / 3] * _first[e % 3]),
        480 * _volume, 5);

    private double Ratio(BigInteger over, BigInteger under, int power)
    {
        int more = (int)Math.Max(0, 80 + BigInteger.Abs(under).GetBitLength() - BigInteger.Abs(over).GetBitLength());
        return Dyadic.ToDouble((over << more) / under, power * _exponent - more);
    }
}
