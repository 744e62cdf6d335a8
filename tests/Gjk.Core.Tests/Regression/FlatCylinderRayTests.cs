namespace Gjk.Core.Tests.Regression;

/// <summary>A ray at the flat side of a flattened cylinder, near its round end, had the normal of that end, and could
/// leave the cylinder where it met it: measured from far along the axis, no digits of the entry were left.</summary>
public class FlatCylinderRayTests
{
    private const string Record =
        "gjk1 cylinder 1.8285588510025264E-07 8221003.5 0 "
        + "* 1.1926551868497726E-13 2.9816379671244314E-14 -0.52453529834747314 "
        + "@ 0.379247934 -0.361126453 -0.405486554 -0.749225855 6.13809032E-15 3.43592308E-15 -4.21162357E-15 "
        + "point 0 @ 0 0 0 1 -1.67391235E-07 1.87715123E-08 -8.36577456E-08 "
        + "~ -0.139181703 -0.0849206746 -0.0622898489 0 0 0";

    [Fact]
    public void TheFlatSideIsMetAcross()
    {
        QueryRecord r = QueryRecord.Parse(Record);
        Vector3 origin = r.PoseB.Position, to = r.MotionB.Velocity;
        RayCastResult ray = ConvexQuery.RayCast(r.A, r.PoseA, origin, to);
        Assert.Equal(CastStatus.Hit, ray.Status);
        Assert.Equal(1, Math.Abs(Vector3.Dot(Vector3.Transform(Vector3.UnitX, r.PoseA.Rotation), ray.Normal)), 1e-5f);
        Assert.True(Vector3.Dot(ray.Normal, to) < 0, $"{ray.Normal}");
        Assert.Equal(CheckStatus.Proved, AnswerCheck.RayCast(r.A, r.PoseA, origin, to, ray).Status);
    }
}
