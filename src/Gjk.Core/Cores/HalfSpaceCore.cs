namespace Gjk.Core;

/// <summary>A half-space: all points x with n · x at most the offset. However it is scaled, widened or placed, it is
/// one again, so it never has a layer around it. Normal and offset are kept to 106 bits, so that one placed far away
/// loses no accuracy.</summary>
internal readonly struct HalfSpaceCore(in Double3 normal, in Double3 normalError, in Double3 offset)
{
    /// <summary>Length: beyond all floats; how far the box about a half-space reaches.</summary>
    public const double Endless = 1e39;

    /// <summary>The outward normal, of any length but 0.</summary>
    public readonly Double3 Normal = normal;

    /// <summary>What rounding took away from the normal.</summary>
    public readonly Double3 NormalError = normalError;

    /// <summary>X is the offset in units of the normal's length, and Y what rounding took away from it.</summary>
    public readonly Double3 Offset = offset;

    private HalfSpaceCore(in VectorDD normal, in DoubleDouble offset)
        : this(
            new Double3(normal.X.High, normal.Y.High, normal.Z.High),
            new Double3(normal.X.Low, normal.Y.Low, normal.Z.Low), new Double3(offset.High, offset.Low, 0))
    {
    }

    /// <summary>The normal's length.</summary>
    public double Length => Normal.Length;

    /// <summary>The outward normal, of unit length.</summary>
    public Double3 Unit => Normal * (1 / Length);

    /// <summary>How far the plane is from the local origin, along the normal.</summary>
    public double PlaneDistance => Offset.X / Length;

    /// <summary>How far a point is outside, in units of the normal's length, the plane turned by a rotation about its
    /// origin.</summary>
    /// <param name="rotation">The rotation.</param>
    /// <param name="point">From the origin of the half-space, in the axes that it is turned to.</param>
    public double Outside(in QuaternionD rotation, in VectorDD point) =>
        (double)(VectorDD.Dot(VectorDD.Rotate(rotation, Exact), point) - ExactOffset);

    /// <summary>What lies on the other side of the plane.</summary>
    public HalfSpaceCore Complement => new(-Normal, -NormalError, -Offset);

    /// <summary>Widens it.</summary>
    public HalfSpaceCore Widened(double radius) => new(Exact, ExactOffset + DoubleDouble.Product(Length, radius));

    /// <summary>Turns and moves it.</summary>
    public HalfSpaceCore Moved(in RigidPose pose)
    {
        VectorDD normal = VectorDD.Rotate(pose.Rotation, Exact);
        return new(normal, ExactOffset + VectorDD.Dot(normal, (Double3)pose.Position));
    }

    /// <summary>Scales it: x = y / s in n · x, times the product of all factors, which keeps their order.</summary>
    public HalfSpaceCore Stretched(in Double3 s)
    {
        double sign = s.X * s.Y * s.Z < 0 ? -1 : 1;
        var normal = new VectorDD(
            Exact.X * (sign * s.Y * s.Z), Exact.Y * (sign * s.X * s.Z), Exact.Z * (sign * s.X * s.Y));
        DoubleDouble offset = ExactOffset * DoubleDouble.Product(s.X * s.Y, sign * s.Z);
        double unit = 1 / PowerOfTwo.AtMost(((Double3)normal).LargestMagnitude);
        return new(normal * unit, offset * unit);
    }

    private VectorDD Exact => (VectorDD)Normal + NormalError;

    private DoubleDouble ExactOffset => new(Offset.X, Offset.Y);
}
