namespace Gjk.Demo.Trace;

/// <summary>A shape as the textbook sees it: a furthest point in world coordinates, everything in float.</summary>
internal readonly struct TextbookBody
{
    private readonly ConvexShape _shape;
    private readonly RigidPose _pose;

    public TextbookBody(in ConvexShape shape, in RigidPose pose)
    {
        _shape = shape;
        _pose = pose;
    }

    /// <summary>The shape's centre.</summary>
    public Vector3 Center => ToWorld(_shape.Center);

    /// <summary>The furthest point of the core along a direction.</summary>
    public Vector3 FurthestPoint(Vector3 direction)
    {
        _shape.Support(TextbookMath.Rotated(direction, Quaternion.Conjugate(_pose.Rotation)), out Double3 point);
        return ToWorld(_shape.Center + point);
    }

    private Vector3 ToWorld(in Double3 local) => TextbookMath.Rotated((Vector3)local, _pose.Rotation) + _pose.Position;
}
