namespace Gjk.Core;

/// <summary>A quaternion of doubles, of any length: the rotation in the middle of a motion, or of a shape inside a
/// shape, which a float would round by more than the tolerance. See <see cref="RotationD"/> for the matrix.</summary>
internal struct QuaternionD(double x, double y, double z, double w)
{
    public double X = x, Y = y, Z = z, W = w;

    /// <summary>No rotation.</summary>
    public static QuaternionD Identity => new(0, 0, 0, 1);

    public static implicit operator QuaternionD(Quaternion q) => new(q.X, q.Y, q.Z, q.W);

    /// <summary>Widens in place, without a copy.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Widen(in Quaternion q, out QuaternionD wide)
    {
        wide.X = q.X;
        wide.Y = q.Y;
        wide.Z = q.Z;
        wide.W = q.W;
    }

    public readonly double LengthSquared
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => X * X + Y * Y + Z * Z + W * W;
    }

    public readonly QuaternionD Conjugate => new(-X, -Y, -Z, W);

    public static QuaternionD operator *(in QuaternionD q, double scale) =>
        new(q.X * scale, q.Y * scale, q.Z * scale, q.W * scale);

    /// <summary>The turn by an angle in radians about an axis of unit length.</summary>
    public static QuaternionD About(in Double3 axis, double angle)
    {
        SineCosine.Compute(0.5 * angle, out double sine, out double cosine);
        return new QuaternionD(axis.X * sine, axis.Y * sine, axis.Z * sine, cosine);
    }

    /// <summary>The turn by b, followed by that by a.</summary>
    public static QuaternionD operator *(in QuaternionD a, in QuaternionD b) => new(
        a.W * b.X + a.X * b.W + a.Y * b.Z - a.Z * b.Y,
        a.W * b.Y + a.Y * b.W + a.Z * b.X - a.X * b.Z,
        a.W * b.Z + a.Z * b.W + a.X * b.Y - a.Y * b.X,
        a.W * b.W - a.X * b.X - a.Y * b.Y - a.Z * b.Z);

    /// <summary>A vector turned by a quaternion of unit length: v + 2 u × (u × v + w v).</summary>
    public readonly Double3 Rotate(in Double3 v)
    {
        var u = new Double3(X, Y, Z);
        return v + Double3.Cross(u, Double3.Cross(u, v) + v * W) * 2;
    }
}
