namespace Gjk.Exact.Oracle;

/// <summary>The rotation of a quaternion that need not be of unit length: an integer matrix over an integer
/// denominator, |q|².</summary>
public sealed class ExactRotation
{
    private readonly Int3 _row0, _row1, _row2;

    public ExactRotation(Quaternion q)
    {
        int exponent = Math.Min(
            Math.Min(Dyadic.Exponent(q.X), Dyadic.Exponent(q.Y)), Math.Min(Dyadic.Exponent(q.Z), Dyadic.Exponent(q.W)));
        BigInteger x = Dyadic.ToInteger(q.X, exponent), y = Dyadic.ToInteger(q.Y, exponent);
        BigInteger z = Dyadic.ToInteger(q.Z, exponent), w = Dyadic.ToInteger(q.W, exponent);
        BigInteger xx = x * x, yy = y * y, zz = z * z, ww = w * w;
        Denominator = xx + yy + zz + ww;
        _row0 = new Int3(ww + xx - yy - zz, 2 * (x * y - w * z), 2 * (x * z + w * y));
        _row1 = new Int3(2 * (x * y + w * z), ww - xx + yy - zz, 2 * (y * z - w * x));
        _row2 = new Int3(2 * (x * z - w * y), 2 * (y * z + w * x), ww - xx - yy + zz);
        Approximate = new ApproximateRotation(q);
    }

    public BigInteger Denominator { get; }

    /// <summary>The same to double rounding.</summary>
    public ApproximateRotation Approximate { get; }

    public Int3 Rotate(in Int3 v) => new(Int3.Dot(_row0, v), Int3.Dot(_row1, v), Int3.Dot(_row2, v));
}

/// <summary>A rotation matrix in double, made from the quaternion here and not taken from the library.</summary>
public sealed class ApproximateRotation
{
    private readonly Double3 _row0, _row1, _row2;

    public ApproximateRotation(Quaternion q)
    {
        double x = q.X, y = q.Y, z = q.Z, w = q.W;
        double s = 1 / (x * x + y * y + z * z + w * w);
        _row0 = new Double3(w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)) * s;
        _row1 = new Double3(2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)) * s;
        _row2 = new Double3(2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z) * s;
    }

    public Double3 Rotate(in Double3 v) =>
        new(Double3.Dot(_row0, v), Double3.Dot(_row1, v), Double3.Dot(_row2, v));

    public Double3 InverseRotate(in Double3 v) => _row0 * v.X + _row1 * v.Y + _row2 * v.Z;
}
