namespace Gjk.Core.Tests.Regression;

/// <summary>A shape in a copy of itself that is turned by a few last places: the facets of the two lie beside each
/// other, support points lie above a face by rounding alone, and the surface turned inside out. The depth was said to
/// be 0, or the room ran out.</summary>
public class NearCopyDepthTests
{
    private static readonly Vector3[] Octahedron =
    [
        Vector3.UnitX, -Vector3.UnitX, Vector3.UnitY, -Vector3.UnitY, Vector3.UnitZ, -Vector3.UnitZ,
    ];

    [Fact]
    public void AnOctahedronInItself()
    {
        ConvexShape shape = ConvexShape.Mesh(Octahedron);
        DistanceResult r = ConvexQuery.SignedDistance(
            shape, new RigidPose(new(0.5f, 0.5f, -0.5f, 0.5f), default),
            shape, new RigidPose(new(0.5f, 0.500000119f, -0.5f, 0.5f), default));
        Assert.Equal((GjkStatus.Overlapping, -1.1547005f), (r.Status, r.Distance));
    }

    [Fact]
    public void ShapesThatAreTurnedByAFewLastPlaces()
    {
        ConvexShape[] shapes =
        [
            ConvexShape.Mesh(Octahedron), Prism(3), Prism(12),
            Prism(64), ConvexShape.Box(Vector3.One),
        ];
        double[] depths = [2 / Math.Sqrt(3), 1.5, 2 * Math.Cos(Math.PI / 12), 2 * Math.Cos(Math.PI / 64), 2];
        for (ulong seed = 0; seed < (ulong)Budget.Count(400); seed++)
        {
            var rng = new Rng(81_000 + seed);
            Quaternion q = rng.Rotation();
            float[] off = [.. Enumerable.Range(0, 4).Select(_ => rng.Float(-1e-7, 1e-7))];
            var turned = Quaternion.Normalize(new(q.X + off[0], q.Y + off[1], q.Z + off[2], q.W + off[3]));
            int kind = rng.Below(shapes.Length);
            DistanceResult r = ConvexQuery.SignedDistance(
                shapes[kind], new RigidPose(q, default), shapes[kind], new RigidPose(turned, default));
            Assert.True(
                r.IsOverlapping && Math.Abs(r.Distance + depths[kind]) < 2e-6, $"seed {seed}, kind {kind}: {r}");
        }
    }

    [Fact]
    public void APointInACylinderOfManySides()
    {
        ConvexShape cylinder = Prism(8);
        DistanceResult r = ConvexQuery.SignedDistance(
            ConvexShape.Point(), new RigidPose(new Vector3(0.136410892f, 0.0401664525f, 0.04207756f)), cylinder,
            new RigidPose(new(0, 0, 0.866025388f, 0.5f), default));
        Assert.Equal((GjkStatus.Overlapping, -0.8617815f), (r.Status, r.Distance));
    }

    [Theory]
    [InlineData(0.70710677f, 0, 0.70710677f)]
    [InlineData(0, 0.70710677f, 0.70710677f)]
    [InlineData(0, 0, 1)]
    public void ABoxInACylinderOfManySides(float y, float z, float w)
    {
        DistanceResult r = ConvexQuery.SignedDistance(
            ConvexShape.Box(Vector3.One), new RigidPose(new(0, y, z, w), default), Prism(12),
            RigidPose.Identity);
        Assert.Equal((GjkStatus.Overlapping, -2f), (r.Status, r.Distance));
    }

    /// <summary>Vertices of A - B that nearly coincide leave faces whose normals are rounding, and a corner that the
    /// surface has already lies above a level face by rounding: there was said to be no room.</summary>
    [Theory]
    [MemberData(nameof(Crowded))]
    public void FacesThatAreRoundingDoNotFillTheRoom(string record, float depth)
    {
        QueryRecord q = QueryRecord.Parse(record);
        DistanceResult r = ConvexQuery.SignedDistance(q.A, q.PoseA, q.B, q.PoseB);
        DistanceResult swapped = ConvexQuery.SignedDistance(q.B, q.PoseB, q.A, q.PoseA);
        foreach (DistanceResult d in new[] { r, swapped })
        {
            Assert.Equal(GjkStatus.Overlapping, d.Status);
            Assert.Equal(-depth, d.Distance, 1.2e-7 * depth + 1e-14);
            Assert.True(d.LowerBound <= d.Distance && d.LowerBound >= -depth * (1 + 1e-6f), d.ToString());
            Assert.InRange(d.Iterations, 1, 30);
        }
    }

    /// <summary>The edges that the way out is across cross far outside both, by rounding.</summary>
    [Fact]
    public void BoxesWhoseEdgesAreNearlyParallelMeetOnBoth()
    {
        var box = ConvexShape.Box(Vector3.One);
        var poseA = new RigidPose(new(-5.4926101e-8f, -7.76107782e-8f, -0.707106829f, 0.707106829f), new(1, -1, 0));
        var poseB = new RigidPose(new(0, 0, -0.707106769f, 0.707106769f), default);
        foreach (DistanceResult r in new[]
        {
            ConvexQuery.SignedDistance(box, poseA, box, poseB),
            ConvexQuery.SignedDistance(box, poseB, box, poseA).Swapped,
        })
        {
            Assert.Equal(-1, r.Distance, 1e-6f);
            Assert.InRange(Vector3.Abs(r.LocalPointA).Length(), 0, MathF.Sqrt(3) * (1 + 1e-6f));
            Assert.True(Vector3.Max(Vector3.Abs(r.LocalPointA), Vector3.Abs(r.LocalPointB)).Y <= 1 + 1e-6f);
            Assert.True(Vector3.Max(Vector3.Abs(r.LocalPointA), Vector3.Abs(r.LocalPointB)).X <= 1 + 1e-6f);
        }
    }

    public static TheoryData<string, float> Crowded => new()
    {
        {
            "gjk1 mesh 6 1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1 @ 0.277350098 0.554700196 0.554700196 "
            + "0.554700196 0 0 0 mesh 6 1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1 @ 0.277350068 0.554700196 "
            + "0.554700196 0.554700196 0 0 0",
            1.1547005f
        },
        {
            "gjk1 mesh 6 1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1 @ -0.200000003 -0.400000006 0.400000006 "
            + "0.800000012 0 0 0 mesh 6 1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1 @ -0.200000018 -0.400000006 "
            + "0.399999976 0.800000012 0 0 0",
            1.1547005f
        },
        {
            "gjk1 mesh 6 1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1 @ 0.566946745 -0.188982248 0.566946745 "
            + "0.566946745 0 0 0 mesh 6 1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1 @ 0.566946745 -0.188982233 "
            + "0.566946745 0.566946745 0 0 0",
            1.1547005f
        },
        {
            "gjk1 point 3.9177517464850098E-05 @ 0 0 0 1 0.44925487 0.8947528 -1.08365452 mesh 65 0.699999988 "
            + "-1.29999995 0 0.696629286 -1.29999995 0.0686119944 0.686549664 -1.29999995 0.136563227 0.669858217"
            + " -1.29999995 0.203199282 0.646715641 -1.29999995 0.267878413 0.617344856 -1.29999995 0.329977721 "
            + "0.582028687 -1.29999995 0.388899177 0.541107297 -1.29999995 0.444075316 0.494974732 -1.29999995 "
            + "0.494974732 0.444075286 -1.29999995 0.541107297 0.388899118 -1.29999995 0.582028747 0.329977661 "
            + "-1.29999995 0.617344916 0.267878383 -1.29999995 0.646715641 0.203199238 -1.29999995 0.669858217 "
            + "0.136563167 -1.29999995 0.686549723 0.0686119944 -1.29999995 0.696629286 -3.05979704E-08 "
            + "-1.29999995 0.699999988 -0.068612054 -1.29999995 0.696629286 -0.136563227 -1.29999995 0.686549664 "
            + "-0.203199297 -1.29999995 0.669858217 -0.267878443 -1.29999995 0.646715641 -0.329977781 -1.29999995"
            + " 0.617344856 -0.388899237 -1.29999995 0.582028687 -0.444075286 -1.29999995 0.541107357 "
            + "-0.494974732 -1.29999995 0.494974732 -0.541107357 -1.29999995 0.444075286 -0.582028747 -1.29999995"
            + " 0.388899118 -0.617344916 -1.29999995 0.329977632 -0.646715701 -1.29999995 0.267878294 "
            + "-0.669858217 -1.29999995 0.203199297 -0.686549723 -1.29999995 0.136563212 -0.696629286 -1.29999995"
            + " 0.0686119646 -0.699999988 -1.29999995 -6.11959408E-08 -0.696629286 -1.29999995 -0.0686120838 "
            + "-0.686549664 -1.29999995 -0.136563346 -0.669858217 -1.29999995 -0.203199401 -0.646715641 "
            + "-1.29999995 -0.267878383 -0.617344856 -1.29999995 -0.329977751 -0.582028687 -1.29999995 "
            + "-0.388899207 -0.541107237 -1.29999995 -0.444075376 -0.494974643 -1.29999995 -0.494974822 "
            + "-0.444075316 -1.29999995 -0.541107297 -0.388898998 -1.29999995 -0.582028806 -0.329977661 "
            + "-1.29999995 -0.617344916 -0.267878175 -1.29999995 -0.64671576 -0.203199178 -1.29999995 "
            + "-0.669858217 -0.136563271 -1.29999995 -0.686549664 -0.0686118528 -1.29999995 -0.696629286 "
            + "8.34741609E-09 -1.29999995 -0.699999988 0.068612203 -1.29999995 -0.696629286 0.136563286 "
            + "-1.29999995 -0.686549664 0.203199506 -1.29999995 -0.669858158 0.267878532 -1.29999995 -0.646715581"
            + " 0.329977691 -1.29999995 -0.617344916 0.388899297 -1.29999995 -0.582028627 0.444075316 -1.29999995"
            + " -0.541107297 0.494974911 -1.29999995 -0.494974554 0.541107357 -1.29999995 -0.444075197 "
            + "0.582028687 -1.29999995 -0.388899207 0.617344916 -1.29999995 -0.329977572 0.646715701 -1.29999995 "
            + "-0.267878383 0.669858277 -1.29999995 -0.203199074 0.686549723 -1.29999995 -0.136563167 0.696629345"
            + " -1.29999995 -0.0686117336 0 1.29999995 0 @ 0.346132219 -0.399340332 -0.80673033 -0.264397442 0 0 "
            + "0",
            3.918826e-05f
        },
        {
            "gjk1 mesh 10 1 -9.44715575E-05 0 0.766044438 -9.44715575E-05 0.642787635 0.173648104 "
            + "-9.44715575E-05 0.984807789 -0.50000006 -9.44715575E-05 0.866025388 -0.939692676 -9.44715575E-05 "
            + "0.342020005 -0.939692557 -9.44715575E-05 -0.342020392 -0.499999911 -9.44715575E-05 -0.866025448 "
            + "0.173648626 -9.44715575E-05 -0.98480767 0.766044617 -9.44715575E-05 -0.642787397 0 9.44715575E-05 "
            + "0 @ 0 0 0 1 0 0 0 mesh 10 1 -9.44715575E-05 0 0.766044438 -9.44715575E-05 0.642787635 0.173648104 "
            + "-9.44715575E-05 0.984807789 -0.50000006 -9.44715575E-05 0.866025388 -0.939692676 -9.44715575E-05 "
            + "0.342020005 -0.939692557 -9.44715575E-05 -0.342020392 -0.499999911 -9.44715575E-05 -0.866025448 "
            + "0.173648626 -9.44715575E-05 -0.98480767 0.766044617 -9.44715575E-05 -0.642787397 0 9.44715575E-05 "
            + "0 @ 0 0 1 6.12323426E-17 0 0 0",
            0.00018894312f
        },
        {
            "gjk1 point 0 @ 0 0 0 1 -0.0925860927 -0.731574476 1.18645835 mesh 25 1 -1 0 0.965925813 -1 "
            + "0.258819044 0.866025388 -1 0.5 0.707106769 -1 0.707106769 0.49999997 -1 0.866025448 0.258818954 -1"
            + " 0.965925872 -4.37113883E-08 -1 1 -0.258819163 -1 0.965925813 -0.50000006 -1 0.866025388 "
            + "-0.707106769 -1 0.707106769 -0.866025507 -1 0.499999821 -0.965925872 -1 0.258818924 -1 -1 "
            + "-8.74227766E-08 -0.965925813 -1 -0.258819073 -0.866025269 -1 -0.500000179 -0.707106829 -1 "
            + "-0.707106709 -0.499999911 -1 -0.866025448 -0.258818984 -1 -0.965925872 1.19248806E-08 -1 -1 "
            + "0.258819014 -1 -0.965925813 0.500000358 -1 -0.866025209 0.707107008 -1 -0.707106531 0.866025567 -1"
            + " -0.499999762 0.965925753 -1 -0.258819282 0 1 0 @ 0 -0.688247204 0.22941573 0.688247204 0 0 0",
            2.31394e-8f
        },
        {
            "gjk1 mesh 4 -0.150000006 0 0 0.148207515 0 0 -0.150000006 1 -0.800000012 0.148207515 0 "
            + "-0.826063931 @ 0 0 0 1 0 0 0 mesh 6 -0.148207515 1 -0.826063931 0.150000006 0 -0.800000012 "
            + "-0.148207515 -1 -0.826063931 0.150000006 1 0 -0.14820753 0 0.800000012 -0.148207515 0 -0.826063991"
            + " @ 0 1.00000001E-07 0 1 0 0 0",
            0.2964152f
        },
    };

    private static ConvexShape Prism(int sides) => ConvexShape.Mesh(Clouds.Prism(sides, 1, 1));
}
