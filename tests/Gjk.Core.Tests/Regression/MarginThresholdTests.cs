namespace Gjk.Core.Tests.Regression;

/// <summary>With margins, Overlaps compared heights and Distance compared lengths, and where the radii add up to the
/// distance the last bit decided: 9 % of the pairs placed there got two answers. A cast rounded its own way too, and
/// began apart where the distance says that they touch.</summary>
public class MarginThresholdTests
{
    [Fact]
    public void TheReportedPairGetsOneAnswer()
    {
        QueryRecord q = QueryRecord.Parse(
            "gjk1 point 1.8613990545272827 @ 0 0 0 1 -4.88498131E-15 0 0 point 0.91314756870269775 @ 0 0 0 1 "
            + "2.77454662 0 0");
        Assert.Equal(q.Distance().IsOverlapping, ConvexQuery.Overlaps(q.A, q.PoseA, q.B, q.PoseB));
    }

    [Fact]
    public void AtTheThresholdOverlapsSaysWhatDistanceSays()
    {
        int overlapping = 0, count = Budget.Count(20_000);
        for (int i = 0; i < count; i++)
        {
            var rng = new Rng((ulong)i);
            float r = rng.Float(0.1, 2), s = rng.Float(0.1, 2);
            ConvexShape a = rng.Below(2) == 0 ? ConvexShape.Sphere(r) : ConvexShape.Capsule(r, rng.Float(0, 1));
            ConvexShape b = rng.Below(2) == 0 ? ConvexShape.Sphere(s) : ConvexShape.Capsule(s, rng.Float(0, 1));
            double apart = (double)r + s;
            double offset = (float)apart - apart - rng.Float(0, 2) * apart * 2e-15;
            var left = new RigidPose(new Vector3((float)offset, 0, 0));
            var right = new RigidPose(new Vector3((float)apart, 0, 0));
            bool overlaps = ConvexQuery.Overlaps(a, left, b, right);
            DistanceResult d = ConvexQuery.Distance(a, left, b, right);
            Assert.True(
                overlaps == d.IsOverlapping,
                $"Overlaps {overlaps}, Distance {d.Status} {d.Distance:R}: {new QueryRecord(a, left, b, right)}");
            overlapping += overlaps ? 1 : 0;
        }

        Assert.InRange(overlapping, 0.1 * count, count);
    }

    [Fact]
    public void TheReportedCastBeginsAsTheDistanceSays()
    {
        QueryRecord q = QueryRecord.Parse(
            "gjk1 segment 0 0.10000000000000001 0 0 -0.11153502017259598 0 0.43502902984619141 @ 0 0 0 1 0 "
            + "1.11385852E-08 0 segment -0 -0.90000000000000002 -0 -0 0.932399844318752 -0 0.49341031762196508 @ 0 0 0 "
            + "1 0 -1.9723742 0 ~ 0 2 0 0 0 0");
        AssertBeginsAlike(q.A, q.MotionA, q.B, q.MotionB);
    }

    [Fact]
    public void AtTheThresholdMotionsBeginAsTheDistanceSays()
    {
        int overlapping = 0, count = Budget.Count(20_000);
        for (int i = 0; i < count; i++)
        {
            var rng = new Rng((ulong)i);
            float r = rng.Float(0.1, 2), s = rng.Float(0.1, 2), x = rng.Float(0.01, 1), y = rng.Float(0.01, 1);
            ConvexShape a = ConvexShape.Capsule(r, x), b = ConvexShape.Capsule(s, y);
            double apart = (double)r + s + x + y;
            double offset = (float)apart - apart - rng.Float(0, 2) * apart * 2e-15;
            var left = new RigidPose(new Vector3(0, (float)offset, 0));
            var right = new RigidPose(new Vector3(0, (float)apart, 0));
            overlapping += AssertBeginsAlike(
                a, new RigidMotion(left, default), b, new RigidMotion(right, new Vector3(0, -1, 0))) ? 1 : 0;
        }

        Assert.InRange(overlapping, 0.1 * count, 0.95 * count);
    }

    private static bool AssertBeginsAlike(
        in ConvexShape a, in RigidMotion motionA, in ConvexShape b, in RigidMotion motionB)
    {
        CastResult cast = ConvexQuery.Cast(a, motionA.Pose, motionA.Velocity, b, motionB.Pose, motionB.Velocity);
        CastResult impact = ConvexQuery.TimeOfImpact(a, motionA, b, motionB);
        DistanceResult d = ConvexQuery.SignedDistance(a, motionA.Pose, b, motionB.Pose);
        bool isAlike = cast.Status == CastStatus.Hit && impact.Status == CastStatus.Hit
            && d.IsOverlapping == (cast.Fraction == 0) && d.IsOverlapping == (impact.Fraction == 0);
        Assert.True(
            isAlike || (d.IsOverlapping && d.Distance < 0),
            isAlike ? "" : $"{d}, cast {cast}, impact {impact}: {new QueryRecord(a, motionA, b, motionB)}");
        return d.IsOverlapping;
    }
}
