namespace Gjk.Core.Tests.Regression;

/// <summary>Rays that are flat to an edge of a triangle, or pass its corner, hit it from up to a thousand times as far
/// away as is promised: a volume that is compared is the distance from the edge times the sine between them.</summary>
public class TriangleEdgeRayTests
{
    private const int Rays = 20_000;

    [Theory]
    [InlineData("gjk1 triangle 0.83645051717758179 0.36609387397766113 -0.88280481100082397 0 0 0 "
        + "0.64290153980255127 -0.9576946496963501 -0.66732943058013916 "
        + "@ 0 0 0 1 3.46775142E-09 -2.20752472E-10 -9.83533788E-09 "
        + "point 0 @ 0 0 0 1 0.132191703 0.074796088 -0.169423729 ~ -0.16741541 -0.0947262049 0.214568257 0 0 0")]
    [InlineData("gjk1 triangle 0.43522608280181885 0.64354521036148071 0.73388779163360596 "
        + "-0.015428335405886173 -0.065194137394428253 0.98806619644165039 "
        + "0.3749406635761261 -0.7624281644821167 -0.98722583055496216 "
        + "@ 0 0 0 1 -1.23640911E-08 3.21212106E-08 -8.09647673E-08 "
        + "point 0 @ 0 0 0 1 0.401780218 -0.467979908 -0.677289844 ~ -0.018876018 -0.207082734 -0.217975199 0 0 0")]
    [InlineData("gjk1 triangle -0.07940654456615448 0.070628434419631958 -0.65293914079666138 "
        + "0.28421348333358765 -0.10043796896934509 1.2122581005096436 "
        + "0.26725631952285767 -0.095933876931667328 1.1326098442077637 "
        + "@ 0 0 0 1 3.26464544E-08 2.71149037E-09 5.76671555E-09 "
        + "point 0 @ 0 0 0 1 -0.266841084 0.160618573 -1.61788082 ~ 0.534097433 -0.256552458 2.75049067 0 0 0")]
    public void ARayBesideACornerMisses(string record)
    {
        QueryRecord r = QueryRecord.Parse(record);
        RayCastResult ray = ConvexQuery.RayCast(r.A, r.PoseA, r.PoseB.Position, r.MotionB.Velocity);
        Assert.Equal(CastStatus.Miss, ray.Status);
        Proved(r.A, r.PoseA, r.PoseB.Position, r.MotionB.Velocity, ray);
    }

    /// <summary>Aimed at corners and edges, mostly along the edge, of wide triangles and thin ones.</summary>
    [Fact]
    public void NoRayNearAnEdgeIsRefuted()
    {
        var rng = new Rng(43);
        int hits = 0;
        for (int i = 0; i < Rays; i++)
        {
            Vector3 a = rng.UnitVector(), c = rng.UnitVector() * rng.Float(0.1, 1);
            Vector3 way = rng.UnitVector(), b = i % 2 == 0 ? way * rng.Float(0.1, 1) : a + way * rng.Float(1e-4, 1e-2);
            Vector3 edge = i % 3 == 0 ? c - b : a - c, aim = c + (i % 4 < 2 ? default : (a - c) * rng.Float(0, 1));
            Vector3 to = Vector3.Normalize(edge) + rng.UnitVector() * rng.LogFloat(1e-4, 1);
            Vector3 origin = aim - to * rng.Float(0.1, 2);
            Vector3 off = rng.UnitVector() * rng.LogFloat(1e-9, 3e-8);
            ConvexShape triangle = ConvexShape.Triangle(a, b, c);
            var pose = new RigidPose(origin + to - aim + off);
            RayCastResult ray = ConvexQuery.RayCast(triangle, pose, origin, to);
            if (ray.Status == CastStatus.Hit) hits++;
            Proved(triangle, pose, origin, to, ray);
        }

        Assert.InRange(hits, Rays / 10, Rays * 9 / 10);
    }

    private static void Proved(
        in ConvexShape shape, in RigidPose pose, Vector3 origin, Vector3 to, in RayCastResult ray)
    {
        CheckedAnswer check = AnswerCheck.RayCast(shape, pose, origin, to, ray);
        Assert.True(check.Status != CheckStatus.Refuted, $"{ray}: {check}, {shape} at {pose}, {origin} along {to}");
    }
}
