namespace Gjk.Core;

/// <summary>A vector of three <see cref="DoubleDouble"/>.</summary>
internal readonly struct VectorDD(in DoubleDouble x, in DoubleDouble y, in DoubleDouble z)
{
    public readonly DoubleDouble X = x, Y = y, Z = z;

    public static implicit operator VectorDD(in Double3 v) => new(v.X, v.Y, v.Z);

    public static explicit operator Double3(in VectorDD v) => new((double)v.X, (double)v.Y, (double)v.Z);

    public static VectorDD operator +(in VectorDD a, in VectorDD b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static VectorDD operator -(in VectorDD a, in VectorDD b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static VectorDD operator *(in VectorDD a, in DoubleDouble s) => new(a.X * s, a.Y * s, a.Z * s);

    public static DoubleDouble Dot(in VectorDD a, in VectorDD b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    public static VectorDD Cross(in VectorDD a, in VectorDD b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

    /// <summary>(q - p) × (r - p), the normal of a triangle, in 106 bits; of a needle, double's would lean.</summary>
    public static Double3 Normal(in Double3 p, in Double3 q, in Double3 r)
    {
        VectorDD origin = p;
        return (Double3)Cross(q - origin, r - origin);
    }

    /// <summary>A local point in the world.</summary>
    public static VectorDD ToWorld(in RigidPose pose, in VectorDD v) =>
        (VectorDD)(Double3)pose.Position + Rotate(pose.Rotation, v);

    /// <summary>A point of the world in a frame.</summary>
    public static VectorDD ToFrame(in RigidPose to, in VectorDD world)
    {
        Quaternion q = to.Rotation;
        return Rotate(new Quaternion(-q.X, -q.Y, -q.Z, q.W), world - (VectorDD)(Double3)to.Position);
    }

    /// <summary>v + 2 u × (u × v + w v) / |q|², the rotation by q = (u, w) without a matrix.</summary>
    public static VectorDD Rotate(in QuaternionD q, in VectorDD v)
    {
        VectorDD u = new Double3(q.X, q.Y, q.Z);
        DoubleDouble w = q.W;
        DoubleDouble norm = Dot(u, u) + w * w;
        return v + Cross(u, Cross(u, v) + v * w) * (2.0 / norm);
    }
}
