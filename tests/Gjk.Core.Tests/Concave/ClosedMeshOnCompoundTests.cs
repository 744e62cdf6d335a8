namespace Gjk.Core.Tests.Concave;

/// <summary>A closed mesh on meshes that are children of a compound meets their triangles' faces, as it does those of
/// the meshes alone.</summary>
public class ClosedMeshOnCompoundTests
{
    private static readonly RigidPose s_here = RigidPose.Identity;

    private readonly ConcaveScratch _scratch = new();

    public static TheoryData<string, float> Depths
    {
        get
        {
            var data = new TheoryData<string, float>();
            foreach (string floor in new[] { "field", "solid field", "box", "field and ball", "two fields" })
                foreach (float depth in new[] { 0.01f, 0.03f, 0.04f, 0.06f, 0.08f }) data.Add(floor, depth);
            return data;
        }
    }

    /// <summary>Deeper than its bevel, where the shortest ways out of pairs of triangles lead aside.</summary>
    [Theory]
    [MemberData(nameof(Depths))]
    public void ABevelledCubeIsPushedStraightUp(string floor, float depth)
    {
        var at = new RigidPose(new Vector3(0.2f, 0.5f - depth, 0.3f));
        List<PairContacts> contacts = [];
        Assert.True(ConcaveQuery.FindContacts(Floor(floor), s_here, Bevelled(0.5f), at, 0.01f, _scratch, contacts));
        Assert.All(contacts, one => Assert.True(one.Manifold.Normal.Y > 0.999f, one.ToString()));
        Assert.Equal(-depth, contacts.Min(one => one.Result.Distance), 1e-5f);
        Vector3[] feet = [.. contacts.Select(one => one.Manifold[0].PointA)];
        Assert.True(feet.Min(foot => foot.X) < 0 && feet.Max(foot => foot.X) > 0.4f, string.Join(" ", feet));
        Assert.True(feet.Min(foot => foot.Z) < 0.1f && feet.Max(foot => foot.Z) > 0.5f, string.Join(" ", feet));
    }

    /// <summary>Deeper than the gap and than its bevel, and not quite level: the corners of its bottom are in no
    /// triangle that meets the floor's, and it stands on them all the same.</summary>
    [Theory]
    [InlineData(1e-6f)]
    [InlineData(1e-4f)]
    [InlineData(1e-3f)]
    [InlineData(5e-3f)]
    public void ATiltedCubeStandsOnFourCorners(float tilt)
    {
        foreach (string floor in new[] { "alone", "scene", "field", "solid field", "box", "two fields" })
        {
            for (int i = 0; i < 8; i++)
            {
                var rng = new Rng((ulong)i);
                Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitX, tilt)
                    * Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(0, 6));
                float depth = rng.Float(0.02f, 0.1f);
                var at = new RigidPose(turn, new Vector3(rng.Float(-1, 1), 0.5f - depth, rng.Float(-1, 1)));
                List<PairContacts> contacts = Contacts(floor, Bevelled(0.5f), at);
                string what = $"{floor}, {i}: {string.Join("\n", contacts)}";
                Assert.True(contacts.All(one => one.Manifold.Normal.Y > 0.999f), what);
                foreach ((int x, int z) in new[] { (1, 1), (1, -1), (-1, 1), (-1, -1) })
                {
                    Vector3 corner = Vector3.Transform(new Vector3(0.45f * x, 0, 0.45f * z), at.Rotation);
                    float most = contacts.Max(one => Furthest(one, corner, at.Position));
                    Assert.True(most > 0.8f * corner.LengthSquared(), $"{corner}, {what}");
                }
            }
        }

        static float Furthest(PairContacts one, Vector3 way, Vector3 middle) => Enumerable
            .Range(0, one.Manifold.Count).Max(i => Vector3.Dot(one.Manifold[i].PointB - middle, way));
    }

    /// <summary>On a bevelled cube that stands still: a pair whose own way leads along no face is not pushed along that
    /// by what the mesh climbs to. Along a bevel's face, at half a right angle, a box is deeper by a root of 2 at
    /// most.</summary>
    [Theory]
    [InlineData(0.001f)]
    [InlineData(0.005f)]
    [InlineData(0.02f)]
    public void ABoxOnABevelledCubeIsNoDeeperThanItStands(float depth)
    {
        AnyShape crate = Bevelled(0.5f);
        foreach (ConvexShape body in new[] { ConvexShape.Box(new Vector3(0.5f)), ConvexShape.Cylinder(0.4f, 0.5f) })
        {
            for (int i = 0; i < Budget.Count(100); i++)
            {
                var rng = new Rng((ulong)i);
                var at = new RigidPose(
                    Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(0, 6)),
                    new Vector3(rng.Float(-0.2, 0.2), 1 - depth, rng.Float(-0.2, 0.2)));
                List<PairContacts> contacts = [];
                Assert.True(ConcaveQuery.FindContacts(crate, s_here, AnyShape.Of(body), at, 0.01f, _scratch, contacts));
                Assert.All(contacts, one => Assert.True(one.Result.Distance > -1.42f * depth, $"{i}: {one}"));
                Assert.Equal(-depth, contacts.Where(one => one.Manifold.Normal.Y > 0.999f).Min(Deepest), 1e-5f);
            }
        }

        static float Deepest(PairContacts one) => one.Result.Distance;
    }

    private List<PairContacts> Contacts(string floor, in AnyShape body, in RigidPose at)
    {
        const float Gap = 0.01f;
        List<PairContacts> contacts = [];
        if (floor == "scene")
        {
            var scene = new CollisionScene();
            foreach ((int x, int z) in new[] { (1, 1), (1, -1), (-1, 1), (-1, -1) })
            {
                AnyShape tile = AnyShape.Solid(ConcaveShapes.Box(new Vector3(1, 0.5f, 1)));
                scene.Add(tile, new RigidPose(new Vector3(x, -0.5f, z)), new ObjectSettings(isStatic: true));
            }

            scene.Add(body, at);
            scene.FindContacts(Gap, contacts);
            return contacts;
        }

        AnyShape ground = floor == "alone" ? Solids.FlatField(5, 1, isSolid: false) : Floor(floor);
        RigidPose pose = floor == "alone" ? new RigidPose(new Vector3(-2, 0, -2)) : s_here;
        Assert.True(ConcaveQuery.FindContacts(ground, pose, body, at, Gap, _scratch, contacts));
        return contacts;
    }

    [Theory]
    [MemberData(nameof(Depths))]
    public void ItsWayOutOfTheFloorIsUp(string floor, float depth)
    {
        foreach (AnyShape body in new[] { Bevelled(0.5f), AnyShape.Solid(ConcaveShapes.Box(new Vector3(0.5f))) })
        {
            var turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, 1.2f + depth);
            var at = new RigidPose(turn, new Vector3(0.2f, 0.5f - depth, 0.3f));
            CastHit hit = ConcaveQuery.Cast(Floor(floor), s_here, default, body, at, default, _scratch);
            Assert.Equal(CastStatus.OverlappingAtStart, hit.Status);
            Assert.True(hit.Result.Normal.Y > 0.999f && Math.Abs(hit.Result.Depth - depth) < 1e-4f, $"{body}: {hit}");
        }
    }

    /// <summary>A body above a floor is not under it, however large the gap: its far side does not face the
    /// floor.</summary>
    [Theory]
    [InlineData(0.9f)]
    [InlineData(4)]
    [InlineData(float.PositiveInfinity)]
    public void ABodyThatIsApartIsNotHeldDown(float maxGap)
    {
        AnyShape[] floors = [Solids.FlatField(5, 1, isSolid: false), Solids.FlatField(5, 1, isSolid: true)];
        foreach (AnyShape floor in floors)
        {
            var at = new RigidPose(new Vector3(2.1f, 0.405f, 2.2f));
            AnyShape body = AnyShape.Solid(ConcaveShapes.Box(new Vector3(0.4f)));
            List<PairContacts> contacts = [];
            Assert.True(ConcaveQuery.FindContacts(floor, s_here, body, at, maxGap, _scratch, contacts));
            Assert.NotEmpty(contacts);
            Assert.All(contacts, one => Assert.True(one.Result.Distance > 0.004f, one.ToString()));
        }
    }

    /// <summary>What touches a wall at the start, and stands on a floor or in it, is stopped by the wall: the way out
    /// of the wall's solid is not over its top.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(0.9995f)]
    public void AWallThatIsTouchedStopsWhatStandsBesideIt(float height)
    {
        AnyShape stair = AnyShape.Of(new CompoundShape(
        [
            new(AnyShape.Solid(ConcaveShapes.Box(new Vector3(2, 6, 4))), new RigidPose(new Vector3(-2, -6, 0))),
            new(AnyShape.Solid(ConcaveShapes.Box(new Vector3(1, 6, 4))), new RigidPose(new Vector3(1, -5.25f, 0))),
        ]));
        ConvexShape[] bodies = [ConvexShape.Capsule(0.4f, 0.6f), ConvexShape.Box(new Vector3(0.4f, 1, 0.4f))];
        foreach (ConvexShape body in bodies)
        {
            var at = new RigidPose(new Vector3(-0.4f, height, -0.83f));
            CastHit hit = ConcaveQuery.Cast(
                stair, s_here, default, AnyShape.Of(body), at, new Vector3(0.0445f, 0, 0.0228f), _scratch, 1,
                CastOptions.OnlyDeeper(1e-3f));
            Assert.True(hit.IsHit && hit.Result.Normal.X < -0.999f, $"{body}: {hit}");
        }
    }

    private static AnyShape Floor(string name)
    {
        var at = new RigidPose(new Vector3(-2, 0, -2));
        var field = new CompoundPart(Solids.FlatField(5, 1, isSolid: false), at);
        return AnyShape.Of(new CompoundShape(name switch
        {
            "field" => [field],
            "solid field" => [new(Solids.FlatField(5, 1, isSolid: true), at)],
            "box" => [new(AnyShape.Solid(ConcaveShapes.Box(new Vector3(2, 0.5f, 2))), new(new Vector3(0, -0.5f, 0)))],
            "field and ball" => [field, new(ConvexShape.Sphere(0.1f), new RigidPose(new Vector3(50)))],
            _ => [field, new(Solids.FlatField(5, 1, isSolid: false), new RigidPose(new Vector3(2, 0, -2)))],
        }));
    }

    /// <summary>A cube without its edges and corners, of the half extent; the bevel is a tenth of that.</summary>
    private static AnyShape Bevelled(float half)
    {
        var points = new List<Vector3>();
        for (int i = 0; i < 24; i++)
        {
            var sign = new Vector3((i & 1) == 0 ? -1 : 1, (i & 2) == 0 ? -1 : 1, (i & 4) == 0 ? -1 : 1);
            var reach = new Vector3(0.9f * half);
            reach[i / 8] = half;
            points.Add(sign * reach);
        }

        var hull = new ConvexHull(points);
        var triangles = new List<int>();
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            triangles.AddRange([a, b, c]);
        }

        IEnumerable<Vector3> corners = Enumerable.Range(0, hull.VertexCount).Select(hull.GetVertex);
        return AnyShape.Solid(new TriangleMesh([.. corners], triangles));
    }
}
