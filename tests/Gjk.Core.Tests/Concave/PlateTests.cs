using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Concave;

/// <summary>Parallel plates have as many nearest pairs as triangles; planes drop them without a query of
/// each.</summary>
public class PlateTests
{
    [Theory]
    [InlineData(0f)]
    [InlineData(1e-14f)]
    [InlineData(1e-9f)]
    [InlineData(1e-7f)]
    [InlineData(1e-6f)]
    [InlineData(1e-5f)]
    [InlineData(0.1f)]
    public void PlatesHaveTheLeastDistanceOfAllTheirParts(float gap)
    {
        var plate = AnyShape.Surface(ConcaveShapes.Grid(8));
        var scratch = new ConcaveScratch();
        for (int i = 0; i < 12; i++)
        {
            var rng = new Rng((ulong)i);
            Quaternion turn = i == 0 ? Quaternion.Identity : Quaternion.Normalize(rng.Rotation());
            var poseA = new RigidPose(turn, i < 6 ? Vector3.Zero : rng.Vector(-3, 3));
            Vector3 slide = i % 3 == 0 ? Vector3.Zero : new Vector3(rng.Float(-0.4, 0.4), 0, rng.Float(-0.4, 0.4));
            var poseB = new RigidPose(turn, poseA.Position + Vector3.Transform(slide + new Vector3(0, gap, 0), turn));
            float least = float.PositiveInfinity;
            bool overlaps = false;
            foreach (ConvexShape a in ConcaveShapes.Parts(plate))
            {
                foreach (ConvexShape b in ConcaveShapes.Parts(plate))
                {
                    DistanceResult d = ConvexQuery.Distance(a, poseA, b, poseB);
                    least = Math.Min(least, d.Distance);
                    overlaps |= d.IsOverlapping;
                }
            }

            PartDistance found = ConcaveQuery.Distance(plate, poseA, plate, poseB, scratch);
            Assert.Equal((least, overlaps), (found.Distance, found.IsOverlapping));
            Assert.True(found.Result.LowerBound <= least, $"{found.Result.LowerBound:R} above {least:R}");
            Assert.Equal(overlaps, ConcaveQuery.Overlaps(plate, poseA, plate, poseB, scratch));
            foreach (float most in new[] { least * 0.5f, least, least * 2 })
            {
                PartDistance within = ConcaveQuery.Distance(plate, poseA, plate, poseB, scratch, most);
                Assert.Equal(least <= most, within.Status != GjkStatus.BeyondMaxDistance);
                if (least <= most) Assert.Equal(least, within.Distance);
            }
        }
    }
}
