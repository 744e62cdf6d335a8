namespace Gjk.Core;

/// <summary>Volume, centre and spread of the solid that triangles enclose: the sum of the tetrahedra between each
/// triangle and an apex, with their signs.</summary>
/// <remarks>Source: F. Tonon, "Explicit exact formulas for the 3-D tetrahedron inertia tensor in terms of its vertex
/// coordinates", Journal of Mathematics and Statistics, 2004. Corners are measured from the apex, so a solid far from
/// its origin loses nothing, and all is summed in 106 bits, so tetrahedra that cancel lose nothing that a double would
/// show.</remarks>
/// <param name="apex">Any point; best in the middle of the solid.</param>
internal struct TetrahedronSum(in Double3 apex)
{
    /// <summary>Ratio of a volume to the sum of its terms' magnitudes: 2^-80. Less is no volume. Rounding leaves 2^-100
    /// of each, so a thousand times less would do, and a solid of floats that thin has no inside to find, so a thousand
    /// times more would. Pinned by MassTests.</summary>
    private const double NoVolume = 1.0 / (1L << 40) / (1L << 40);

    private readonly Double3 _apex = apex;
    private DoubleDouble _volume;
    private VectorDD _first, _squares, _products;
    private double _sum;

    /// <summary>Adds a triangle, counter-clockwise seen from outside.</summary>
    public void Add(in Double3 p, in Double3 q, in Double3 r)
    {
        VectorDD from = _apex, a = p - from, b = q - from, c = r - from, sum = a + b + c;
        DoubleDouble volume = VectorDD.Dot(a, VectorDD.Cross(b, c));
        VectorDD x = new(a.X, b.X, c.X), y = new(a.Y, b.Y, c.Y), z = new(a.Z, b.Z, c.Z);
        _sum += Magnitude((Double3)a, (Double3)b, (Double3)c);
        _volume += volume;
        _first += sum * volume;
        _squares += new VectorDD(
            VectorDD.Dot(x, x) + sum.X * sum.X, VectorDD.Dot(y, y) + sum.Y * sum.Y,
            VectorDD.Dot(z, z) + sum.Z * sum.Z) * volume;
        _products += new VectorDD(
            VectorDD.Dot(x, y) + sum.X * sum.Y, VectorDD.Dot(x, z) + sum.X * sum.Z,
            VectorDD.Dot(y, z) + sum.Y * sum.Z) * volume;
    }

    /// <summary>Of what was added, at density 1; triangles that all look in are taken to look out.</summary>
    public readonly MassProperties ToMass()
    {
        if (!(Math.Abs(_volume.High) > NoVolume * _sum)) return new MassProperties(0, _apex, default);
        VectorDD c = _first * (0.25 / _volume);
        VectorDD squares = Central(_squares, new VectorDD(c.X * c.X, c.Y * c.Y, c.Z * c.Z));
        VectorDD products = Central(_products, new VectorDD(c.X * c.Y, c.X * c.Z, c.Y * c.Z));
        double volume = (double)(_volume / 6), side = Math.Sign(volume);
        return new(
            side * volume, (Double3)(c + _apex), side * (Double3)squares, side * (Double3)products);
    }

    /// <summary>The magnitudes of the terms of a · (b × c).</summary>
    private static double Magnitude(in Double3 a, in Double3 b, in Double3 c) =>
        Math.Abs(a.X) * (Math.Abs(b.Y * c.Z) + Math.Abs(b.Z * c.Y))
        + Math.Abs(a.Y) * (Math.Abs(b.Z * c.X) + Math.Abs(b.X * c.Z))
        + Math.Abs(a.Z) * (Math.Abs(b.X * c.Y) + Math.Abs(b.Y * c.X));

    /// <summary>A second moment about the centre: a 120th of the sum, less the volume at the centre.</summary>
    private readonly VectorDD Central(in VectorDD sum, in VectorDD center) =>
        (sum * (1.0 / (DoubleDouble)20) - center * _volume) * (1.0 / (DoubleDouble)6);
}
