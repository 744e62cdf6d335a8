namespace Gjk.Core.Tests.Support;

/// <summary>Paths through a world that are hard for slabs: along axes and faces, grazing, from far away, very long,
/// very short, and none at all.</summary>
internal static class PathFamilies
{
    public const int Count = 12;

    /// <summary>A start, the motion, and the part of it that is asked about.</summary>
    public static (Vector3 Start, Vector3 Motion, float Most) Make(Rng rng, int family, MovingWorld world, float side)
    {
        Vector3 offset = world.Poses[0].Position, start = Inside(rng, world), end = Inside(rng, world);
        Vector3 toEnd = end - start;
        float infinite = float.PositiveInfinity;
        return family switch
        {
            0 => (start, toEnd, 1),
            1 => (start, toEnd, rng.Float(0, 1)),
            2 => (start - toEnd * 3, toEnd, infinite),
            3 => (start, Axis(rng) * side, rng.Below(2) == 0 ? infinite : 1),
            4 => Grazing(rng, world, side),
            5 => Between(start - rng.UnitVector() * 1e6f * side, end, infinite),
            6 => Aimed(end, rng.UnitVector() * 1e30f),
            7 => (start, rng.UnitVector() * 1e30f, rng.Below(2) == 0 ? infinite : 1e-30f),
            8 => (start, rng.UnitVector() * 1e-40f, rng.Below(2) == 0 ? infinite : 1e38f),
            9 => (start, new Vector3(rng.Float(-1, 1), rng.Float(-1e-30, 1e-30), rng.Float(-1e-42, 1e-42)), infinite),
            10 => (world.Poses[rng.Below(world.Count)].Position, rng.UnitVector(), rng.Below(2) == 0 ? 0 : infinite),
            _ => Between(offset - Axis(rng) * 1e30f, offset, rng.Below(2) == 0 ? infinite : 1.5f),
        };
    }

    private static Vector3 Inside(Rng rng, MovingWorld world)
    {
        Vector3 a = world.Poses[rng.Below(world.Count)].Position, b = world.Poses[rng.Below(world.Count)].Position;
        return Vector3.Lerp(a, b, rng.Float(0, 1)) + rng.Vector(-1, 1);
    }

    private static (Vector3 Start, Vector3 Motion, float Most) Between(Vector3 start, Vector3 end, float most) =>
        (start, end - start, most);

    private static (Vector3 Start, Vector3 Motion, float Most) Aimed(Vector3 end, Vector3 from) =>
        (end + from, -from, float.PositiveInfinity);

    /// <summary>Through a point of an object's surface, perpendicular to the normal there, or nearly so.</summary>
    private static (Vector3 Start, Vector3 Motion, float Most) Grazing(Rng rng, MovingWorld world, float side)
    {
        int i = rng.Below(world.Count);
        RigidPose from = new(world.Poses[i].Position + rng.UnitVector() * 20);
        DistanceResult touch = ConvexQuery.Distance(ConvexShape.Sphere(0), from, world.Shapes[i], world.Poses[i]);
        Vector3 along = Vector3.Cross(touch.Normal, rng.UnitVector());
        if (rng.Below(2) == 0) along = Vector3.Cross(touch.Normal, Axis(rng));
        if (!(along.Length() > 0.01f)) along = Vector3.UnitX;
        float away = rng.Below(3) switch { 0 => 1, 1 => side, _ => 1000 * side };
        return (touch.PointB - along * away, along * (2 * away), rng.Below(2) == 0 ? 1 : float.PositiveInfinity);
    }

    private static Vector3 Axis(Rng rng) => Math.Sign(rng.Below(2) - 0.5) * (rng.Below(3) switch
    {
        0 => Vector3.UnitX,
        1 => Vector3.UnitY,
        _ => Vector3.UnitZ,
    });
}
