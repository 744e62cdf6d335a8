using System.Runtime.InteropServices;

namespace Gjk.Core.Tests.Wide;

/// <summary>A batch solves four pairs at once where it can; every field has the bits of the query alone. The builds for
/// netstandard ask pair by pair and leave these tests out: the golden hash of batches holds them to the same
/// bits.</summary>
public class WideBatchTests
{
    /// <summary>Pairs per batch: whole parts, and one that is not filled.</summary>
    private const int BatchLength = 1000;

    private const int Batches = 1000, ShapesPerKind = 12;

    public static TheoryData<string> Families => [.. CaseFamily.Names];

    [Theory]
    [MemberData(nameof(Families))]
    public void TheHardCasesHaveTheBitsOfTheQuery(string family)
    {
        TestPair[] cases = [.. CaseFamily.Load(family).Cases.Select(c => c.Pair)];
        ConvexShape[] shapes = [.. cases.SelectMany(p => new[] { p.A.Shape, p.B.Shape })];
        RigidPose[] poses = [.. cases.SelectMany(p => new[] { p.PoseA, p.PoseB })];
        ObjectPair[] pairs = [.. cases.Select((_, i) => new ObjectPair(2 * i, 2 * i + 1))];
        ObjectPair[] swapped = [.. pairs.Select(p => new ObjectPair(p.B, p.A))];
        foreach (ObjectPair[] some in new[] { pairs, swapped })
        {
            Check(shapes, poses, some, float.PositiveInfinity, family);
            Check(shapes, poses, some, 0, family);
            Check(shapes, poses, some, 1e-3f, family);
            CheckWarm(shapes, poses, some, float.PositiveInfinity, family);
            CheckWarm(shapes, poses, some, 1e-3f, family);
        }
    }

    /// <summary>Pairs of mixed kinds and sizes, some of them square to each other and flush.</summary>
    [Fact]
    public void RandomPairsOfMixedKindsHaveTheBitsOfTheQuery()
    {
        var rng = new Rng(1);
        string[] kinds = [.. Generators.AllKinds, "bigHull", .. Generators.MadeKinds];
        var shapes = new List<ConvexShape>();
        foreach (string kind in kinds)
            for (int i = 0; i < ShapesPerKind; i++) shapes.Add(Generators.Shape(rng, kind).Shape);
        foreach (ConvexShape shape in shapes.ToArray()) shapes.Add(shape.Rounded(rng.Float(0.01, 0.3)));
        for (int seed = 0; seed < Budget.Few(Batches); seed++)
            CheckRandom(shapes, (ulong)seed, seed % 4, seed % 5 == 0);
    }

    [Fact]
    public void BoxesOfAnySizeAndPlaceHaveTheBitsOfTheQuery()
    {
        for (int seed = 0; seed < Budget.Few(200); seed++)
        {
            var rng = new Rng((ulong)seed);
            float size = (float)Math.Pow(10, rng.Range(-25, 25));
            ConvexShape[] shapes = [.. Enumerable.Range(0, 64).Select(_ => ConvexShape.Box(rng.Vector(0, 1) * size))];
            RigidPose[] poses = [.. shapes.Select(_ => Generators.Pose(rng, rng.Vector(-1.5, 1.5) * size))];
            if (seed % 3 == 0) poses = [.. poses.Select(p => new RigidPose(Snapped(p.Position, size)))];
            poses[seed % 64] = default;
            shapes[seed * 7 % 64] = default;
            Check(shapes, poses, Pairs(rng, 64, 300), float.PositiveInfinity, $"seed {seed}");
        }
    }

    /// <summary>The points are placed from the smaller shape where the sizes differ greatly.</summary>
    [Fact]
    public void ShapesOfVeryDifferentSizesHaveTheBitsOfTheQuery()
    {
        string[] kinds = ["box", "hull", "bigHull", "segment", "capsule", "point", "sphere", "scaledBox"];
        for (int seed = 0; seed < Budget.Few(100); seed++)
        {
            var rng = new Rng((ulong)seed);
            TestShape[] made =
            [
                .. Enumerable.Range(0, 64).Select(_ =>
                    Generators.Shape(rng, kinds[rng.Below(kinds.Length)]).Scaled(new Vector3(rng.LogFloat(1e-5, 1e5)))),
            ];
            RigidPose[] poses = [.. made.Select(s => Generators.Pose(rng, rng.UnitVector() * rng.LogFloat(1e-5, 1e7)))];
            ConvexShape[] shapes = [.. made.Select(s => s.Shape)];
            Check(shapes, poses, Pairs(rng, 64, 300), float.PositiveInfinity, $"seed {seed}");
            CheckWarm(shapes, poses, Pairs(rng, 64, 300), float.PositiveInfinity, $"seed {seed}");
        }
    }

    private static void CheckRandom(List<ConvexShape> all, ulong seed, int kind, bool isWarm)
    {
        var rng = new Rng(seed);
        const int count = 100;
        var shapes = new ConvexShape[count];
        var poses = new RigidPose[count];
        Vector3 away = kind == 3 ? rng.Vector(-1e4, 1e4) : default;
        for (int i = 0; i < count; i++)
        {
            shapes[i] = all[rng.Below(all.Count)];
            poses[i] = Generators.Pose(rng, rng.Vector(-1.2, 1.2) + away);
            if (kind == 2) poses[i] = new RigidPose(Snapped(poses[i].Position, 1));
        }

        float most = kind == 1 ? rng.Float(0, 0.5) : float.PositiveInfinity;
        ObjectPair[] pairs = Pairs(rng, count, BatchLength);
        Check(shapes, poses, pairs, most, $"seed {seed}");
        if (isWarm) CheckWarm(shapes, poses, pairs, most, $"seed {seed}");
    }

    private static Vector3 Snapped(Vector3 v, float size) =>
        new Vector3(MathF.Round(v.X / size * 4), MathF.Round(v.Y / size * 4), MathF.Round(v.Z / size * 4))
            * (0.25f * size);

    private static ObjectPair[] Pairs(Rng rng, int objects, int count) =>
        [.. Enumerable.Range(0, count).Select(_ => new ObjectPair(rng.Below(objects), rng.Below(objects)))];

    private static void Check(
        ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, float maxDistance, string name)
    {
        var results = new DistanceResult[pairs.Length];
        var statuses = new GjkStatus[pairs.Length];
        PairBatch.Distance(shapes, poses, pairs, results, maxDistance);
        PairBatch.Overlaps(shapes, poses, pairs, statuses);
        for (int i = 0; i < pairs.Length; i++)
        {
            (int a, int b) = (pairs[i].A, pairs[i].B);
            ConvexQuery.Overlaps(shapes[a], poses[a], shapes[b], poses[b], out GjkStatus status);
            Assert.True(status == statuses[i], $"{name}, pair {i}: alone {status}, in the batch {statuses[i]}");
            DistanceResult alone = ConvexQuery.Distance(shapes[a], poses[a], shapes[b], poses[b], maxDistance);
            if (ResultBits.AreSame(alone, results[i])) continue;
            string record = new QueryRecord(shapes[a], poses[a], shapes[b], poses[b]).ToString();
            Assert.Fail($"{name}, up to {maxDistance}: alone {alone}, in the batch {results[i]}: {record}");
        }
    }

    /// <summary>Frames that rest, creep, jump and rest again: each answer and each warm start is that of the query
    /// alone.</summary>
    private static void CheckWarm(
        ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, float maxDistance, string name)
    {
        var results = new DistanceResult[pairs.Length];
        var starts = new WarmStart[pairs.Length];
        var alone = new WarmStart[pairs.Length];
        var rng = new Rng(7);
        foreach (double step in new[] { 0, 0, 1e-6, 1e-3, 0.05, 1, 0 })
        {
            RigidPose[] moved = [.. poses.Select(p => Moved(rng, p, step))];
            PairBatch.Distance(shapes, moved, pairs, results, starts, maxDistance);
            for (int i = 0; i < pairs.Length; i++)
            {
                (int a, int b) = (pairs[i].A, pairs[i].B);
                DistanceResult expected = ConvexQuery.Distance(
                    shapes[a], moved[a], shapes[b], moved[b], ref alone[i], maxDistance);
                if (ResultBits.AreSame(expected, results[i])) continue;
                string record = new QueryRecord(shapes[a], moved[a], shapes[b], moved[b]).ToString();
                Assert.Fail($"{name}, step {step}: alone {expected}, in the batch {results[i]}: {record}");
            }

            Assert.True(
                MemoryMarshal.AsBytes(starts.AsSpan()).SequenceEqual(MemoryMarshal.AsBytes(alone.AsSpan())),
                $"{name}, step {step}: the warm starts differ");
        }
    }

    private static RigidPose Moved(Rng rng, RigidPose pose, double step)
    {
        if (step == 0 || pose.Rotation == default) return pose;
        var turn = Quaternion.CreateFromAxisAngle(Vector3.Normalize(rng.Vector(-1, 1)), (float)step);
        var rotation = Quaternion.Normalize(Quaternion.Concatenate(pose.Rotation, turn));
        return new RigidPose(rotation, pose.Position + rng.Vector(-1, 1) * (float)step);
    }
}
