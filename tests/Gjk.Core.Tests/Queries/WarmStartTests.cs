using System.Runtime.InteropServices;

namespace Gjk.Core.Tests.Queries;

/// <summary>What a warm start holds only suggests where to begin: whatever it is, the answer is the cold one within the
/// accuracy.</summary>
public class WarmStartTests
{
    [Fact]
    public void AMovingPairIsAnsweredAsIfAskedForTheFirstTime() => Each(92_000, (pair, rng) =>
    {
        var warm = default(WarmStart);
        Vector3 velocity = rng.UnitVector() * (float)(0.05 * pair.Scale);
        var turn = Quaternion.CreateFromAxisAngle(rng.UnitVector(), rng.Float(0, 0.2));
        RigidPose poseA = pair.PoseA;
        for (int frame = 0; frame < 12; frame++)
        {
            poseA = new RigidPose(Quaternion.Normalize(turn * poseA.Rotation), poseA.Position + velocity);
            TestPair moved = pair with { PoseA = poseA };
            string? problem = Compare(moved, ref warm);
            if (problem is not null) return $"frame {frame}: {problem} of {moved}";
        }

        return null;
    });

    [Fact]
    public void AnyBytesAreOnlyAWrongGuess() => Each(93_000, (pair, rng) =>
    {
        for (int k = 0; k < 20; k++)
        {
            WarmStart warm = Garbage(rng);
            string? problem = Compare(pair, ref warm);
            if (problem is not null) return $"guess {k}: {problem}";
        }

        return null;
    });

    /// <summary>A signed distance keeps where it ended, too: of hulls that stay it takes fewer rounds.</summary>
    [Fact]
    public void ASignedDistanceBeginsWhereItEnded()
    {
        ConvexShape hull = ConvexShape.Mesh(Clouds.InBox(new Rng(1), 200, Vector3.One)).Rounded(0.1f);
        var pose = new RigidPose(new(0.1f, 0.7f, -0.3f, 0.6403124f), new Vector3(1.5f, -2.1f, 1.3f));
        WarmStart warm = default;
        DistanceResult first = ConvexQuery.SignedDistance(hull, RigidPose.Identity, hull, pose, ref warm);
        DistanceResult next = ConvexQuery.SignedDistance(hull, RigidPose.Identity, hull, pose, ref warm);
        Assert.Equal((GjkStatus.Separated, first.Distance), (first.Status, next.Distance));
        Assert.True(next.Iterations < first.Iterations, $"{next.Iterations} after {first.Iterations}");
    }

    /// <summary>A plane beyond the asked distance can end the query before it has one vertex to remember.</summary>
    [Fact]
    public void AQueryThatEndedAtItsFirstPlaneLeavesAGoodWarmStart() => Each(94_000, (pair, rng) =>
    {
        var warm = default(WarmStart);
        for (int k = 0; k < 4; k++)
        {
            var far = (float)Math.Max(pair.Scale, 1e-3);
            Vector3 away = pair.PoseB.Position + rng.UnitVector() * 50 * far;
            TestPair apart = pair with { PoseB = new RigidPose(pair.PoseB.Rotation, away) };
            DistanceResult r = ConvexQuery.Distance(
                apart.A.Shape, apart.PoseA, apart.B.Shape, apart.PoseB, ref warm, far);
            if (r.Status != GjkStatus.BeyondMaxDistance) return $"status {r.Status}, lower bound {r.LowerBound}";
            string? problem = Compare(pair, ref warm);
            if (problem is not null) return $"after query {k}: {problem}";
            if (rng.Below(2) == 0) warm.Clear();
        }

        return null;
    });

    /// <summary>Large balls beside small round shapes: what the search may leave of the way between the cores is less
    /// than what counts as touching, however long their margins make that way.</summary>
    [Fact]
    public void ABallThatTouchesExactlyTouchesFromAnyStart()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(2000); seed++)
        {
            var rng = new Rng(94_000 + seed);
            float r = PowerOfTwo(-3, 3), wide = PowerOfTwo(-2, 2), high = PowerOfTwo(-2, 2);
            TestShape round = seed % 2 == 0
                ? TestShape.Ellipsoid(new Vector3(wide, high, PowerOfTwo(-2, 2)))
                : TestShape.Cylinder(wide, high);
            float along = seed % 2 == 0 ? 0 : rng.Float(-high, high);
            var pair = new TestPair(
                $"seed {seed}", round, RigidPose.Identity, TestShape.Sphere(r),
                new RigidPose(new Vector3(wide + r, along, 0)));
            var warm = default(WarmStart);
            var beside = new RigidPose(pair.PoseB.Position + (rng.UnitVector() * rng.Float(0, 1e-2)));
            ConvexQuery.Distance(pair.A.Shape, pair.PoseA, pair.B.Shape, beside, ref warm);
            DistanceResult again = ConvexQuery.Distance(
                pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, ref warm);
            Assert.True(pair.Distance().IsOverlapping && again.IsOverlapping, $"{again}: {pair}");

            float PowerOfTwo(int least, int most) => MathF.Pow(2, least + rng.Below(most - least + 1));
        }
    }

    private static string? Compare(TestPair pair, ref WarmStart warm)
    {
        DistanceResult cold = pair.Distance();
        DistanceResult r = ConvexQuery.Distance(pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, ref warm);
        if (r.Status == cold.Status && Math.Abs((double)r.Distance - cold.Distance) <= 2 * pair.Band(cold.Distance))
            return null;
        return Math.Max(r.Distance, cold.Distance) <= Accuracy.FlagScale * pair.Scale
            ? null
            : $"{r.Status} {r.Distance:R}, cold {cold.Status} {cold.Distance:R}";
    }

    /// <summary>Half of them plausible: small numbers, which are vertices of most shapes.</summary>
    private static WarmStart Garbage(Rng rng)
    {
        Span<int> words = stackalloc int[12];
        bool plausible = rng.Below(2) == 0;
        for (int i = 0; i < words.Length; i++) words[i] = plausible ? rng.Below(5) : (int)rng.Next();
        if (rng.Below(2) == 0) words[0] = 1 + rng.Below(4);
        return MemoryMarshal.Cast<int, WarmStart>(words)[0];
    }

    private static void Each(ulong seed, Func<TestPair, Rng, string?> examine)
    {
        for (ulong i = 0; i < (ulong)Budget.Count(300); i++)
        {
            TestPair pair = i % 3 == 0
                ? Generators.NearPair(seed + i, Generators.AllKinds, 1e-3)
                : Generators.Pair(seed + i, Generators.AllKinds);
            string? problem = examine(pair, new Rng(seed ^ i));
            Assert.True(problem is null, $"{problem}\n{pair}");
        }
    }
}
