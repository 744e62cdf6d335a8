namespace Gjk.Core.Tests.Queries;

/// <summary>Half-spaces beside meshes, solids and compounds, in batches and in scenes, against part after part and
/// object after object.</summary>
public class HalfSpaceSceneTests
{
    private static readonly ConvexShape Floor = ConvexShape.HalfSpace(new Vector3(0.1f, 1, 0), 0.25f);
    private static readonly ConvexShape Wall = ConvexShape.HalfSpace(Vector3.UnitX, -6);

    [Fact]
    public void EveryPartIsAsked()
    {
        var scratch = new ConcaveScratch();
        var pairs = new List<PairDistance>();
        var contacts = new List<PairContacts>();
        AnyShape floor = AnyShape.Of(Floor);
        int overlaps = 0;
        for (ulong seed = 1; seed <= 120; seed++)
        {
            Draw(seed, out AnyShape shape, out RigidPose pose, out RigidPose at, out _);
            float[] all = [.. Parts(shape).Select(p => ConvexQuery.Distance(Floor, at, p, pose).Distance)];
            float least = all.Min();
            int within = all.Count(d => d <= 0.5f);
            string message = $"seed {seed}, {shape.Kind}";
            PairDistance found = ConcaveQuery.Distance(floor, at, shape, pose, scratch);
            Assert.True(found.Distance == least, $"{message}: {found} for {least}");
            Assert.Equal(found.Distance, ConcaveQuery.Distance(shape, pose, floor, at, scratch).Distance);
            Assert.Equal(least == 0, ConcaveQuery.Overlaps(floor, at, shape, pose, scratch));
            overlaps += least == 0 ? 1 : 0;
            Assert.True(ConcaveQuery.FindPairsWithin(floor, at, shape, pose, 0.5f, scratch, pairs));
            Assert.True(pairs.Count == within, message);
            Assert.True(ConcaveQuery.FindContacts(floor, at, shape, pose, 0.5f, scratch, contacts));
            Assert.True(contacts.Count == within, message);
            foreach (PairContacts contact in contacts)
            {
                ConvexShape part = Parts(shape)[Math.Max(contact.PartB, 0)];
                DistanceResult own = ConvexQuery.SignedDistance(Floor, at, part, pose);
                Assert.True(ResultBits.AreSame(own, contact.Result), message);
            }
        }

        Assert.InRange(overlaps, 20, 110);
    }

    [Fact]
    public void TheFirstPartIsMet()
    {
        var scratch = new ConcaveScratch();
        AnyShape floor = AnyShape.Of(Floor);
        int hits = 0;
        for (ulong seed = 1; seed <= 120; seed++)
        {
            Draw(seed, out AnyShape shape, out RigidPose pose, out RigidPose at, out Vector3 way);
            ConvexShape[] parts = Parts(shape);
            string message = $"seed {seed}, {shape.Kind}";
            CastHit hit = ConcaveQuery.Cast(floor, at, default, shape, pose, way, scratch);
            CastResult first = First(parts.Select(p => ConvexQuery.Cast(Floor, at, default, p, pose, way)));
            Assert.True(hit.Status == first.Status && hit.Result.Fraction == first.Fraction, $"{message}: {hit}");
            hits += hit.Result.IsHit ? 1 : 0;
            var still = new RigidMotion(at, default);
            var turning = new RigidMotion(pose, way, new Vector3(0.5f, -0.25f, 1));
            hit = ConcaveQuery.TimeOfImpact(floor, still, shape, turning, scratch);
            first = First(parts.Select(p => ConvexQuery.TimeOfImpact(Floor, still, p, turning)));
            Assert.True(hit.Status == first.Status && hit.Result.Fraction == first.Fraction, $"{message}: {hit}");
        }

        Assert.InRange(hits, 40, 119);

        static CastResult First(IEnumerable<CastResult> all) => all.OrderBy(c => c.IsHit ? c.Fraction : 2).First();
    }

    [Fact]
    public void ARayMeetsItAsAnAnyShape()
    {
        RayHit hit = ConcaveQuery.RayCast(
            AnyShape.Of(ConvexShape.HalfSpace(Vector3.UnitY, 1)), RigidPose.Identity, new Vector3(0, 3, 0),
            -Vector3.UnitY, new ConcaveScratch());
        Assert.Equal((CastStatus.Hit, 2f), (hit.Status, hit.Result.Distance));
    }

    [Theory]
    [InlineData(BroadPhaseKind.DynamicTree)]
    [InlineData(BroadPhaseKind.SortAndSweep)]
    public void ASceneAsksEachObject(BroadPhaseKind kind)
    {
        var rng = new Rng(7);
        CollisionScene scene = Make(kind, rng, out List<(AnyShape Shape, RigidPose Pose)> objects);
        for (int frame = 0; frame < 4; frame++)
        {
            CheckPairs(scene, objects);
            CheckQueries(scene, objects, rng);
            int moved = 2 + rng.Below(objects.Count - 2);
            objects[moved] = (objects[moved].Shape, new RigidPose(rng.Rotation(), rng.Vector(-5, 5)));
            scene.Move(moved, objects[moved].Pose);
            objects[0] = (objects[0].Shape, new RigidPose(rng.Rotation(), Vector3.Zero));
            scene.Move(0, objects[0].Pose);
        }

        scene.Remove(0);
        var overlaps = new List<ObjectPair>();
        scene.FindOverlaps(overlaps);
        Assert.DoesNotContain(overlaps, p => p.A == 0);
        Assert.Contains(overlaps, p => p.A == 1);
        Assert.Equal(objects.Count - 1, scene.Count);
    }

    [Fact]
    public void ABoxRestsOnASceneOfAFloorAndATile()
    {
        var scene = new CollisionScene();
        var still = new ObjectSettings(isStatic: true);
        scene.Add(ConvexShape.HalfSpace(Vector3.UnitY, 0), RigidPose.Identity, still);
        scene.Add(ConvexShape.Box(new Vector3(1)), new RigidPose(new Vector3(2, -1, 0)), still);
        scene.Add(ConvexShape.Box(new Vector3(1)), new RigidPose(new Vector3(1, 0.99f, 0)));
        var contacts = new List<PairContacts>();
        scene.FindContacts(0.01f, contacts);
        PairContacts onFloor = contacts.Single(c => c.Pair == new ObjectPair(0, 2));
        Assert.Equal((4, Vector3.UnitY), (onFloor.Manifold.Count, onFloor.Manifold.Normal));
        var box = new ShapeBounds(ConvexShape.HalfSpace(Vector3.UnitY, 0)).BoxAt(new RigidPose(Vector3.One));
        Assert.Equal((new Vector3(-float.MaxValue), new Vector3(float.MaxValue)), (box.Min, box.Max));
    }

    [Fact]
    public void BatchesSayTheSame()
    {
        var rng = new Rng(3);
        string[] kinds = [.. Generators.AllKinds, .. Generators.LaterKinds];
        ConvexShape[] shapes =
            [Floor, Wall, .. Enumerable.Range(0, 62).Select(i => Generators.Shape(rng, kinds[i % kinds.Length]).Shape)];
        RigidPose[] poses = [.. shapes.Select(_ => new RigidPose(rng.Rotation(), rng.Vector(-4, 4)))];
        ObjectPair[] pairs = [.. Enumerable.Range(0, 500).Select(i => new ObjectPair(i % 2, 2 + rng.Below(62)))];
        for (int i = 0; i < pairs.Length; i += 3) pairs[i] = new ObjectPair(pairs[i].B, pairs[i].A);
        var distances = new DistanceResult[pairs.Length];
        var signed = new DistanceResult[pairs.Length];
        var overlaps = new GjkStatus[pairs.Length];
        var warm = new WarmStart[pairs.Length];
        PairBatch.SignedDistance(shapes, poses, pairs, signed);
        PairBatch.Overlaps(shapes, poses, pairs, overlaps);
        foreach (bool isWarm in new[] { false, true })
        {
            if (isWarm) PairBatch.Distance(shapes, poses, pairs, distances, warm);
            else PairBatch.Distance(shapes, poses, pairs, distances);
            for (int i = 0; i < pairs.Length; i++)
            {
                (int a, int b) = (pairs[i].A, pairs[i].B);
                DistanceResult own = ConvexQuery.Distance(shapes[a], poses[a], shapes[b], poses[b]);
                Assert.True(ResultBits.AreSame(own, distances[i]), $"{i}: {distances[i]} for {own}");
                Assert.Equal(own.Status, overlaps[i]);
                Assert.True(ResultBits.AreSame(
                    ConvexQuery.SignedDistance(shapes[a], poses[a], shapes[b], poses[b]), signed[i]));
            }
        }
    }

    [Fact]
    public void NothingIsAllocated()
    {
        var rng = new Rng(5);
        HalfSpaceSetup[] setups =
            [.. Generators.AllKinds.Select(kind => HalfSpaceSetup.Random(rng, kind, far: 1000))];
        Action[] verbs =
        [
            .. setups.SelectMany(s => EveryVerb.Of(s.Plane, s.Pose, s.Other.Shape, s.OtherPose)),
            .. setups.SelectMany(s => EveryVerb.Of(s.Other.Shape, s.OtherPose, s.Plane, s.Pose)),
        ];
        for (int i = 0; i < 2; i++)
            foreach (Action verb in verbs) verb();
        long before = GC.GetAllocatedBytesForCurrentThread();
        foreach (Action verb in verbs) verb();
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    private static void Draw(
        ulong seed, out AnyShape shape, out RigidPose pose, out RigidPose at, out Vector3 way)
    {
        var rng = new Rng(seed);
        shape = ConcaveShapes.Any(new Rng(seed));
        pose = new RigidPose(rng.Rotation(), rng.Vector(-2, 2));
        at = new RigidPose(rng.Rotation(), rng.Vector(-1, 1));
        way = rng.Vector(-4, 4);
    }

    private static CollisionScene Make(
        BroadPhaseKind kind, Rng rng, out List<(AnyShape Shape, RigidPose Pose)> objects)
    {
        objects =
        [
            (AnyShape.Of(Floor), RigidPose.Identity), (AnyShape.Of(Wall), RigidPose.Identity),
            (AnyShape.Surface(ConcaveShapes.Torus(8, 6)), new RigidPose(new Vector3(2, 0.5f, 0))),
            (AnyShape.Solid(ConcaveShapes.Box(new Vector3(1))), new RigidPose(new Vector3(-3, 2, 0))),
            (AnyShape.Of(ConcaveShapes.Compound(new Rng(3), 4)), new RigidPose(new Vector3(0, 2, 3))),
        ];
        for (int i = 0; i < 40; i++)
        {
            ConvexShape shape = Generators.Shape(rng, Generators.AllKinds[i % Generators.AllKinds.Length]).Shape;
            objects.Add((AnyShape.Of(shape), new RigidPose(rng.Rotation(), rng.Vector(-7, 7))));
        }

        var scene = new CollisionScene(kind);
        foreach ((AnyShape shape, RigidPose pose) in objects) scene.Add(shape, pose);
        return scene;
    }

    private static void CheckPairs(CollisionScene scene, List<(AnyShape Shape, RigidPose Pose)> objects)
    {
        var scratch = new ConcaveScratch();
        var within = new List<PairDistance>();
        scene.FindPairsWithin(0.5f, within);
        var overlaps = new List<ObjectPair>();
        scene.FindOverlaps(overlaps);
        int found = 0;
        for (int a = 0; a < 2; a++)
        {
            for (int b = 2; b < objects.Count; b++)
            {
                PairDistance own = ConcaveQuery.Distance(
                    objects[a].Shape, objects[a].Pose, objects[b].Shape, objects[b].Pose, scratch, 0.5f);
                PairDistance[] there = [.. within.Where(p => p.Pair == new ObjectPair(a, b))];
                bool isWithin = own.Status != GjkStatus.BeyondMaxDistance;
                Assert.True(there.Length == (isWithin ? 1 : 0), $"{a}, {b}: {own}");
                if (isWithin) Assert.Equal(own.Distance, there[0].Distance);
                Assert.Equal(own.IsOverlapping, overlaps.Contains(new ObjectPair(a, b)));
                found += isWithin ? 1 : 0;
            }
        }

        Assert.InRange(found, 10, 80);
        Assert.DoesNotContain(within, p => p.Pair == new ObjectPair(0, 1));
        var contacts = new List<PairContacts>();
        scene.FindContacts(0.5f, contacts);
        foreach (PairDistance pair in within.Where(p => p.Pair.A < 2))
            Assert.Contains(contacts, c => c.Pair == pair.Pair);
    }

    private static void CheckQueries(CollisionScene scene, List<(AnyShape Shape, RigidPose Pose)> objects, Rng rng)
    {
        (AnyShape floor, RigidPose at) = objects[0];
        for (int i = 0; i < 20; i++)
        {
            ConvexShape ball = ConvexShape.Sphere(0.3f);
            RigidPose pose = new(rng.Vector(-9, 9));
            Vector3 way = rng.Vector(-9, 9);
            CastResult own = ConvexQuery.Cast(ball, pose, way, floor.Convex, at, default);
            bool isHit = scene.TryFindCastHit(ball, pose, way, out CastHit hit);
            if (own.IsHit) Assert.True(isHit && hit.Result.Fraction <= own.Fraction);
            if (isHit && hit.Id == 0) Assert.Equal(own.Fraction, hit.Result.Fraction);
            RayCastResult ray = ConvexQuery.RayCast(floor.Convex, at, pose.Position, way, 20);
            bool isMet = scene.TryFindRayHit(new RayQuery(pose.Position, way, 20), out RayHit met);
            if (ray.IsHit) Assert.True(isMet && met.Result.Distance <= ray.Distance);
            var rays = new List<RayHit>();
            scene.FindRayHits(new RayQuery(pose.Position, way, 20), rays);
            Assert.Equal(ray.IsHit, rays.Exists(r => r.Id == 0));
            Assert.True(scene.TryFindNearest(ball, pose, out PairDistance nearest));
            DistanceResult apart = ConvexQuery.Distance(ball, pose, floor.Convex, at);
            Assert.True(nearest.Distance <= apart.Distance);
            var ids = new List<int>();
            scene.FindObjectsOverlapping(ball, pose, ids);
            Assert.Equal(apart.IsOverlapping, ids.Contains(0));
        }

        var below = new List<int>();
        scene.FindObjectsOverlapping(floor.Convex, at, below);
        var pairs = new List<ObjectPair>();
        scene.FindOverlaps(pairs);
        Assert.Equal(pairs.Where(p => p.A == 0).Select(p => p.B), below.Where(id => id > 1));
    }

    private static ConvexShape[] Parts(AnyShape shape) => shape.Kind switch
    {
        AnyShapeKind.Convex => [shape.Convex],
        AnyShapeKind.Compound => [.. Enumerable.Range(0, shape.PartCount).Select(shape.Compound!.GetPart)],
        _ => [.. Enumerable.Range(0, shape.PartCount).Select(i => TriangleOf(shape.Mesh!, i))],
    };

    private static ConvexShape TriangleOf(TriangleMesh mesh, int i)
    {
        mesh.GetTriangle(i, out int a, out int b, out int c);
        return ConvexShape.Triangle(mesh.GetVertex(a), mesh.GetVertex(b), mesh.GetVertex(c)).Scaled(mesh.Scale);
    }
}
