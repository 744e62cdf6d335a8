using Quaternion = System.Numerics.Quaternion;
using Vector3 = System.Numerics.Vector3;

namespace Gjk.Demo.Trace;

/// <summary>Products of float vectors, one rounded operation after the other. System.Numerics joins some of them where
/// the processor can, so its loops would fail on other pairs on other machines.</summary>
internal static class TextbookMath
{
    public static float Dot(Vector3 a, Vector3 b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    public static Vector3 Cross(Vector3 a, Vector3 b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

    /// <summary>The rotation v + 2 u × (u × v + w v) by a unit quaternion.</summary>
    public static Vector3 Rotated(Vector3 v, Quaternion q)
    {
        var u = new Vector3(q.X, q.Y, q.Z);
        return v + 2 * Cross(u, Cross(u, v) + q.W * v);
    }
}
