using static Gjk.Core.Tests.Support.Resting;

namespace Gjk.Core.Tests.Contacts;

/// <summary>Contacts whose points can be worked out by hand.</summary>
public class ContactTests
{
    private static readonly Quaternion Tilted = Quaternion.CreateFromYawPitchRoll(0.3f, -0.7f, 1.1f);

    /// <summary>A unit cube by any name.</summary>
    public static TheoryData<string> Cubes => ["box", "mesh", "scaled", "placed", "rounded", "scaledMesh"];

    [Theory]
    [MemberData(nameof(Cubes))]
    public void ABoxOnABoxStandsOnItsFourCorners(string name)
    {
        ContactManifold m = OnSlab(Cube(name), new RigidPose(new Vector3(0.25f, 0.5f - Depth, -0.5f)));
        float half = FlatHalf(name);
        AssertPlaces(
            m, (0.25f + half, -0.5f + half), (0.25f + half, -0.5f - half), (0.25f - half, -0.5f + half),
            (0.25f - half, -0.5f - half));
        Assert.Equal(0, (m.Normal - Vector3.UnitY).Length(), 1e-7f);
        Assert.All(Points(m), p => Assert.Equal(-Depth, p.Gap, 1e-6f));
        Assert.All(Points(m), p => Assert.Equal(0, p.PointA.Y, 1e-6f));
        Assert.All(Points(m), p => Assert.Equal(-Depth, p.PointB.Y, 1e-6f));
        Assert.All(Points(m), p => Assert.Equal(-0.5f, p.LocalPointB.Y, 1e-6f));
    }

    /// <summary>Tilted by 1e-7 it stands on all four; tilted by a degree there are gaps below two of them.</summary>
    [Theory]
    [InlineData("box", 1e-7f)]
    [InlineData("mesh", 1e-7f)]
    [InlineData("box", 0.0174533f)]
    [InlineData("mesh", 0.0174533f)]
    [InlineData("rounded", 0.0174533f)]
    public void ATiltedBoxKeepsItsCorners(string name, float angle)
    {
        ConvexShape cube = Cube(name);
        RigidPose pose = Lowered(cube, Quaternion.CreateFromAxisAngle(Vector3.UnitZ, -angle));
        ContactManifold m = OnSlab(cube, pose);
        Assert.Equal(4, m.Count);
        foreach (ManifoldPoint p in Points(m))
        {
            Assert.Equal(p.PointB.Y, p.Gap, 1e-6f);
            Assert.Equal(0, p.PointA.Y, 1e-6f);
            float rise = MathF.Sin(angle) * 2 * FlatHalf(name) - Margin(name) * (1 / MathF.Cos(angle) - 1);
            Assert.Equal(p.PointB.X > 0 ? -Depth : -Depth + rise, p.Gap, 2e-6f);
        }

        // With less room only the edge that it stands on is left.
        if (angle > 1e-3f) Assert.Equal(2, OnSlab(cube, pose, 0.001f).Count);
    }

    [Fact]
    public void ACubeOnItsEdgeTouchesInTwoPointsAndOnItsCornerInOne()
    {
        var onEdge = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 4);
        Quaternion onCorner = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.Atan(MathF.Sqrt(0.5f)))
            * Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 4);
        foreach (string name in Cubes)
        {
            ConvexShape cube = Cube(name);
            ContactManifold edge = OnSlab(cube, Lowered(cube, onEdge));
            AssertPlaces(edge, (FlatHalf(name), 0), (-FlatHalf(name), 0));
            ContactManifold corner = OnSlab(cube, Lowered(cube, onCorner));
            AssertPlaces(corner, (0, 0));
            Assert.Equal(-Depth, corner[0].Gap, 1e-6f);
        }
    }

    /// <summary>Two edges that cross touch where they cross; parallel ones along their common part.</summary>
    [Theory]
    [MemberData(nameof(Cubes))]
    public void AnEdgeOnAnEdge(string name)
    {
        ConvexShape cube = Cube(name);
        var onEdge = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 4);
        Quaternion across = Quaternion.CreateFromAxisAngle(Vector3.UnitY, 1) * onEdge;
        float height = 2 * Height(cube, onEdge) - Depth;
        ContactManifold m = Ask(
            cube, new RigidPose(onEdge, default), cube, new RigidPose(across, new Vector3(0.125f, height, 0)));
        Assert.Equal(1, m.Count);
        Assert.Equal(-Depth, m[0].Gap, 1e-6f);
        Assert.Equal(0, (m[0].PointA - new Vector3(0.125f, height / 2 + Depth / 2, 0)).Length(), 1e-5f);

        // Pressed into each other, parallel ones would slide off over the faces.
        height += Depth + 0.001f;
        m = Ask(
            cube, new RigidPose(onEdge, default), cube, new RigidPose(onEdge, new Vector3(0.125f, height, 0)), 0.0015f);
        AssertPlaces(m, (FlatHalf(name), 0), (0.125f - FlatHalf(name), 0));
        Assert.All(Points(m), p => Assert.Equal(0.001f, p.Gap, 1e-6f));
    }

    [Fact]
    public void ATriangleLiesFlatAndStandsOnItsEdge()
    {
        var triangle = ConvexShape.Triangle(new(-1, 0, -1), new(1, 0, -1), new(0, 0, 2));
        AssertPlaces(
            OnSlab(triangle, new RigidPose(new Vector3(0, 0.01f, 0))), (-1, -1), (1, -1), (0, 2));
        var upright = Quaternion.CreateFromAxisAngle(Vector3.UnitX, -MathF.PI / 2);
        AssertPlaces(OnSlab(triangle, new RigidPose(upright, new Vector3(0, 1.01f, 0))), (-1, 0), (1, 0));
    }

    /// <summary>Sizes from 1e-25 to 1e25, where the solvers change their unit.</summary>
    [Theory]
    [InlineData(1e-25f)]
    [InlineData(1e25f)]
    public void AnySizeWillDo(float size)
    {
        var cube = ConvexShape.Box(new Vector3(0.5f * size));
        ContactManifold m = Ask(
            ConvexShape.Box(new Vector3(size)), RigidPose.Identity, cube,
            new RigidPose(new Vector3(0, 1.49f * size, 0)), 0.01f * size);
        Assert.Equal(4, m.Count);
        Assert.All(Points(m), p => Assert.Equal(-0.01f, p.Gap / size, 1e-6f));
        Assert.All(Points(m), p => Assert.Equal(0.5f, MathF.Abs(p.PointA.X / size), 1e-6f));
    }

    [Fact]
    public void FarFromTheOriginTheLocalPointsStayExact()
    {
        var far = new Vector3(1e6f, 1e6f, 1e6f);
        ContactManifold m = Ask(
            Slab, new RigidPose(far), Cube("box"), new RigidPose(far + new Vector3(0.25f, 1.5f, 0)));
        Assert.Equal(4, m.Count);
        Assert.All(Points(m), p => Assert.Equal(new Vector3(0.5f, 0.5f, 0.5f), Vector3.Abs(p.LocalPointB)));
    }

    /// <summary>Either side of a flat mesh is all of it.</summary>
    [Theory]
    [InlineData(0.999f)]
    [InlineData(-0.999f)]
    public void AFlatMeshLiesOnAllOfItsCorners(float height)
    {
        ConvexShape plate = ConvexShape.Mesh([new(-1, 0, -1), new(1, 0, -1), new(1, 0, 1), new(-1, 0, 1)]);
        ContactManifold m = Ask(
            plate, RigidPose.Identity, ConvexShape.Box(new Vector3(20, 1, 20)), new RigidPose(new(0, height, 0)));
        AssertPlaces(m, (-1, -1), (1, -1), (1, 1), (-1, 1));
    }

    /// <summary>A strip with two pointed ends: the tips and one corner of each side are not the best four.</summary>
    [Fact]
    public void FourOfManyPointsSpanTheLargestArea()
    {
        float side = 0.58f;
        ConvexShape prism = ConvexShape.Mesh(
            [
                new(-0.82f, side, 0), new(0.82f, side, 0), new(0, side, -0.82f), new(0, side, 0.82f),
                new(-0.82f, -side, 0), new(0.82f, -side, 0), new(0, -side, -0.82f), new(0, -side, 0.82f),
            ]);
        ContactManifold m = Ask(
            ConvexShape.Box(new Vector3(2, 1, 0.1f)), new RigidPose(new Vector3(0, -1, 0)), prism,
            new RigidPose(new Vector3(0, side - 0.01f, 0)));
        Assert.Equal(4, m.Count);
        Assert.Equal(0.2f * 1.44f, Area(m), 1e-3f);
    }

    /// <summary>Parallel edges end to end: where they meet is one point, and nothing is opposite the rest.</summary>
    [Fact]
    public void ParallelEdgesEndToEndMeetInOnePoint()
    {
        ConvexShape a = ConvexShape.Box(new(0.1690487414598465f, 0.71476006507873535f, 0.1690487414598465f));
        ConvexShape b = ConvexShape.Box(new(0.079323932528495789f, 0.98301833868026733f, 0.079323932528495789f));
        var pose = new RigidPose(new(0.257005453f, 1.78474641f, 0.257005453f));
        ContactManifold m = Ask(a.Rounded(0.05f), RigidPose.Identity, b, pose, 0.3f);
        Assert.All(
            Points(m), p => Assert.True(Vector3.Abs(p.LocalPointB).Y <= 0.98301833868026733f * (1 + 1e-5f), $"{p}"));
        ConvexShape segment = ConvexShape.Segment(new(0, 0.5f, 0), new(0, -0.5f, 0));
        m = Ask(
            segment.Rounded(0.08f), new RigidPose(Tilted, default), segment.Rounded(0.2f),
            new RigidPose(Tilted, Vector3.Transform(new(0.1f, 1.05f, 0), Tilted)));
        Assert.Equal(1, m.Count);
    }

    private static ConvexShape Cube(string name) => name switch
    {
        "box" => ConvexShape.Box(new Vector3(0.5f)),
        "mesh" => ConvexShape.Mesh(Clouds.Box(new Vector3(0.5f))),
        "scaled" => ConvexShape.Box(new Vector3(0.25f, 1, 2)).Scaled(new Vector3(-2, 0.5f, 0.25f)),
        "scaledMesh" => ConvexShape.Mesh(Clouds.Box(new Vector3(1))).Scaled(new Vector3(0.5f, -0.5f, 0.5f)),
        "placed" => ConvexShape.Box(new Vector3(0.5f)).Placed(new RigidPose(OnItsSide, default)),
        _ => ConvexShape.Box(new Vector3(0.375f)).Rounded(0.125f),
    };

    private static float Margin(string name) => name == "rounded" ? 0.125f : 0;

    /// <summary>Half the side of a cube's face, without what is round.</summary>
    private static float FlatHalf(string name) => 0.5f - Margin(name);
}
