#if NET
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <summary>The rotations of four cores in the frames of their shapes; every operation is that of
/// <see cref="QuaternionD"/>.</summary>
internal readonly struct WideQuaternion(in QuaternionD a, in QuaternionD b, in QuaternionD c, in QuaternionD d)
{
    private readonly Lanes _w = Vector256.Create(a.W, b.W, c.W, d.W);
    private readonly WideVector _u = new(
        Vector256.Create(a.X, b.X, c.X, d.X), Vector256.Create(a.Y, b.Y, c.Y, d.Y),
        Vector256.Create(a.Z, b.Z, c.Z, d.Z));

    /// <summary>Those of four shapes.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static WideQuaternion FromShapes(in ConvexShape a, in ConvexShape b, in ConvexShape c, in ConvexShape d) =>
        new(RotationOf(a), RotationOf(b), RotationOf(c), RotationOf(d));

    private static QuaternionD RotationOf(in ConvexShape shape) => (shape.Placement ?? Placement.None).UnitRotation;

    public WideVector Rotate(in WideVector v) =>
        v + WideVector.Cross(_u, WideVector.Cross(_u, v) + v * _w) * Vector256.Create(2.0);

    /// <summary>Turns the axes of poses, in the lanes of the mask.</summary>
    public void MultiplyInto(Lanes mask, ref Lanes x, ref Lanes y, ref Lanes z, ref Lanes w)
    {
        Lanes bx = _u.X, by = _u.Y, bz = _u.Z;
        Lanes turnedX = w * bx + x * _w + y * bz - z * by, turnedY = w * by + y * _w + z * bx - x * bz;
        Lanes turnedZ = w * bz + z * _w + x * by - y * bx, turnedW = w * _w - x * bx - y * by - z * bz;
        x = Vector256.ConditionalSelect(mask, turnedX, x);
        y = Vector256.ConditionalSelect(mask, turnedY, y);
        z = Vector256.ConditionalSelect(mask, turnedZ, z);
        w = Vector256.ConditionalSelect(mask, turnedW, w);
    }
}
#endif
