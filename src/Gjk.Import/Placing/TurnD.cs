namespace Gjk.Import;

/// <summary>A rotation as a quaternion in double, so that a product along a hierarchy loses nothing.</summary>
internal readonly record struct TurnD(double X, double Y, double Z, double W)
{
    public static readonly TurnD Identity = new(0, 0, 0, 1);

    /// <summary>From y to x, which lays an axis along y on x.</summary>
    public static readonly TurnD YToX = new(0, 0, -Math.Sqrt(0.5), Math.Sqrt(0.5));

    /// <summary>From y to z, which lays an axis along y on z.</summary>
    public static readonly TurnD YToZ = new(Math.Sqrt(0.5), 0, 0, Math.Sqrt(0.5));

    /// <summary>The rotation with columns of length 1 at right angles (Shepperd 1978, "Quaternion from Rotation
    /// Matrix", the largest of the four components first).</summary>
    public static TurnD FromAxes(in Double3 x, in Double3 y, in Double3 z)
    {
        double trace = x.X + y.Y + z.Z;
        if (trace >= Math.Max(x.X, Math.Max(y.Y, z.Z)))
            return new TurnD(y.Z - z.Y, z.X - x.Z, x.Y - y.X, 1 + trace).Normalized();
        if (x.X >= y.Y && x.X >= z.Z)
            return new TurnD(1 + x.X - y.Y - z.Z, x.Y + y.X, z.X + x.Z, y.Z - z.Y).Normalized();
        return y.Y >= z.Z
            ? new TurnD(x.Y + y.X, 1 + y.Y - x.X - z.Z, y.Z + z.Y, z.X - x.Z).Normalized()
            : new TurnD(z.X + x.Z, y.Z + z.Y, 1 + z.Z - x.X - y.Y, x.Y - y.X).Normalized();
    }

    /// <summary>First the right one, then the left one.</summary>
    public static TurnD operator *(in TurnD a, in TurnD b) => new(
        a.W * b.X + a.X * b.W + a.Y * b.Z - a.Z * b.Y,
        a.W * b.Y - a.X * b.Z + a.Y * b.W + a.Z * b.X,
        a.W * b.Z + a.X * b.Y - a.Y * b.X + a.Z * b.W,
        a.W * b.W - a.X * b.X - a.Y * b.Y - a.Z * b.Z);

    /// <summary>The rotation as seen in a mirror: mirror * this * mirror. The mirror has a 1 or -1 along each
    /// axis.</summary>
    public TurnD Mirrored(in Double3 signs) =>
        new(X * signs.Y * signs.Z, Y * signs.Z * signs.X, Z * signs.X * signs.Y, W);

    /// <summary>Length 1. NaN if all four are 0.</summary>
    public TurnD Normalized()
    {
        double length = Math.Sqrt(X * X + Y * Y + Z * Z + W * W);
        return new TurnD(X / length, Y / length, Z / length, W / length);
    }

    /// <summary>What is written to the scene.</summary>
    public Quaternion ToFloat() => new((float)X, (float)Y, (float)Z, (float)W);

    public static TurnD From(Quaternion q) => new TurnD(q.X, q.Y, q.Z, q.W).Normalized();

    /// <summary>The rotation as a matrix. Expects length 1.</summary>
    public Affine ToAffine() => new(
        new Double3(1 - 2 * (Y * Y + Z * Z), 2 * (X * Y + Z * W), 2 * (X * Z - Y * W)),
        new Double3(2 * (X * Y - Z * W), 1 - 2 * (X * X + Z * Z), 2 * (Y * Z + X * W)),
        new Double3(2 * (X * Z + Y * W), 2 * (Y * Z - X * W), 1 - 2 * (X * X + Y * Y)),
        default);
}
