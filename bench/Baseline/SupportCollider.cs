namespace Gjk.Bench.Baseline;

/// <summary>The view that the report's GJK has of a collider: the furthest point in a direction, in the world
/// frame.</summary>
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
