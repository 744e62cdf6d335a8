namespace Gjk.Exact.Scenes;

/// <summary>Moving scenes with warm starts, asked every question in every frame: the report's cubes and spheres, and a
/// world of all kinds of shapes.</summary>
internal static class SceneRun
{
    private const int Frames = 4, WorldObjects = 60;

    /// <summary>Object sizes per frame.</summary>
    private const double Speed = 0.05;

    public static BitHash Hash()
    {
        var hash = new BitHash();
        Run(BuiltInScenes.Cubes(WorldObjects), null, BroadPhaseKind.DynamicTree, ref hash);
        Run(BuiltInScenes.Spheres(), null, BroadPhaseKind.DynamicTree, ref hash);
        Run(BuiltInScenes.Cubes(WorldObjects), new Rng(4), BroadPhaseKind.SortAndSweep, ref hash);
        return hash;
    }

    /// <param name="built">Where the objects are.</param>
    /// <param name="mixed">Chooses their shapes; null for the scene's own.</param>
    /// <param name="phase">How pairs are found.</param>
    /// <param name="hash">Gets the answers.</param>
    private static void Run(BuiltInScene built, Rng? mixed, BroadPhaseKind phase, ref BitHash hash)
    {
        ConvexShape own = ConvexShape.Mesh(built.Vertices);
        var scene = new CollisionScene(phase);
        foreach (RigidPose pose in built.Poses) scene.Add(mixed is null ? own : RandomShape.Make(mixed), pose);
        var moving = new MovingObjects(built, Speed);
        var random = new Rng(5);
        for (int frame = 0; frame < Frames; frame++)
        {
            AskPairs(scene, ref hash);
            AskWorld(scene, own, moving.Poses[frame], random, ref hash);
            moving.Advance();
            for (int id = 0; id < moving.Poses.Length; id++) scene.Move(id, moving.Poses[id]);
        }
    }

    private static void AskPairs(CollisionScene scene, ref BitHash hash)
    {
        var overlaps = new List<ObjectPair>();
        scene.FindOverlaps(overlaps);
        foreach (ObjectPair pair in overlaps) Add(pair, ref hash);
        var near = new List<PairDistance>();
        scene.FindPairsWithin(0.5f, near);
        foreach (PairDistance p in near)
        {
            Add(p.Pair, ref hash);
            hash.Add(p.Result);
        }

        scene.FindDepths(near);
        foreach (PairDistance p in near)
        {
            Add(p.Pair, ref hash);
            hash.Add(p.Result);
        }

        var touching = new List<PairContacts>();
        scene.FindContacts(0.02f, touching);
        foreach (PairContacts p in touching)
        {
            Add(p.Pair, ref hash);
            hash.Add(p.Result);
            hash.Add(p.Manifold);
        }
    }

    private static void AskWorld(
        CollisionScene scene, in ConvexShape shape, in RigidPose pose, Rng random, ref BitHash hash)
    {
        var rays = new List<RayHit>();
        var casts = new List<CastHit>();
        for (int i = 0; i < 10; i++)
        {
            Vector3 motion = random.Vector(4);
            scene.FindRayHits(new RayQuery(pose.Position, motion), rays);
            foreach (RayHit hit in rays)
            {
                hash.Add(hit.Id);
                hash.Add(hit.Result);
            }

            scene.FindCastHits(shape, pose, motion, casts);
            foreach (CastHit hit in casts)
            {
                hash.Add(hit.Id);
                hash.Add(hit.Result);
            }

            var place = new RigidPose(pose.Rotation, pose.Position + motion);
            scene.TryFindNearest(shape, place, out PairDistance nearest);
            hash.Add(nearest.Pair.B);
            hash.Add(nearest.Result);
        }
    }

    private static void Add(ObjectPair pair, ref BitHash hash)
    {
        hash.Add(pair.A);
        hash.Add(pair.B);
    }
}
