namespace Gjk.Demo.Trace;

/// <summary>The pose of B seen from A, in double. This is the frame in which the solver works and the page
/// draws.</summary>
internal readonly struct RelativeFrame
{
    private readonly double _x, _y, _z, _w;
    private readonly Quaternion _rotationA;

    public RelativeFrame(in RigidPose a, in RigidPose b)
    {
        Quaternion p = a.Rotation, q = b.Rotation;
        _rotationA = p;
        _x = (double)p.W * q.X - (double)p.X * q.W - (double)p.Y * q.Z + (double)p.Z * q.Y;
        _y = (double)p.W * q.Y - (double)p.Y * q.W - (double)p.Z * q.X + (double)p.X * q.Z;
        _z = (double)p.W * q.Z - (double)p.Z * q.W - (double)p.X * q.Y + (double)p.Y * q.X;
        _w = (double)p.W * q.W + (double)p.X * q.X + (double)p.Y * q.Y + (double)p.Z * q.Z;
        Position = Turned((Double3)b.Position - a.Position, -(double)p.X, -(double)p.Y, -(double)p.Z, p.W);
    }

    public Double3 Position { get; }

    /// <summary>Converts a point of B to A's frame.</summary>
    public Double3 Place(in Double3 local) => Turned(local, _x, _y, _z, _w) + Position;

    /// <summary>Converts a direction from A's frame to B's.</summary>
    public Double3 InverseTurn(in Double3 direction) => Turned(direction, -_x, -_y, -_z, _w);

    /// <summary>Converts a direction from the world to A's frame.</summary>
    public Double3 FromWorld(in Double3 direction) =>
        Turned(direction, -(double)_rotationA.X, -(double)_rotationA.Y, -(double)_rotationA.Z, _rotationA.W);

    public double[] Quaternion() => [_x, _y, _z, _w];

    /// <summary>The rotation v + 2 u × (u × v + w v) / |q|².</summary>
    private static Double3 Turned(in Double3 v, double x, double y, double z, double w)
    {
        var u = new Double3(x, y, z);
        return v + Double3.Cross(u, Double3.Cross(u, v) + v * w) * (2 / (u.LengthSquared + w * w));
    }
}
