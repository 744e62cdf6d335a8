namespace Gjk.Core.Tests;

/// <summary>Exact geometry on whole numbers: every float is a multiple of 2^-149. Slow, and shares nothing with the
/// library.</summary>
internal static class HullOracle
{
    public static BigInteger Exact(float x)
    {
        int bits = BitConverter.SingleToInt32Bits(x);
        int exponent = bits >> 23 & 0xFF;
        BigInteger magnitude = bits & 0x7FFFFF;
        if (exponent > 0) magnitude = magnitude + 0x800000 << exponent - 1;
        return bits < 0 ? -magnitude : magnitude;
    }

    public static BigInteger[] Exact(Vector3 p) => [Exact(p.X), Exact(p.Y), Exact(p.Z)];

    public static BigInteger[] Minus(BigInteger[] a, BigInteger[] b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

    public static BigInteger Dot(BigInteger[] a, BigInteger[] b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

    public static BigInteger[] Cross(BigInteger[] a, BigInteger[] b) =>
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

    public static bool IsZero(BigInteger[] a) => a[0].IsZero && a[1].IsZero && a[2].IsZero;

    /// <summary>(b - a) x (c - a).</summary>
    public static BigInteger[] Normal(Vector3 a, Vector3 b, Vector3 c)
    {
        BigInteger[] origin = Exact(a);
        return Cross(Minus(Exact(b), origin), Minus(Exact(c), origin));
    }

    /// <summary>1 when p is strictly above the plane through a, b and c, seen from where they are
    /// counter-clockwise.</summary>
    public static int Side(Vector3 a, Vector3 b, Vector3 c, Vector3 p) =>
        Dot(Normal(a, b, c), Minus(Exact(p), Exact(a))).Sign;

    /// <summary>As <see cref="Side"/>; asks doubles first, with a bound a thousand times wider than their
    /// rounding.</summary>
    public static int QuickSide(Vector3 a, Vector3 b, Vector3 c, Vector3 p)
    {
        const double WideBound = 1e-12;
        double ux = (double)b.X - a.X, uy = (double)b.Y - a.Y, uz = (double)b.Z - a.Z;
        double vx = (double)c.X - a.X, vy = (double)c.Y - a.Y, vz = (double)c.Z - a.Z;
        double wx = (double)p.X - a.X, wy = (double)p.Y - a.Y, wz = (double)p.Z - a.Z;
        double volume = (uy * vz - uz * vy) * wx + (uz * vx - ux * vz) * wy + (ux * vy - uy * vx) * wz;
        double longest = (Math.Abs(ux) + Math.Abs(uy) + Math.Abs(uz)) * (Math.Abs(vx) + Math.Abs(vy) + Math.Abs(vz))
            * (Math.Abs(wx) + Math.Abs(wy) + Math.Abs(wz));
        return Math.Abs(volume) > WideBound * longest ? Math.Sign(volume) : Side(a, b, c, p);
    }

    /// <summary>The sign of direction . (a - b).</summary>
    public static int CompareAlong(Vector3 direction, Vector3 a, Vector3 b) =>
        Dot(Exact(direction), Minus(Exact(a), Exact(b))).Sign;

    /// <summary>What a cloud spans, by elimination: 0 a point, 1 a line, 2 a plane, 3 space.</summary>
    public static int Dimension(Vector3[] cloud)
    {
        BigInteger[] origin = Exact(cloud[0]);
        BigInteger[]? along = null, normal = null;
        foreach (Vector3 p in cloud)
        {
            BigInteger[] offset = Minus(Exact(p), origin);
            if (along is null)
            {
                if (!IsZero(offset)) along = offset;
            }
            else if (normal is null)
            {
                BigInteger[] cross = Cross(along, offset);
                if (!IsZero(cross)) normal = cross;
            }
            else if (!Dot(normal, offset).IsZero)
            {
                return 3;
            }
        }

        return along is null ? 0 : normal is null ? 1 : 2;
    }
}
