namespace Gjk.Core.Tests.Support;

/// <summary>A frame of a scene that asks all that can be asked of it.</summary>
internal static class EveryFrame
{
    private const int Objects = 120;

    /// <summary>Every object moves to and fro; all questions are asked.</summary>
    public static Action Of(BroadPhaseKind kind, Workers? workers, int count = Objects)
    {
        var world = new MovingWorld(21, count, ["box", "hull", "sphere", "cylinder"]);
        var there = new RigidPose[count];
        for (int i = 0; i < count; i++)
            there[i] = new RigidPose(world.Rng.Rotation(), world.Poses[i].Position + world.Rng.Vector(-0.1, 0.1));
        RigidPose[] here = [.. world.Poses];
        CollisionScene scene = world.Scene(kind);
        List<ObjectPair> overlaps = [], candidates = [];
        List<PairDistance> within = [];
        List<PairContacts> contacts = [];
        ConvexShape[] shapes = [.. world.Shapes];
        var pairs = new ObjectPair[3 * count];
        var statuses = new GjkStatus[pairs.Length];
        var distances = new DistanceResult[pairs.Length];
        for (int i = 0; i < pairs.Length; i++)
            pairs[i] = new ObjectPair(world.Rng.Below(count), world.Rng.Below(count));
        RayQuery[] rays =
            [.. Enumerable.Range(0, count).Select(i => new RayQuery(here[i].Position, world.Rng.UnitVector()))];
        Vector3[] motions = [.. Enumerable.Range(0, count).Select(_ => world.Rng.Vector(-1, 1))];
        var firstHits = new RayHit[count];
        List<RayHit> rayHits = [];
        List<CastHit> castHits = [];
        List<int> overlapping = [];
        int[] ids = [.. Enumerable.Range(0, count)];
        var casts = new CastResult[pairs.Length];
        var rayResults = new RayCastResult[count];
        bool back = false;
        return () =>
        {
            RigidPose[] poses = back ? here : there;
            back = !back;
            if (workers is null)
                for (int i = 0; i < count; i++) scene.Move(i, poses[i]);
            else scene.MoveAll(ids, poses, workers);
            scene.FindOverlaps(overlaps, workers);
            scene.CollectCandidates(candidates, 0, workers);
            scene.FindOverlapsAmong(candidates, overlaps, workers);
            scene.FindPairsWithin(0.2f, within, workers);
            scene.FindDepths(within, workers);
            scene.FindContacts(0, contacts, workers);
            scene.FindContacts(0.05f, contacts, workers);
            for (int i = 0; i < 50 && i + 1 < count; i++)
            {
                scene.TryFindNearest(i, out _);
                scene.Distance(i, i + 1);
            }

            AskPaths(scene, shapes, poses, rays, firstHits, rayHits, castHits, overlapping, workers);
            PairBatch.Cast(shapes, poses, motions, pairs, casts, 1, workers);
            RayBatch.RayCast(shapes[0], poses[0], rays, rayResults, workers);
            PairBatch.Overlaps(shapes, poses, pairs, statuses, workers);
            PairBatch.Distance(shapes, poses, pairs, distances, 1, workers);
        };
    }

    private static void AskPaths(
        CollisionScene scene, ConvexShape[] shapes, RigidPose[] poses, RayQuery[] rays, RayHit[] firstHits,
        List<RayHit> rayHits, List<CastHit> castHits, List<int> ids, Workers? workers)
    {
        scene.FindFirstRayHits(rays, firstHits, workers);
        for (int i = 0; i < 20; i++)
        {
            scene.TryFindRayHit(rays[i], out _);
            scene.FindRayHits(rays[i], rayHits);
            scene.TryFindCastHit(shapes[i], poses[i], Vector3.UnitX, out _);
            scene.FindCastHits(shapes[i], poses[i], Vector3.UnitX, castHits);
            scene.FindObjectsOverlapping(shapes[i], poses[i], ids);
            scene.TryFindNearest(shapes[i], poses[i], out _, 1);
        }
    }
}
