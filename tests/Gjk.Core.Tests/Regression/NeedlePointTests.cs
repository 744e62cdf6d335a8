namespace Gjk.Core.Tests.Regression;

/// <summary>The deepest points of a large ball and a mesh that is a needle but for rounding: depth, normal and the
/// point of the world were right, but the needle's local point was that of its far end. Found by fuzz.</summary>
public class NeedlePointTests
{
    private const string Found =
        "gjk1 point 502.50477291974676 @ 0.707106769 0 0 0.707106769 7.52424967E-09 8.93978722E-08 1.96669134E-08 "
        + "mesh 6 -0.052751001 0.243462145 0.0807762221 -0.0993453637 0.458509505 0.152124956 0.0960599929 "
        + "-0.4433465 -0.147094145 -0.0337582491 0.155804738 0.0516931266 -0.0798633546 0.368594021 0.12229266 "
        + "-0.0999916866 0.461492479 0.153114647 * 855.088134765625 855.088134765625 855.088134765625 "
        + "@ 0.707106769 0 0 0.707106769 1.68097234 2.57402968 -7.75820541";

    /// <summary>The edge that was chosen of a needle has both ends on one side of the ball's centre.</summary>
    private const string Beyond =
        "gjk1 point 802.01861572265625 @ 0.809763849 0.00238960632 0.370465457 0.455007851 -2.92003983E-06 "
        + "-1.29679329E-05 5.91832031E-06 mesh 5 -0.00293396949 0.00463487441 0.0247886647 -0.00509851379 "
        + "0.00805426575 0.0430765748 0.0492829792 -0.0778537169 -0.416384459 -0.000302563392 0.000477967929 "
        + "0.0025563126 -0.113030002 0.178556696 0.954973459 * 77.398124694824219 77.398124694824219 "
        + "77.398124694824219 @ 0.182652205 0.958714604 -0.211457565 -0.0528223887 -4.96570146E-06 "
        + "-2.36485921E-05 8.88149407E-06";

    /// <summary>From a warm start the distance was a third of what it is: that of a line, beside its edge.</summary>
    private const string Warm =
        "gjk1 mesh 3 -0.150193676 0.391604692 -0.441726178 0.00631988328 -0.01647803 0.0185870528 "
        + "0.0476675034 -0.124284975 0.140192211 * 464.1405029296875 464.1405029296875 464.1405029296875 @ "
        + "-0.858758986 -0.151688665 0.25035876 -0.420528233 1.27650726 1.07490826 -0.181969211 mesh 4 "
        + "-0.0365916416 -0.0978092849 -0.256124109 -0.120547302 -0.322222382 -0.843773901 -0.04356727 "
        + "-0.116455108 -0.304950207 -0.00166624214 -0.00445385743 -0.0116629042 * 475.76165771484375 "
        + "475.76165771484375 475.76165771484375 @ 0.0343988314 0.730580747 -0.0190043338 -0.681694448 "
        + "-3.903409 3.55657864 1.10540533";

    [Fact]
    public void TheNeedlesPointIsInTheMiddle()
    {
        QueryRecord pair = QueryRecord.Parse(Found);
        DistanceResult r = ConvexQuery.SignedDistance(pair.A, pair.PoseA, pair.B, pair.PoseB);
        Vector3 off = r.LocalPointB - new Vector3(-1.68097f, 7.75821f, 2.57403f);
        Assert.True(off.Length() < 1e-4f, $"{r.LocalPointB}");
    }

    [Theory]
    [InlineData(Found)]
    [InlineData(Beyond)]
    [InlineData(Warm)]
    public void WhatWasFoundPassesTheCheck(string record)
    {
        QueryRecord pair = QueryRecord.Parse(record);
        Check(0, pair.A, pair.PoseA, pair.B, pair.PoseB);
    }

    /// <summary>Needles, slivers, doubled corners, triangles without area, with margins and without, against points,
    /// balls, segments and each other, about where they touch.</summary>
    [Fact]
    public void EveryAnswerAboutFlatShapesPassesTheCheck()
    {
        int overlaps = 0, count = Budget.Count(4000);
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            var rng = new Rng(seed);
            ConvexShape a = Thin(rng), b = Other(rng);
            Vector3 at = rng.Below(2) == 0 ? default : rng.Vector(-3, 3);
            RigidPose poseA = new(rng.Rotation(), at), poseB = new(rng.Rotation(), at);
            if (rng.Below(4) == 0) (a, b) = (b, a);
            Place(rng, a, ref poseA, b, ref poseB);
            overlaps += Check(seed, a, poseA, b, poseB);
            Cast(seed, rng, a, poseA, b, poseB);
        }

        Assert.InRange((double)overlaps / count, 0.3, 0.8);
    }

    private static int Check(
        ulong seed, in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB)
    {
        DistanceResult plain = ConvexQuery.Distance(a, poseA, b, poseB);
        DistanceResult signed = ConvexQuery.SignedDistance(a, poseA, b, poseB);
        var nearby = new RigidPose(poseB.Rotation, poseB.Position * 1.01f);
        WarmStart warm = default, warmSigned = default;
        ConvexQuery.Distance(a, poseA, b, nearby, ref warm);
        ConvexQuery.SignedDistance(a, poseA, b, nearby, ref warmSigned);
        DistanceResult again = ConvexQuery.Distance(a, poseA, b, poseB, ref warm);
        DistanceResult signedAgain = ConvexQuery.SignedDistance(a, poseA, b, poseB, ref warmSigned);
        DistanceResult contacts = ConvexQuery.Contacts(a, poseA, b, poseB, 0.1f, out _);
        Hold(seed, "distance", AnswerCheck.Distance(a, poseA, b, poseB, plain), a, poseA, b, poseB);
        Hold(seed, "warm distance", AnswerCheck.Distance(a, poseA, b, poseB, again), a, poseA, b, poseB);
        Hold(seed, "signed", AnswerCheck.SignedDistance(a, poseA, b, poseB, signed), a, poseA, b, poseB);
        Hold(seed, "warm signed", AnswerCheck.SignedDistance(a, poseA, b, poseB, signedAgain), a, poseA, b, poseB);
        if (contacts.Status != GjkStatus.BeyondMaxDistance)
            Hold(seed, "contacts", AnswerCheck.SignedDistance(a, poseA, b, poseB, contacts), a, poseA, b, poseB);
        return signed.IsOverlapping ? 1 : 0;
    }

    private static void Cast(
        ulong seed, Rng rng, in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB)
    {
        float size = (float)(a.BoundingRadius + b.BoundingRadius);
        Vector3 way = rng.UnitVector() * (2 * size), aside = rng.UnitVector() * (rng.LogFloat(1e-8, 0.3) * size);
        var start = new RigidPose(poseB.Rotation, poseB.Position - way + aside);
        CastResult cast = ConvexQuery.Cast(a, poseA, default, b, start, way * 2);
        Hold(seed, "cast", AnswerCheck.Cast(a, poseA, default, b, start, way * 2, cast), a, poseA, b, start);
    }

    private static void Hold(
        ulong seed, string verb, in CheckedAnswer check, in ConvexShape a, in RigidPose poseA, in ConvexShape b,
        in RigidPose poseB) =>
        Assert.True(
            check.Status != CheckStatus.Refuted,
            $"seed {seed}, {verb}: {check}\n{new QueryRecord(a, poseA, b, poseB)}");

    /// <summary>Brings the shapes, or their cores, to where they touch, or nearly. What B's position loses by rounding
    /// is put into A's, if that is the origin.</summary>
    private static void Place(
        Rng rng, in ConvexShape a, ref RigidPose poseA, in ConvexShape b, ref RigidPose poseB)
    {
        for (int i = 0; i < 2; i++)
        {
            DistanceResult r = ConvexQuery.SignedDistance(a, poseA, b, poseB);
            Double3 normal = r.Normal == default ? rng.UnitVector() : r.Normal;
            double size = a.BoundingRadius + b.BoundingRadius, deep = rng.Below(3) > 0 ? a.Margin + b.Margin : 0;
            double gap = rng.Below(3) == 0 ? 0 : (rng.Below(2) == 0 ? 1 : -1) * rng.LogFloat(1e-14, 1e-3) * size;
            Double3 exact = poseB.Position + normal * (gap - r.Distance - deep);
            poseB = new RigidPose(poseB.Rotation, (Vector3)exact);
            if (poseA.Position.Length() <= 1e-5 * size)
                poseA = new RigidPose(poseA.Rotation, (Vector3)((Double3)poseB.Position - exact + poseA.Position));
        }
    }

    private static ConvexShape Thin(Rng rng)
    {
        int count = 2 + rng.Below(5);
        Vector3 along = rng.UnitVector(), across = rng.UnitVector();
        float thickness = rng.Below(3) == 0 ? rng.LogFloat(1e-9, 1e-4) : 0, scale = rng.LogFloat(0.1, 1000);
        var corners = new Vector3[count];
        for (int i = 0; i < count; i++)
        {
            corners[i] = i > 0 && rng.Below(6) == 0 ? corners[rng.Below(i)]
                : along * rng.Float(-1, 1) + across * (thickness * rng.Float(-1, 1));
        }

        ConvexShape shape = count == 3 && rng.Below(2) == 0
            ? ConvexShape.Triangle(corners[0], corners[1], corners[2])
            : ConvexShape.Mesh(corners);
        if (rng.Below(2) == 0) shape = shape.Scaled(new Vector3(scale));
        return rng.Below(3) == 0 ? shape.Rounded(rng.LogFloat(1e-3, 1000)) : shape;
    }

    private static ConvexShape Other(Rng rng) => rng.Below(8) switch
    {
        0 => ConvexShape.Point(),
        1 => ConvexShape.Sphere(rng.LogFloat(0.1, 1000)),
        2 => ConvexShape.Segment(rng.UnitVector(), rng.UnitVector()),
        3 => ConvexShape.Capsule(rng.LogFloat(1e-3, 100), rng.LogFloat(1e-3, 100)),
        4 => ConvexShape.Box(rng.Vector(0, 1)),
        5 => Thin(rng),
        _ => ConvexShape.Sphere(rng.LogFloat(0.1, 1000)),
    };
}
