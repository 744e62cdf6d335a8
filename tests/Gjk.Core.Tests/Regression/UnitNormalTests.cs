namespace Gjk.Core.Tests.Regression;

/// <summary>A body 1e-14 to 1e-10 beside another one's axis leaves it in the plane of that offset, whose direction kept
/// a part along the axis; normals were up to 1.5e-5 off unit length.</summary>
public class UnitNormalTests
{
    private const string Record =
        "gjk1 segment 0 -58.871982574462891 0 0 58.871982574462891 0 0 @ 0 0 0 1 0 0 0 cone 0.15560492873191833 "
        + "0.76048433780670166 0 @ 0 0 0 1 -2.2136625E-14 0.396743715 1.81051971E-14";

    [Fact]
    public void ALongSegmentBesideAnAxis()
    {
        QueryRecord p = QueryRecord.Parse(Record);
        DistanceResult r = ConvexQuery.SignedDistance(p.A, p.PoseA, p.B, p.PoseB);
        Assert.Equal(1, ((Double3)r.Normal).Length, 1e-7);
    }

    [Fact]
    public void NormalsBesideTheAxisAreOfUnitLength()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(1000); seed++)
        {
            var rng = new Rng(81_000 + seed);
            Vector3 offset = rng.UnitVector() * rng.LogFloat(1e-15, 1e-9);
            var pose = new RigidPose(new Vector3(offset.X, rng.Float(-0.4, 0.4), offset.Z));
            TestShape a = Generators.Shape(rng, seed % 2 == 0 ? "cylinder" : "cone");
            TestShape b = Generators.Shape(rng, seed % 3 == 0 ? "capsule" : seed % 3 == 1 ? "cylinder" : "point");
            var pair = new TestPair($"seed {seed}", a, RigidPose.Identity, b, pose);
            foreach (DistanceResult r in new[] { pair.SignedDistance(), pair.Swapped.SignedDistance() })
            {
                double off = Math.Abs(((Double3)r.Normal).Length - 1);
                Assert.True(off <= 1e-7, $"{off}: {r}, {pair}");
            }
        }
    }
}
