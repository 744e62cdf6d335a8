namespace Gjk.Exact.Certificates;

/// <summary>A posed shape with its own rotation matrix, made here from the quaternion and not taken from the
/// library.</summary>
public sealed class Body<T>
    where T : struct, ISupportMap
{
    private readonly T _shape;
    private readonly ApproximateRotation _rotation;

    public Body(in T shape, in RigidPose pose)
    {
        _shape = shape;
        Pose = pose;
        Center = shape.Center;
        _rotation = new ApproximateRotation(pose.Rotation);
        Radius = 0.5 * new Double3(
            Side(new Double3(1, 0, 0)), Side(new Double3(0, 1, 0)), Side(new Double3(0, 0, 1))).Length;
    }

    public RigidPose Pose { get; }

    public Double3 Position => Pose.Position;

    public Double3 Center { get; }

    /// <summary>Half the diagonal of the local bounding box, by the shape's own supports: the bounding radius may be
    /// generous.</summary>
    public double Radius { get; }

    public Double3 Rotate(in Double3 v) => _rotation.Rotate(v);

    public Double3 InverseRotate(in Double3 v) => _rotation.InverseRotate(v);

    public Double3 ToWorld(in Double3 local) => Rotate(local) + Position;

    /// <summary>How far the shape reaches from its position along a unit direction of the world.</summary>
    public double Height(in Double3 direction) =>
        Double3.Dot(direction, Rotate(Center)) + HeightOverCenter(direction);

    /// <summary>The same from its centre, which loses nothing where the shape is far from its own origin.</summary>
    public double HeightOverCenter(in Double3 direction) => LocalHeight(InverseRotate(direction));

    /// <summary>How far a local point is outside: the most that it exceeds the support by in any of the fixed
    /// directions, or in that from the centre.</summary>
    public double Outside(in Double3 local)
    {
        double most = double.NegativeInfinity;
        Double3 outward = local - Center;
        foreach (Double3 u in Directions.Many) most = Math.Max(most, Double3.Dot(u, outward) - LocalHeight(u));
        double length = outward.Length;
        if (length > 0) most = Math.Max(most, length - LocalHeight(outward * (1 / length)));
        return double.IsFinite(local.X + local.Y + local.Z) ? most : double.PositiveInfinity;
    }

    private double Side(in Double3 axis) => LocalHeight(axis) + LocalHeight(-axis);

    private double LocalHeight(in Double3 direction)
    {
        _shape.Support(direction, out Double3 point);
        return Double3.Dot(direction, point) + _shape.Margin;
    }
}
