namespace Gjk.Core.Tests.Regression;

/// <summary>Curved shapes in exact contact touched in a cold query and were apart in the warm one that followed, so a
/// resting pair lost its contact in the second frame.</summary>
public class RestingContactTests
{
    private static readonly ConvexShape[] Shapes =
    [
        ConvexShape.Cylinder(1, 1), ConvexShape.Cone(1, 1), ConvexShape.Ellipsoid(new Vector3(1, 2, 1)),
        ConvexShape.Sphere(1), ConvexShape.Capsule(1, 1),
        ConvexShape.Box(new Vector3(1, 1, 0)), ConvexShape.Box(new Vector3(1, 1, 1)),
        ConvexShape.Box(new Vector3(0.5f, 1, 2)), ConvexShape.Capsule(1, 1).Scaled(new Vector3(1, 1, 2)),
    ];

    [Fact]
    public void TheReportedPairTouchesInEveryFrame()
    {
        WarmStart warm = default;
        var pose = new RigidPose(new Vector3(-1, 1, -1));
        for (int frame = 0; frame < 4; frame++)
            Assert.Equal(
                GjkStatus.Overlapping,
                ConvexQuery.Distance(Shapes[0], RigidPose.Identity, Shapes[5], pose, ref warm, 0).Status);
        Assert.True(ConvexQuery.Overlaps(Shapes[0], RigidPose.Identity, Shapes[5], pose));
    }

    /// <summary>On a lattice many pairs touch exactly; cold, warm and boolean queries agree about every one.</summary>
    [Fact]
    public void OnALatticeColdWarmAndBooleanAgree()
    {
        int touching = 0, checkedPairs = 0;
        foreach ((ConvexShape a, ConvexShape b, RigidPose pose) in LatticePairs(Budget.Count(6000)))
        {
            WarmStart warm = default;
            DistanceResult cold = ConvexQuery.Distance(a, RigidPose.Identity, b, pose);
            bool overlaps = ConvexQuery.Overlaps(a, RigidPose.Identity, b, pose);
            string pair = new QueryRecord(a, RigidPose.Identity, b, pose).ToString();
            Assert.True(
                overlaps == cold.IsOverlapping,
                $"Overlaps {overlaps}, Distance {cold.Status} {cold.Distance:R}: {pair}");
            for (int frame = 0; frame < 3; frame++)
            {
                DistanceResult r = ConvexQuery.Distance(a, RigidPose.Identity, b, pose, ref warm, 0);
                Assert.True(
                    r.IsOverlapping == cold.IsOverlapping,
                    $"frame {frame}: {r.Status}, cold {cold.Status} {cold.Distance:R}: {pair}");
            }

            checkedPairs++;
            touching += cold.IsOverlapping ? 1 : 0;
        }

        Assert.InRange(touching, 0.1 * checkedPairs, 0.9 * checkedPairs);
    }

    /// <summary>A pair that is exactly as far apart as asked stays within reach from frame to frame.</summary>
    [Fact]
    public void APairAtExactlyTheLargestDistanceStays()
    {
        int atTheLimit = 0;
        foreach ((ConvexShape a, ConvexShape b, RigidPose pose) in LatticePairs(Budget.Count(3000)))
        {
            DistanceResult cold = ConvexQuery.Distance(a, RigidPose.Identity, b, pose);
            if (!(cold.Distance > 0) || cold.Distance != (int)cold.Distance) continue;
            WarmStart warm = default;
            for (int frame = 0; frame < 3; frame++)
            {
                DistanceResult r = ConvexQuery.Distance(a, RigidPose.Identity, b, pose, ref warm, cold.Distance);
                Assert.True(
                    r.Status == GjkStatus.Separated,
                    $"frame {frame}: {r.Status} at {cold.Distance:R}: "
                    + $"{new QueryRecord(a, RigidPose.Identity, b, pose)}");
            }

            atTheLimit++;
        }

        Assert.True(atTheLimit > 100, $"only {atTheLimit} pairs");
    }

    private static IEnumerable<(ConvexShape A, ConvexShape B, RigidPose Pose)> LatticePairs(int count)
    {
        var rng = new Rng(5);
        for (int i = 0; i < count; i++)
        {
            var position = new Vector3(rng.Below(9) - 4, rng.Below(9) - 4, rng.Below(9) - 4) * 0.5f;
            yield return (
                Shapes[rng.Below(Shapes.Length)], Shapes[rng.Below(Shapes.Length)],
                new RigidPose(QuarterTurn(rng), position * (1 + rng.Below(2))));
        }
    }

    private static Quaternion QuarterTurn(Rng rng) => rng.Below(4) switch
    {
        0 => Quaternion.Identity,
        1 => new Quaternion(1, 0, 0, 0),
        2 => new Quaternion(0, 0.70710678f, 0, 0.70710678f),
        _ => new Quaternion(0.70710678f, 0, 0, 0.70710678f),
    };
}
