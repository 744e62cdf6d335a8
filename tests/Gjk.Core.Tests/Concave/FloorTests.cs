namespace Gjk.Core.Tests.Concave;

/// <summary>A flat floor pushes straight up, however it is made.</summary>
public class FloorTests
{
    private const float Reach = 0.02f;
    private readonly ConcaveScratch _scratch = new();
    private readonly List<PartContacts> _contacts = [];

    [Theory]
    [InlineData("plain")]
    [InlineData("doubled")]
    [InlineData("two-sided")]
    [InlineData("slivers of 1e-7")]
    [InlineData("slivers of 1e-6")]
    [InlineData("filled T-junctions")]
    [InlineData("turned filled T-junctions")]
    [InlineData("tiles")]
    [InlineData("tiles with steps of 1e-6")]
    [InlineData("joined boxes")]
    public void AFlatFloorPushesStraightUp(string name)
    {
        AnyShape floor = Floors.Named(name);
        var random = new FuzzRandom(3);
        for (int i = 0; i < 300; i++)
        {
            AnyShape body = Body(i);
            Quaternion yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, i % 2 == 0 ? 0 : random.Float(0, 6));
            var over = new Vector3(
                i % 3 == 0 ? 1.5f : random.Float(0.7, 2.3), 0, i % 4 == 0 ? 1.5f : random.Float(0.7, 2.3));
            RigidPose at = SeamBodies.Placed(body, over, yaw, -0.001f - i / 7 % 3 * 0.004f);
            Assert.True(ConcaveQuery.FindContacts(floor, RigidPose.Identity, body, at, Reach, _scratch, _contacts));
            Assert.True(_contacts.Exists(one => one.Result.Distance < 0), $"{i}: contact lost");
            foreach (PartContacts one in _contacts)
                Assert.True(one.Manifold.Normal.Y > 0.9999f, $"{i}: {one}");
        }
    }

    /// <summary>A fin that stands on a floor is a third triangle at a seam: from the side it pushes sideways, and over
    /// its end as well, which a floor below does not change.</summary>
    [Fact]
    public void AnEdgeOfThreeTrianglesStays()
    {
        Vector3[] points = [new(-2, 0, -2), new(-2, 0, 2), new(0, 0, 2), new(0, 0, -2), new(2, 0, 2), new(2, 0, -2),
            new(0, -1, -2), new(0, -1, 2)];
        AnyShape roof = AnyShape.Surface(new TriangleMesh(
            [.. points.Select(p => p - new Vector3(0, 0.5f * Math.Abs(p.X), 0))],
            [0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5, 6, 7, 2, 6, 2, 3]));
        AnyShape ball = SeamBodies.Named("ball");
        var at = new RigidPose(new Vector3(0.001f, 0.295f, 0));
        ConcaveQuery.FindContacts(roof, RigidPose.Identity, ball, at, Reach, _scratch, _contacts);
        Assert.True(_contacts.Exists(one => one.Manifold.Normal.Y > 0.999f), string.Join("; ", _contacts));
    }

    /// <summary>Each triangle of a fan without area is joined to all others; looked through without a bound, each would
    /// double the work.</summary>
    [Fact]
    public void AFanOfTrianglesWithoutAreaEnds()
    {
        var points = new Vector3[60];
        var indices = new List<int>();
        for (int i = 0; i < points.Length; i++) points[i] = new Vector3(i / 60f, 0, 0);
        for (int i = 1; i < points.Length; i++)
            for (int k = i + 1; k < points.Length; k += 7) indices.AddRange([0, i, k]);
        points[^1] = new Vector3(0.5f, 0, 1);
        AnyShape fan = AnyShape.Surface(new TriangleMesh(points, [.. indices, 0, 58, 59])), box = Body(1);
        var at = new RigidPose(new Vector3(0.5f, 0.1f, 0.2f));
        Assert.True(ConcaveQuery.FindContacts(fan, RigidPose.Identity, box, at, Reach, _scratch, _contacts));
        Assert.NotEmpty(_contacts);
    }

    private static AnyShape Body(int i) => AnyShape.Of((i % 5) switch
    {
        0 => ConvexShape.Sphere(0.25f),
        1 => ConvexShape.Box(new Vector3(0.2f, 0.15f, 0.3f)),
        2 => ConvexShape.Cylinder(0.2f, 0.15f),
        3 => ConvexShape.Capsule(0.1f, 0.3f).Placed(
            new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2), Vector3.Zero)),
        _ => ConvexShape.Box(new Vector3(0.05f, 0.15f, 0.05f)),
    });
}
