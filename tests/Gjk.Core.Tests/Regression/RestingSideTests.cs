using static Gjk.Core.Tests.Support.Resting;

namespace Gjk.Core.Tests.Regression;

/// <summary>An edge beside the side of a cylinder or a cone: the normal was open by 1e-5, so the line of the side lay
/// now in the box's face, now beside it, and a pair at rest had 3, 1 or 2 points in turn, as its warm start had it.
/// Found by an attack.</summary>
public class RestingSideTests
{
    [Theory]
    [InlineData(false, 0f, 0.003f)]
    [InlineData(false, 0f, -0.01f)]
    [InlineData(false, 0.1f, 0.003f)]
    [InlineData(false, 0f, 0.15f)]
    [InlineData(true, 0f, 0.003f)]
    [InlineData(true, 0f, -0.01f)]
    [InlineData(true, 0.1f, -0.003f)]
    public void AnEdgeBesideARoundSideHasTheSameTwoPointsInEveryFrame(bool isCone, float margin, float gap)
    {
        var rng = new Rng(11);
        ConvexShape side = (isCone ? ConvexShape.Cone(1, 1) : ConvexShape.Cylinder(1, 1)).Rounded(margin);
        ConvexShape box = ConvexShape.Box(new Vector3(0.5f));
        for (int i = 0; i < 100; i++)
        {
            float lean = isCone ? MathF.Atan2(1, 2) : 0;
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, lean)
                * Quaternion.CreateFromAxisAngle(Vector3.UnitY, MathF.PI / 4 + rng.Float(-0.6, 0.6));
            Vector3 normal = new(MathF.Cos(lean), MathF.Sin(lean), 0), middle = new(isCone ? 0.5f : 1, 0, 0);
            var corner = Vector3.Transform(new Vector3(-0.5f, rng.Float(-0.2, 0.2), -0.5f), turn);
            var local = new RigidPose(turn, middle + normal * (gap + margin) - corner);
            RigidPose pose = new(Quaternion.Normalize(rng.Rotation()), rng.Vector(-2, 2));
            RigidPose boxPose = new(Quaternion.Normalize(pose.Rotation * local.Rotation),
                pose.TransformPoint(local.Position));
            ContactManifold first = Ask(side, pose, box, boxPose, 0.3f);
            ContactManifold exchanged = Ask(box, boxPose, side, pose, 0.3f).Swapped;
            string text = $"{i}: {new QueryRecord(side, pose, box, boxPose)}";
            Assert.True(first.Count == 2, $"{first.Count} points of {text}");
            AssertSame(first, exchanged, text);
            WarmStart warm = default;
            for (int frame = 0; frame < 8; frame++)
            {
                var m = default(ContactManifold);
                ConvexQuery.Contacts(side, pose, box, boxPose, ref warm, 0.3f, out m);
                AssertSame(first, m, $"frame {frame} of {text}");
            }
        }
    }

    /// <summary>The pair of the attack.</summary>
    [Fact]
    public void ABoxBesideACylinder()
    {
        ConvexShape a = ConvexShape.Cylinder(1, 1), b = ConvexShape.Box(new Vector3(0.5f));
        var pose = new RigidPose(
            Quaternion.CreateFromAxisAngle(Vector3.UnitY, 0.8f), new Vector3(1.71f, 0.3f, 0));
        WarmStart warm = default;
        for (int frame = 0; frame < 8; frame++)
        {
            var m = default(ContactManifold);
            ConvexQuery.Contacts(a, RigidPose.Identity, b, pose, ref warm, 0.05f, out m);
            Assert.Equal(2, m.Count);
            Assert.Equal(-0.2f, Points(m).Min(p => p.PointA.Y), 1e-6f);
            Assert.Equal(0.8f, Points(m).Max(p => p.PointA.Y), 1e-6f);
        }
    }

    /// <summary>A log on a rounded cone was taken for one on a cylinder of the margin's radius, and its points were
    /// 0.02 inside the cone.</summary>
    [Theory]
    [InlineData(0.002f)]
    [InlineData(0.05f)]
    [InlineData(0.2f)]
    [InlineData(0.4f)]
    public void PointsOfLogsAcrossAConeLieOnItsSide(float angle)
    {
        var rng = new Rng(12);
        var normal = Vector3.Normalize(new Vector3(2, 1, 0));
        Quaternion along = Quaternion.CreateFromAxisAngle(normal, angle)
            * Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.Atan2(1, 2));
        for (int i = 0; i < 100; i++)
        {
            float radius = rng.Float(0.1, 0.4), margin = i % 4 == 0 ? 0 : rng.Float(0.01, 0.3);
            ConvexShape cone = ConvexShape.Cone(1, 1).Rounded(margin);
            if (i % 5 == 0) cone = ConvexShape.Cone(0.5f, 2).Scaled(new Vector3(2, 0.5f, -2)).Rounded(margin);
            ConvexShape log = i % 3 == 0 ? ConvexShape.Cylinder(radius, 1) : ConvexShape.Capsule(radius, 1);
            var pose = new RigidPose(
                along, new Vector3(0.5f, 0, 0) + normal * (radius + margin + rng.Float(-0.02, 0.02)));
            ContactManifold m = Ask(cone, RigidPose.Identity, log, pose, 0.5f);
            Assert.InRange(m.Count, 2, 3);
            foreach (ManifoldPoint p in Points(m))
            {
                float onA = ConvexQuery.SignedDistance(cone, RigidPose.Identity, p.LocalPointA).Distance;
                float onB = ConvexQuery.SignedDistance(log, RigidPose.Identity, p.LocalPointB).Distance;
                Assert.True(
                    MathF.Abs(onA) <= 4e-6f && MathF.Abs(onB) <= 4e-6f,
                    $"{onA} and {onB} off: {new QueryRecord(cone, RigidPose.Identity, log, pose)}");
            }
        }
    }

    private static void AssertSame(ContactManifold expected, ContactManifold m, string text)
    {
        Assert.True(m.Count == expected.Count, $"{m.Count} points, {expected.Count} before: {text}");
        for (int i = 0; i < m.Count; i++)
        {
            Assert.True(Points(expected).Any(p => p.FeatureId == m[i].FeatureId), $"other names: {text}");
            ManifoldPoint same = Points(expected).First(p => p.FeatureId == m[i].FeatureId);
            float moved = (same.PointA - m[i].PointA).Length();
            Assert.True(moved <= 1e-5f, $"moved by {moved}: {text}");
        }
    }
}
