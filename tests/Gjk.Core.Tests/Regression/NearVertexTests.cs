namespace Gjk.Core.Tests.Regression;

/// <summary>Two vertices 5.7e-8 apart were called overlapping: the walk met a tetrahedron so flat that the rounded
/// signs of its determinants said it held the origin. Enclosure is believed here only where the determinants are larger
/// than their rounding.</summary>
public class NearVertexTests
{
    [Fact]
    public void VerticesAHairApartAreApart()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(2000); seed++)
        {
            TestPair pair = Pair(seed, 5.7e-8f);
            DistanceResult r = pair.Distance();
            string? problem = OracleVerdict.Problem(pair, out ExactAnswer exact);
            Assert.True(problem is null, $"{problem}\n{pair}");
            Assert.False(exact.Overlap);
            Assert.True(
                r.Status == GjkStatus.Separated && r.Distance > 0,
                $"{r.Status} {r.Distance:R}, truly {exact.Distance:R}\n{pair}");
        }
    }

    [Fact]
    public void DownToTheEdgeOfWhatDoublesHold()
    {
        foreach (float gap in new[] { 1e-12f, 1e-10f, 1e-9f, 1e-6f })
        {
            for (ulong seed = 0; seed < (ulong)Budget.Count(200); seed++)
            {
                TestPair pair = Pair(seed, gap);
                string? problem = OracleVerdict.Problem(pair, out _);
                Assert.True(problem is null, $"{problem}\n{pair}");
                Assert.False(pair.Distance().IsOverlapping, $"Distance\n{pair}");
                Assert.False(pair.Overlaps(), $"Overlaps\n{pair}");
            }
        }
    }

    /// <summary>Two flat-topped pyramids, tip to tip about x: each tip is a vertex at its own origin, and the gap lies
    /// between the origins.</summary>
    private static TestPair Pair(ulong seed, float gap)
    {
        var rng = new Rng(seed);
        Quaternion q = seed % 4 == 0 ? Quaternion.Identity : rng.Rotation();
        TestShape a = Tip(rng, -1), b = Tip(rng, 1);
        return new TestPair(
            $"seed {seed}, gap {gap}", a, new RigidPose(q, default), b,
            new RigidPose(q, (Vector3)new RotationD(q).Rotate(new Double3(gap, 0, 0))));
    }

    private static TestShape Tip(Rng rng, float side)
    {
        var points = new Vector3[2 + rng.Below(8)];
        for (int i = 1; i < points.Length; i++)
        {
            points[i] = new Vector3(
                side * rng.Float(0.05, 1), rng.Float(-1, 1), rng.Below(3) == 0 ? 0 : rng.Float(-1, 1));
        }
        return TestShape.Mesh(points);
    }
}
