namespace Gjk.Exact.Randomness;

/// <summary>Rotations as they occur: none, even ones, by quarter and half turns, by next to nothing, and quaternions
/// whose length has drifted from 1.</summary>
public static class Rotations
{
    /// <summary>A pose accepts a length of 1 within 1e-3; the last tenth is left for the rounding to float.</summary>
    private const double Drift = 9e-4;

    public static Quaternion Any(Rng random) => random.Below(8) switch
    {
        0 => Quaternion.Identity,
        1 => Turned(random, random.Of(0.25, 0.5, 0.75) * Math.PI),
        2 => Tiny(random),
        3 => Drifted(random, random.Rotation()),
        _ => random.Rotation(),
    };

    /// <summary>By a thousandth of a radian down to far less than a float can hold beside 1.</summary>
    public static Quaternion Tiny(Rng random)
    {
        float angle = (float)random.Magnitude(1e-12, 1e-3);
        return random.Below(3) switch
        {
            0 => new(angle, 0, 0, 1),
            1 => new(0, angle, 0, 1),
            _ => new(angle, -angle, angle, 1),
        };
    }

    /// <summary>Turned by next to nothing.</summary>
    public static Quaternion Nudged(Rng random, Quaternion q) => Times(Tiny(random), q);

    /// <summary>The product in double, of unit length to float rounding whatever the lengths of the factors.</summary>
    public static Quaternion Times(Quaternion p, Quaternion q)
    {
        double px = p.X, py = p.Y, pz = p.Z, pw = p.W;
        return OfLength(
            1,
            pw * q.X + px * q.W + py * q.Z - pz * q.Y,
            pw * q.Y - px * q.Z + py * q.W + pz * q.X,
            pw * q.Z + px * q.Y - py * q.X + pz * q.W,
            pw * q.W - px * q.X - py * q.Y - pz * q.Z);
    }

    /// <summary>The rotation, to float rounding, with another length of its quaternion.</summary>
    public static Quaternion Drifted(Rng random, Quaternion q) =>
        OfLength(1 + random.Range(-Drift, Drift), q.X, q.Y, q.Z, q.W);

    /// <summary>About a coordinate axis; the argument is half the angle.</summary>
    private static Quaternion Turned(Rng random, double half)
    {
        float s = (float)Math.Sin(half), c = (float)Math.Cos(half);
        return random.Below(3) switch { 0 => new(s, 0, 0, c), 1 => new(0, s, 0, c), _ => new(0, 0, s, c) };
    }

    private static Quaternion OfLength(double length, double x, double y, double z, double w)
    {
        double s = length / Math.Sqrt(x * x + y * y + z * z + w * w);
        return new Quaternion((float)(x * s), (float)(y * s), (float)(z * s), (float)(w * s));
    }
}
