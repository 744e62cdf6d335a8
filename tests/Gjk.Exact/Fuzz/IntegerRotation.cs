namespace Gjk.Exact.Fuzz;

/// <summary>A rotation by a quaternion of small integers: quarter turns, thirds of a turn, the angles of the triangles
/// 3-4-5, 5-12-13 and 8-15-17, and products of them. Its matrix is integers over the squared length, so that multiples
/// of that length are turned without rounding; a float quaternion holds it exactly, since only ratios matter.</summary>
internal readonly record struct IntegerRotation(int X, int Y, int Z, int W)
{
    /// <summary>Bits of the factor that brings the quaternion to about unit length: with the integers' own bits it fits
    /// into a float.</summary>
    private const int FactorBits = 12;

    /// <summary>The squared length, the matrix's denominator.</summary>
    public int Norm => X * X + Y * Y + Z * Z + W * W;

    /// <summary>Bits of the norm.</summary>
    public int Bits => 32 - BitOperations.LeadingZeroCount((uint)Norm);

    public static IntegerRotation Identity => new(0, 0, 0, 1);

    /// <summary>None, one or two turns about coordinate axes, or one about a cube's diagonal.</summary>
    public static IntegerRotation Any(Rng random) => random.Below(6) switch
    {
        0 => Identity,
        1 => new IntegerRotation(random.Sign(), random.Sign(), random.Sign(), 1),
        2 => AboutAxis(random, random.Below(3)).Times(AboutAxis(random, random.Below(3))),
        _ => AboutAxis(random, random.Below(3)),
    };

    public static IntegerRotation AboutY(Rng random) => AboutAxis(random, 1);

    public IntegerRotation Times(in IntegerRotation q) => new(
        W * q.X + X * q.W + Y * q.Z - Z * q.Y,
        W * q.Y - X * q.Z + Y * q.W + Z * q.X,
        W * q.Z + X * q.Y - Y * q.X + Z * q.W,
        W * q.W - X * q.X - Y * q.Y - Z * q.Z);

    /// <summary>The rotation in floats, exactly, or as near as a quaternion of unit length gets.</summary>
    public Quaternion ToQuaternion(Rng random)
    {
        double factor = 1 / Math.Sqrt(Norm);
        if (!random.OneIn(4))
            factor = Math.Round(Math.ScaleB(factor, FactorBits + Bits / 2)) / Math.ScaleB(1, FactorBits + Bits / 2);
        return new Quaternion((float)(X * factor), (float)(Y * factor), (float)(Z * factor), (float)(W * factor));
    }

    /// <summary>Turns a vector; exact for multiples of the norm that are small enough.</summary>
    public Double3 Exactly(in Double3 v)
    {
        var p = new Double3(v.X / Norm, v.Y / Norm, v.Z / Norm);
        return new Double3(
            (W * W + X * X - Y * Y - Z * Z) * p.X + 2 * (X * Y - W * Z) * p.Y + 2 * (X * Z + W * Y) * p.Z,
            2 * (X * Y + W * Z) * p.X + (W * W - X * X + Y * Y - Z * Z) * p.Y + 2 * (Y * Z - W * X) * p.Z,
            2 * (X * Z - W * Y) * p.X + 2 * (Y * Z + W * X) * p.Y + (W * W - X * X - Y * Y + Z * Z) * p.Z);
    }

    private static IntegerRotation AboutAxis(Rng random, int axis)
    {
        (int s, int c) = random.Of((1, 1), (1, 0), (1, 2), (2, 3), (1, 4), (1, 3));
        s *= random.Sign();
        return axis switch { 0 => new(s, 0, 0, c), 1 => new(0, s, 0, c), _ => new(0, 0, s, c) };
    }
}
