using static Gjk.Core.Tests.Support.Resting;

namespace Gjk.Core.Tests.Contacts;

/// <summary>Logs, cans and pipes side by side: two points, and a normal across both axes.</summary>
public class ParallelContactTests
{
    [Theory]
    [InlineData(-0.1)]
    [InlineData(-1e-3)]
    [InlineData(-1e-7)]
    [InlineData(0)]
    [InlineData(1e-7)]
    [InlineData(1e-3)]
    public void ParallelSidesTouchInTwoPoints(double gap)
    {
        var rng = new Rng(5);
        for (int i = 0; i < 250; i++)
        {
            float radius = rng.Float(0.1, 1), otherRadius = rng.Float(0.1, 1), half = rng.Float(0.5, 2);
            ConvexShape a = ConvexShape.Cylinder(radius, half), b = i % 3 == 0
                ? ConvexShape.Capsule(otherRadius, rng.Float(0.5, 2))
                : ConvexShape.Cylinder(otherRadius, rng.Float(0.5, 2));
            if (i % 7 == 0) a = ConvexShape.Cylinder(radius / 2, half).Scaled(new Vector3(-2, 1, 2));
            Quaternion turn = Quaternion.Normalize(rng.Rotation());
            var yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, i % 2 * rng.Float(0, 6));
            Quaternion other = turn * yaw;
            float angle = rng.Float(0, 6.28);
            double apart = radius + otherRadius + gap * Math.Min(radius, otherRadius);
            var across = Vector3.Transform(new Vector3(MathF.Cos(angle), 0, MathF.Sin(angle)), turn);
            Vector3 along = Vector3.Transform(new Vector3(0, rng.Float(-0.5, 0.5), 0), turn);
            var pose = new RigidPose(turn, default);
            foreach (bool isSwapped in new[] { false, true })
            {
                var otherPose = new RigidPose(other, across * (float)apart + along);
                ContactManifold m = isSwapped ? Ask(b, otherPose, a, pose).Swapped : Ask(a, pose, b, otherPose);
                string text = $"{i}: {new QueryRecord(a, pose, b, otherPose)}";
                Assert.True(m.Count == 2, $"{m.Count} points of {text}");
                Assert.True((m.Normal - across).Length() <= 1e-6f, $"{(m.Normal - across).Length()} off in {text}");
                Assert.All(Points(m), p => Assert.Equal(gap * Math.Min(radius, otherRadius), p.Gap, 2e-6));
            }
        }
    }

    /// <summary>Bodies too small, or too large, for doubles have the same normal.</summary>
    [Theory]
    [InlineData(1e-25f)]
    [InlineData(1e25f)]
    public void AnySizeWillDo(float size)
    {
        ConvexShape log = ConvexShape.Cylinder(0.25f * size, size);
        var across = new Vector3(0.6f, 0, 0.8f);
        ContactManifold m = Ask(
            log, RigidPose.Identity, log, new RigidPose(across * (0.49f * size)), 0.01f * size);
        Assert.Equal(2, m.Count);
        Assert.Equal(0, (m.Normal - across).Length(), 1e-6f);
    }

    /// <summary>Logs that cross at a small angle rest on both ends; where they cross may be deeper still.</summary>
    [Theory]
    [InlineData(1e-6f)]
    [InlineData(1e-4f)]
    [InlineData(1e-2f)]
    public void NearlyParallelLogsRestOnBothEnds(float angle)
    {
        var rng = new Rng(6);
        for (int i = 0; i < 100; i++)
        {
            ConvexShape a = ConvexShape.Cylinder(0.5f, 1), b = ConvexShape.Cylinder(0.4f, 0.9f);
            var axis = Vector3.Normalize(new Vector3(rng.Float(-1, 1), 0, rng.Float(-1, 1)));
            var pose = new RigidPose(
                Quaternion.CreateFromAxisAngle(axis, angle), new Vector3(0.895f, rng.Float(-0.3, 0.3), 0));
            ContactManifold m = Ask(a, RigidPose.Identity, b, pose);
            Assert.InRange(m.Count, 2, angle > 1e-3f ? 3 : 2);
            Assert.InRange(Points(m).Max(p => p.PointA.Y) - Points(m).Min(p => p.PointA.Y), 1.4f, 2);
            Assert.Equal(m.Count, Points(m).Select(p => p.FeatureId).Distinct().Count());
        }
    }
}
