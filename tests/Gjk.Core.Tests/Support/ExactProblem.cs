using System;
using System.Linq;
using System.Numerics;

namespace Gjk.Core.Tests.Support;

/// <summary>Two posed clouds as integer vectors: the Minkowski vertex of i and j is (A[i] - B[j]) · 2^Exponent / Denominator.</summary>
internal sealed class ExactProblem
{
    private readonly Int3[] _a, _b;

    public ExactProblem(Vector3D[] a, double marginA, in RigidPose poseA, Vector3D[] b, double marginB, in RigidPose poseB)
    {
        int exponent = Math.Min(Math.Min(Exact.Exponent(marginA), Exact.Exponent(marginB)), Math.Min(ExponentOf(poseA.Position), ExponentOf(poseB.Position)));
        exponent = Math.Min(exponent, a.Concat(b).Min(v => ExponentOf(v)));
        Exponent = exponent == Exact.NoExponent ? 0 : exponent;
        var rotationA = new ExactRotation(poseA.Rotation);
        var rotationB = new ExactRotation(poseB.Rotation);
        Denominator = rotationA.Denominator * rotationB.Denominator;
        _a = Place(a, rotationA, poseA.Position, rotationB.Denominator);
        _b = Place(b, rotationB, poseB.Position, rotationA.Denominator);
        Margins = Exact.ToInteger(marginA, Exponent) + Exact.ToInteger(marginB, Exponent);
    }

    public int Exponent { get; }

    public BigInteger Denominator { get; }

    /// <summary>Both margins, in units of 2^Exponent.</summary>
    public BigInteger Margins { get; }

    public Int3 Support(in Int3 direction) => Furthest(_a, direction) - Furthest(_b, -direction);

    private static Int3 Furthest(Int3[] points, in Int3 direction)
    {
        Int3 best = points[0];
        BigInteger bestDot = Int3.Dot(best, direction);
        for (int i = 1; i < points.Length; i++)
        {
            BigInteger dot = Int3.Dot(points[i], direction);
            if (dot <= bestDot) continue;
            bestDot = dot;
            best = points[i];
        }

        return best;
    }

    private Int3[] Place(Vector3D[] points, ExactRotation rotation, Vector3D position, BigInteger otherDenominator)
    {
        Int3 origin = Integer(position) * rotation.Denominator;
        return [.. points.Distinct().Select(p => (rotation.Rotate(Integer(p)) + origin) * otherDenominator)];
    }

    private Int3 Integer(in Vector3D v) =>
        new(Exact.ToInteger(v.X, Exponent), Exact.ToInteger(v.Y, Exponent), Exact.ToInteger(v.Z, Exponent));

    private static int ExponentOf(in Vector3D v) => Math.Min(Math.Min(Exact.Exponent(v.X), Exact.Exponent(v.Y)), Exact.Exponent(v.Z));
}

/// <summary>The rotation of a quaternion that need not be of unit length: an integer matrix over an integer denominator, |q|².</summary>
internal sealed class ExactRotation
{
    private readonly Int3 _row0, _row1, _row2;

    public ExactRotation(Quaternion q)
    {
        int exponent = Math.Min(Math.Min(Exact.Exponent(q.X), Exact.Exponent(q.Y)), Math.Min(Exact.Exponent(q.Z), Exact.Exponent(q.W)));
        BigInteger x = Exact.ToInteger(q.X, exponent), y = Exact.ToInteger(q.Y, exponent);
        BigInteger z = Exact.ToInteger(q.Z, exponent), w = Exact.ToInteger(q.W, exponent);
        BigInteger xx = x * x, yy = y * y, zz = z * z, ww = w * w;
        Denominator = xx + yy + zz + ww;
        _row0 = new Int3(ww + xx - yy - zz, 2 * (x * y - w * z), 2 * (x * z + w * y));
        _row1 = new Int3(2 * (x * y + w * z), ww - xx + yy - zz, 2 * (y * z - w * x));
        _row2 = new Int3(2 * (x * z - w * y), 2 * (y * z + w * x), ww - xx - yy + zz);
    }

    public BigInteger Denominator { get; }

    public Int3 Rotate(in Int3 v) => new(Int3.Dot(_row0, v), Int3.Dot(_row1, v), Int3.Dot(_row2, v));
}
