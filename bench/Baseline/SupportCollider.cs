using System.Numerics;

namespace Gjk.Bench.Baseline;

/// <summary>What the report's GJK sees of a collider: the point that is furthest in a direction, in the world frame.</summary>
public abstract class SupportCollider
{
    protected SupportCollider(Quaternion rotation, Vector3 position)
    {
        Rotation = rotation;
        Position = position;
    }

    public Quaternion Rotation { get; }

    public Vector3 Position { get; }

    public abstract Vector3 FindFurthestPoint(Vector3 direction);
}
