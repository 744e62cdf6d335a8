namespace Gjk.Core.Tests.Contacts;

/// <summary>What holds of the contacts of any pair, and while a body moves.</summary>
public class ContactPropertyTests
{
    private static readonly string[] Kinds = [.. Generators.AllKinds, "made", "madeUneven", "bigHull"];

    /// <summary>No gap is less than the signed distance, one is it, none is more than was asked for; the points lie on
    /// both shapes and opposite each other along the normal.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1e-3f)]
    [InlineData(0.3f)]
    public void EveryPointIsOnBothShapes(float maxGap)
    {
        int several = 0, touching = 0, count = Budget.Count(3000);
        for (int i = 0; i < count; i++)
        {
            TestPair p = i % 2 == 0
                ? Generators.Pair((ulong)i, Kinds, 0.8)
                : Generators.NearPair((ulong)i, Kinds, -Math.Pow(10, -i % 7));
            ContactManifold m = default;
            DistanceResult r = ConvexQuery.Contacts(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, maxGap, out m);
            Resting.AssertIsSignedDistance(r, p.A.Shape, p.PoseA, p.B.Shape, p.PoseB);
            Assert.True(m.Count > 0 == r.Distance <= maxGap, $"{p}: {m.Count} points at {r.Distance}");
            if (m.Count == 0) continue;
            touching++;
            if (m.Count > 1) several++;
            Check(p, r, m, maxGap);
        }

        Assert.InRange(touching, count / 3, count);
        Assert.InRange(several, touching / 4, touching);
    }

    /// <summary>A body that slides and turns on another keeps the names of its points.</summary>
    [Theory]
    [InlineData("box")]
    [InlineData("prism")]
    [InlineData("cylinder")]
    [InlineData("capsule")]
    public void NamesStayWhileABodySlides(string name)
    {
        var rng = new Rng(14);
        ConvexShape shape = name switch
        {
            "box" => ConvexShape.Box(new Vector3(0.5f)),
            "prism" => ConvexShape.Mesh(Clouds.Prism(64, 1, 0.5f)),
            "cylinder" => ConvexShape.Cylinder(1, 0.5f),
            _ => ConvexShape.Capsule(0.5f, 1),
        };
        var lying = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, name == "capsule" ? MathF.PI / 2 : 0);
        long[]? names = null;
        ContactManifold m = default;
        WarmStart warm = default;
        for (int i = 0; i < 200; i++)
        {
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, 0.01f * i) * lying
                * Quaternion.CreateFromYawPitchRoll(rng.Float(-1e-7, 1e-7), rng.Float(-1e-7, 1e-7), 0);
            var pose = new RigidPose(
                Quaternion.Normalize(turn), new Vector3(0.003f * i, 0.5f - rng.Float(0, 1e-4), 0.01f * i));
            ConvexQuery.Contacts(
                ConvexShape.Box(new Vector3(10, 1, 10)), new RigidPose(new Vector3(0, -1, 0)), shape, pose,
                ref warm, 1e-3f, out m);
            long[] now = [.. Points(m).Select(p => p.FeatureId).Order()];
            Assert.Equal(name == "capsule" ? 2 : 4, now.Distinct().Count());
            Assert.Equal(names ?? now, now);
            names = now;
        }
    }

    [Fact]
    public void SwappedExchangesAllOfIt()
    {
        ContactManifold m = default;
        ConvexQuery.Contacts(
            new BoxShape(Vector3.One), RigidPose.Identity, new BoxShape(Vector3.One),
            new RigidPose(new Vector3(0.5f, 1.9f, 0.25f)), 0, out m);
        ContactManifold swapped = m.Swapped;
        Assert.Equal((4, -m.Normal), (swapped.Count, swapped.Normal));
        for (int i = 0; i < 4; i++)
        {
            ManifoldPoint p = m[i], q = swapped[i];
            Assert.Equal(
                (p.PointA, p.PointB, p.LocalPointA, p.LocalPointB, p.Gap),
                (q.PointB, q.PointA, q.LocalPointB, q.LocalPointA, q.Gap));
            Assert.NotEqual(p.FeatureId, q.FeatureId);
            Assert.Equal(p, q.Swapped);
        }

        Assert.Throws<ArgumentOutOfRangeException>(() => m[4]);
        Assert.Throws<ArgumentOutOfRangeException>(() => m[-1]);
        m.Clear();
        Assert.Equal((0, Vector3.Zero), (m.Count, m.Normal));
    }

    private static IEnumerable<ManifoldPoint> Points(ContactManifold m) =>
        Enumerable.Range(0, m.Count).Select(i => m[i]);

    private static void Check(TestPair p, in DistanceResult r, ContactManifold m, float maxGap)
    {
        double size = Math.Max(p.A.Reach, p.B.Reach) * 2, tolerance = 4e-6 * size;
        Assert.Equal(r.Normal, m.Normal);
        Assert.Equal(m.Count, Points(m).Select(c => c.FeatureId).Distinct().Count());
        Assert.InRange(Points(m).Min(c => c.Gap), r.Distance, r.Distance + tolerance);
        var a = new Body<ConvexShape>(p.A.Shape, p.PoseA);
        var b = new Body<ConvexShape>(p.B.Shape, p.PoseB);
        foreach (ManifoldPoint c in Points(m))
        {
            string text = $"{p}: {c} of {r}";
            Assert.True(c.Gap >= r.Distance && c.Gap <= maxGap + tolerance, text);
            Assert.True((c.PointA + m.Normal * c.Gap - c.PointB).Length() <= tolerance, text);
            Assert.True((p.PoseA.TransformPoint(c.LocalPointA) - c.PointA).Length() <= tolerance, text);
            Assert.True((p.PoseB.TransformPoint(c.LocalPointB) - c.PointB).Length() <= tolerance, text);
            double outsideA = a.Outside(c.LocalPointA), outsideB = b.Outside(c.LocalPointB);
            Assert.True(Math.Max(outsideA, outsideB) <= tolerance, $"{text}: {outsideA:R} off A, {outsideB:R} off B");
        }
    }
}
