using static Gjk.Core.Tests.Support.Resting;

namespace Gjk.Core.Tests.Contacts;

/// <summary>Contacts of shapes with round sides, whose points can be worked out by hand.</summary>
public class RoundContactTests
{
    [Theory]
    [InlineData(0)]
    [InlineData(1e-7f)]
    [InlineData(0.0174533f)]
    public void ACapsuleOnABoxLiesOnTwoPoints(float angle)
    {
        var capsule = ConvexShape.Capsule(0.25f, 1);
        ContactManifold m = OnSlab(
            capsule, Lowered(capsule, Quaternion.CreateFromAxisAngle(Vector3.UnitZ, angle) * OnItsSide));
        AssertPlaces(m, 1e-4f + angle * angle, (1, 0), (-1, 0));
        float[] gaps = [.. Points(m).Select(p => p.Gap).Order()];
        Assert.Equal(-Depth, gaps[0], 1e-6f);

        // Above its end the capsule is part of the cylinder, whose radius is longer straight down than across it.
        Assert.Equal(-Depth + 2 * MathF.Sin(angle) - 0.25f * (1 / MathF.Cos(angle) - 1), gaps[1], 1e-6f);
    }

    [Fact]
    public void ACapsuleThatStandsTouchesInOnePoint()
    {
        var capsule = ConvexShape.Capsule(0.25f, 1);
        AssertPlaces(OnSlab(capsule, Lowered(capsule, Quaternion.Identity)), (0, 0));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(0.4f)]
    public void TwoCapsulesSideBySideTouchAlongTheirCommonPart(float shift)
    {
        var capsule = ConvexShape.Capsule(0.25f, 1);
        ContactManifold m = Ask(
            capsule, RigidPose.Identity, capsule, new RigidPose(new Vector3(0.5f - Depth, shift, 0)));
        Assert.Equal(2, m.Count);
        float[] heights = [.. Points(m).Select(p => p.PointA.Y).Order()];
        Assert.Equal(shift - 1, heights[0], 1e-6f);
        Assert.Equal(1, heights[1], 1e-6f);
        Assert.All(Points(m), p => Assert.Equal(-Depth, p.Gap, 1e-6f));
    }

    /// <summary>A cylinder of 64 sides, turned in float: its cap is flat to within rounding.</summary>
    [Theory]
    [InlineData(1e-3f)]
    [InlineData(1)]
    [InlineData(1e4f)]
    public void ARoundMeshStandsOnFourCornersOfItsRim(float size)
    {
        var mesh = ConvexShape.Mesh(Prism(64, size));
        var pose = new RigidPose(
            Quaternion.CreateFromAxisAngle(Vector3.UnitZ, -1), new Vector3(0.1f, 0.999f, 0.2f) * size);
        ContactManifold m = Ask(
            ConvexShape.Box(new Vector3(10 * size, size, 10 * size)), new RigidPose(new Vector3(0, -size, 0)), mesh,
            pose, 0.01f * size);
        Assert.Equal(4, m.Count);
        Assert.All(Points(m), p => Assert.Equal(-size * 1e-3f, p.Gap, 2e-6f * size));
        Assert.InRange(Area(m), 1.9f * size * size, 2.1f * size * size);
    }

    [Theory]
    [InlineData("cylinder")]
    [InlineData("cone")]
    public void ACapStandsOnItsRim(string name)
    {
        ConvexShape shape = name == "cone" ? ConvexShape.Cone(1, 2) : ConvexShape.Cylinder(1, 2);
        ContactManifold m = OnSlab(shape, new RigidPose(new Vector3(0, 2 - Depth, 0)));
        Assert.Equal(4, m.Count);
        Assert.Equal(2, Area(m), 1e-4f);

        // Tilted, its deepest point lies between the corners that it is shown by.
        Quaternion tilt = Quaternion.CreateFromAxisAngle(Vector3.Normalize(new Vector3(0.3f, 0, 1)), 0.02f);
        m = OnSlab(shape, Lowered(shape, tilt));
        Assert.Equal(-Depth, Points(m).Min(p => p.Gap), 1e-6f);
        Assert.Equal(4, m.Count);
    }

    [Fact]
    public void ACylinderAndAConeLieOnALine()
    {
        var cylinder = ConvexShape.Cylinder(1, 2);
        AssertPlaces(OnSlab(cylinder, Lowered(cylinder, OnItsSide)), (2, 0), (-2, 0));
        var cone = ConvexShape.Cone(3, 2);
        var lying = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2 + MathF.Atan(3f / 4));
        ContactManifold m = OnSlab(cone, Lowered(cone, lying));
        Assert.Equal(2, m.Count);
        Assert.Equal(5, Vector3.Distance(m[0].PointA, m[1].PointA), 1e-5f);
    }

    /// <summary>The side of a tapered capsule ends where it touches its balls, 4 apart here; on a ball it stands on one
    /// point.</summary>
    [Theory]
    [InlineData(1, 4)]
    [InlineData(4, 1)]
    [InlineData(0, 3)]
    public void ATaperedCapsuleLiesOnALineAndStandsOnAPoint(float top, float bottom)
    {
        ConvexShape shape = ConvexShape.TaperedCapsule(top, bottom, 2.5f);
        var lying = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2 - MathF.Asin((top - bottom) / 5));
        ContactManifold m = OnSlab(shape, Lowered(shape, lying));
        Assert.Equal(2, m.Count);
        Assert.Equal(4, Vector3.Distance(m[0].PointA, m[1].PointA), 1e-5f);
        Assert.All(Points(m), p => Assert.Equal(-Depth, p.Gap, 1e-6f));
        foreach (float tilt in new[] { 0, 0.3f, -0.3f, MathF.PI })
        {
            var standing = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, tilt);
            m = OnSlab(shape, Lowered(shape, standing));
            Assert.Equal(1, m.Count);
            Assert.Equal(-Depth, m[0].Gap, 1e-6f);
        }
    }

    /// <summary>What shows no face has one point, and so has what is too far away none.</summary>
    [Fact]
    public void RoundShapesTouchInOnePointAndDistantOnesInNone()
    {
        var ball = ConvexShape.Sphere(1);
        ContactManifold m = OnSlab(ball, new RigidPose(new Vector3(2, 1 - Depth, 3)));
        AssertPlaces(m, (2, 3));
        Assert.Equal(0, m[0].FeatureId);
        Assert.Equal(-Depth, m[0].Gap, 1e-6f);
        Assert.Equal(0, OnSlab(ball, new RigidPose(new Vector3(0, 1.1f, 0))).Count);
        Assert.Equal(0, Ask(default, SlabPose, ball, RigidPose.Identity).Count);
        Assert.Equal(1, OnSlab(ball, new RigidPose(new Vector3(0, 0.99f, 0)), -1).Count);
    }

    [Fact]
    public void AGapThatIsNoNumberIsInvalidInput()
    {
        var ball = ConvexShape.Sphere(1);
        var warm = default(WarmStart);
        DistanceResult[] answers =
        [
            ConvexQuery.Contacts(Slab, SlabPose, ball, RigidPose.Identity, float.NaN, out ContactManifold cold),
            ConvexQuery.Contacts(
                Slab, SlabPose, ball, RigidPose.Identity, ref warm, float.NaN, out ContactManifold warmed),
        ];
        Assert.All(answers, answer => Assert.Equal(GjkStatus.InvalidInput, answer.Status));
        Assert.Equal((0, 0), (cold.Count, warmed.Count));
    }

    /// <summary>A disc, whatever it is called, lies on its rim on both sides.</summary>
    [Fact]
    public void AFlatConeIsADisc()
    {
        var up = new RigidPose(new Vector3(0, 0.001f, 0));
        var down = new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI), new(0, 0.001f, 0));
        foreach (ConvexShape disc in new[] { ConvexShape.Cone(1, 0), ConvexShape.Cylinder(1, 0) })
        {
            Assert.Equal(4, OnSlab(disc, up).Count);
            Assert.Equal(4, OnSlab(disc, down).Count);
        }
    }

    /// <summary>A prism of unit radius and half height, its axis turned in float.</summary>
    private static Vector3[] Prism(int sides, float size) => Array.ConvertAll(
        Clouds.Prism(sides, size, size),
        p => Vector3.Transform(p, Quaternion.CreateFromAxisAngle(Vector3.UnitZ, 1)));
}
