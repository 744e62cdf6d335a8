namespace Gjk.Core.Tests.Regression;

/// <summary>Two meshes of one point each, turned by right angles onto the same point of the world, were 6e-33 apart:
/// what double-double lost when it rotated them. The lower bound was above the true distance, which is 0.</summary>
public class CoincidentPointTests
{
    private const string Found = "gjk1 mesh 1 0.066918917 0.651721001 0.0450020246 @ 0 0 0.707106769 -0.707106769 "
        + "-0.75746727 0.538835108 0.514576554 mesh 1 -0.605930209 0.587796271 -0.431034595 "
        + "@ 0.707106769 0 0 0.707106769 0.50018394 0.0408815965 -0.0282176919";

    [Fact]
    public void TurnedPointsThatCoincideTouch()
    {
        DistanceResult found = QueryRecord.Parse(Found).Distance();
        Assert.True(found.IsOverlapping && found.LowerBound == 0, found.ToString());
        int count = 0;
        for (ulong seed = 0; seed < 200; seed++)
        {
            // (x, y, z) turned by a right angle about z and moved back: the positions below are exact in float.
            var rng = new Rng(seed);
            Vector3 at = new(rng.Below(4096) / 64f, rng.Below(4096) / 64f, rng.Below(4096) / 64f);
            var quarter = Quaternion.Normalize(new Quaternion(0, 0, 1, 1));
            var turned = new RigidPose(quarter, new Vector3(at.X + at.Y, at.Y - at.X, 0));
            DistanceResult r = ConvexQuery.Distance(
                ConvexShape.Mesh([at]), RigidPose.Identity, ConvexShape.Mesh([at]), turned);
            Assert.True(r.IsOverlapping && r.LowerBound == 0, $"seed {seed}, {at}: {r}");
            count++;
        }

        Assert.Equal(200, count);
    }

    /// <summary>Points a hundred-billionth apart, far from B's own origin: B's point, placed from there, was beside A's
    /// point plus the normal times the distance by more than float rounding of so small a distance.</summary>
    [Fact]
    public void PointsThatNearlyCoincideDifferByNormalTimesDistance()
    {
        const string near = "gjk1 point 0 @ 0 0 0 1 0 0 0 mesh 1 -0.511116683 -0.777237654 -0.983893991 "
            + "@ 0 6.99999997E-12 0 1 0.511116683 0.777237654 0.983893991";
        DistanceResult r = QueryRecord.Parse(near).Distance();
        Double3 error = (Double3)r.PointB - r.PointA - (Double3)r.Normal * r.Distance;
        Assert.Equal(GjkStatus.Separated, r.Status);
        Assert.InRange(error.Length, 0, 2e-7 * r.Distance);
    }

    /// <summary>Placed at a pose within their bodies they are no balls by their bounding radii, and had the distance 0
    /// and no normal however large their margins.</summary>
    [Fact]
    public void PlacedPointsThatCoincideHaveAWayOut()
    {
        for (ulong seed = 0; seed < 200; seed++)
        {
            var rng = new Rng(seed);
            float radius = seed % 2 == 0 ? 0 : rng.LogFloat(1e-3, 1e3);
            RigidPose pose = new(rng.Rotation(), rng.Vector(-2, 2)), place = new(rng.Rotation(), rng.Vector(-2, 2));
            var mesh = new ConvexMesh([rng.Vector(-1, 1)]);
            Placed<Rounded<ConvexMesh>> typed = new(new(mesh, radius), pose);
            ConvexShape body = ConvexShape.Mesh(mesh.Hull!).Rounded(radius).Placed(pose);
            DistanceResult r = ConvexQuery.SignedDistance(body, place, body, place);
            CheckedAnswer check = AnswerCheck.SignedDistance(body, place, body, place, r);
            Assert.True(
                r.IsOverlapping && r.Distance == -2 * radius && (r.Normal - Vector3.UnitX).Length() < 1e-6f
                    && check.Status == CheckStatus.Proved,
                $"seed {seed}: {check} {r}");
            WarmStart warm = default;
            DistanceResult[] batch = new DistanceResult[5];
            PairBatch.SignedDistance([body], [place], new ObjectPair[5], batch);
            DistanceResult[] others =
            [
                ConvexQuery.SignedDistance(typed, place, typed, place),
                ConvexQuery.SignedDistance(body, place, body, place, out FinalSimplex _),
                ConvexQuery.SignedDistance(body, place, body, place, ref warm),
                ConvexQuery.SignedDistance(body, place, body, place, ref warm),
                ConvexQuery.Contacts(body, place, body, place, 0, out ContactManifold _),
                .. batch,
            ];
            Assert.All(others, other => Assert.Equal(ResultBits.Of(r), ResultBits.Of(other)));
        }
    }
}
