using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Exact.Fuzz.Concave;

/// <summary>A scene of the two shapes, in two frames, and a batch against the queries of the pair: with the same
/// bits.</summary>
internal static class ScenesOfParts
{
    public static string? Broken(ConcavePair pair)
    {
        if (pair.RawA.IsConvex && pair.RawB.IsConvex) return null;
        Rng random = pair.Random(10);
        var scene = new CollisionScene(random.Of(Enum.GetValues<BroadPhaseKind>()));
        var before = new RigidPose(pair.PoseB.Rotation, pair.PoseB.Position - 0.01f * pair.Motion.B);
        scene.Add(pair.A, pair.PoseA);
        scene.Add(pair.B, before);
        float reach = random.OneIn(3) ? 0 : random.Float(0.5, 2) * Math.Min(pair.Answer.Distance, 1e30f);
        for (int frame = 0; frame < 3; frame++)
        {
            RigidPose poseB = frame == 0 ? before : pair.PoseB;
            if (frame == 1) scene.Move(1, poseB);
            if (Frame(pair, scene, poseB, reach) is { } how) return Say.Line($"frame {frame}, within {reach:R}: {how}");
        }

        var results = new PairDistance[1];
        PairBatch.Distance([pair.A, pair.B], [pair.PoseA, pair.PoseB], [new ObjectPair(0, 1)], results, pair.Scratch);
        return results[0].PartA == pair.Answer.PartA && results[0].PartB == pair.Answer.PartB
            ? Same.BitProblem(pair.Answer.Result, results[0].Result, "as a batch")
            : Say.Line($"as a batch {results[0]}, alone {pair.Answer}");
    }

    private static string? Frame(ConcavePair pair, CollisionScene scene, in RigidPose poseB, float reach)
    {
        PairDistance alone = ConcaveQuery.Distance(pair.A, pair.PoseA, pair.B, poseB, pair.Scratch, reach);
        var near = new List<PairDistance>();
        scene.FindPairsWithin(reach, near);
        bool isNear = alone.Status != GjkStatus.BeyondMaxDistance;
        if (near.Count != (isNear ? 1 : 0)) return Say.Line($"{near.Count} pairs near, but {alone}");
        if (isNear && near[0].Result.Distance != alone.Distance) return Say.Line($"{near[0]}, but {alone}");
        var overlaps = new List<ObjectPair>();
        scene.FindOverlaps(overlaps);
        bool isOverlap = ConcaveQuery.Overlaps(pair.A, pair.PoseA, pair.B, poseB, pair.Scratch);
        if (overlaps.Count != (isOverlap ? 1 : 0)) return Say.Line($"{overlaps.Count} overlaps, but {isOverlap}");
        List<PairContacts> parts = [];
        ConcaveQuery.FindContacts(pair.A, pair.PoseA, pair.B, poseB, reach, pair.Scratch, parts);
        List<PairContacts> contacts = [];
        scene.FindContacts(reach, contacts);
        return parts.Select(c => (c.PartA, c.PartB, c.Result.Distance, c.Manifold.Count, c.Manifold.Normal))
            .SequenceEqual(contacts.Select(
                c => (c.PartA, c.PartB, c.Result.Distance, c.Manifold.Count, c.Manifold.Normal)))
            ? null
            : Say.Line($"{contacts.Count} contacts, but of the pair alone {parts.Count}, or others");
    }
}
