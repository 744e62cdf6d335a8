namespace Gjk.Core.Tests.Concave;

/// <summary>Back faces and hollow shapes, in every verb for rays: closed forms by hand, all triangles asked in turn,
/// and what the verbs say without them.</summary>
public class RaySidesTests
{
    private const RaySides FromOutside = RaySides.FrontOnly | RaySides.Hollow;
    private static readonly RigidPose Here = RigidPose.Identity;
    private readonly ConcaveScratch _scratch = new();
    private readonly List<RayHit> _hits = [];

    /// <summary>Those that rays meet.</summary>
    public static TheoryData<string> Kinds =>
    [
        .. Generators.AllKinds.Concat(Generators.LaterKinds).Except(["point", "segment", "needle"]), "bigHull", "made",
    ];

    [Theory]
    [InlineData(0.25f, RaySides.Both, CastStatus.OverlappingAtStart, 0)]
    [InlineData(0.25f, RaySides.FrontOnly, CastStatus.OverlappingAtStart, 0)]
    [InlineData(0.25f, RaySides.Hollow, CastStatus.Hit, 1.75f)]
    [InlineData(0.25f, FromOutside, CastStatus.Miss, 100)]
    [InlineData(-5, RaySides.Hollow, CastStatus.Hit, 3)]
    [InlineData(-5, FromOutside, CastStatus.Hit, 3)]
    [InlineData(-2, RaySides.Hollow, CastStatus.Hit, 0)]
    [InlineData(-2, FromOutside, CastStatus.Hit, 0)]
    [InlineData(2, RaySides.Hollow, CastStatus.Miss, 100)]
    [InlineData(5, RaySides.Hollow, CastStatus.Miss, 100)]
    public void ABallAndABoxByHand(float x, RaySides sides, CastStatus status, float distance)
    {
        foreach (ConvexShape shape in new[] { ConvexShape.Sphere(2), ConvexShape.Box(new Vector3(2)) })
        {
            RayCastResult r = ConvexQuery.RayCast(
                shape, Here, new Vector3(x, 0, 0), 3 * Vector3.UnitX, 100, sides: sides);
            Assert.Equal((status, distance), (r.Status, r.Distance));
            Assert.Equal(status == CastStatus.Hit && x > -2, r.IsBackFace);
            if (r.IsBackFace) Assert.Equal((Vector3.UnitX, 2 * Vector3.UnitX), (r.Normal, r.Point));
        }
    }

    [Fact]
    public void AHalfSpaceIsLeftOnceAndARayThatEndsInsideLeavesNothing()
    {
        ConvexShape below = ConvexShape.HalfSpace(Vector3.UnitY, 1);
        RayCastResult up = ConvexQuery.RayCast(below, Here, default, Vector3.UnitY, sides: RaySides.Hollow);
        Assert.Equal((CastStatus.Hit, 1f, true), (up.Status, up.Distance, up.IsBackFace));
        Assert.Equal(CastStatus.Miss, Down(below, float.PositiveInfinity));
        Assert.Equal(CastStatus.Miss, Down(ConvexShape.Sphere(2), 1.9999f));
        Assert.Equal(CastStatus.Miss, Down(ConvexShape.Sphere(2), 0));
        Assert.Equal(CastStatus.Hit, Down(ConvexShape.Sphere(2), 2));

        static CastStatus Down(ConvexShape shape, float most) =>
            ConvexQuery.RayCast(shape, Here, default, -Vector3.UnitY, most, sides: RaySides.Hollow).Status;
    }

    /// <summary>From outside nothing changes; from inside a hollow shape gives the way out, in all verbs.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void AHollowShapeGivesItsExit(string kind)
    {
        int inside = 0;
        for (int i = 0; i < Budget.Count(120); i++)
        {
            var rng = new Rng((ulong)i);
            ConvexShape shape = Generators.Shape(rng, kind).Shape;
            RigidPose pose = Generators.Pose(rng, rng.Vector(-2, 2));
            float size = (float)(shape.BoundingRadius + shape.Margin);
            var center = (Vector3)(new RotationD(pose.Rotation).Rotate(shape.Center) + pose.Position);
            Vector3 origin = center + rng.UnitVector() * (size * rng.Float(0, 1));
            var ray = new RayQuery(origin, rng.UnitVector(), i % 3 == 0 ? size : float.PositiveInfinity);
            RayCastResult solid = Ask(shape, pose, ray, RaySides.Both);
            RayCastResult exit = ConvexQuery.RayExit(shape, pose, origin, ray.Direction, ray.MaxDistance);
            bool isIn = solid.Status == CastStatus.OverlappingAtStart;
            inside += isIn ? 1 : 0;
            AreSame(solid, Ask(shape, pose, ray, RaySides.FrontOnly), $"{i}: front");
            AreSame(isIn ? exit : solid, Ask(shape, pose, ray, RaySides.Hollow), $"{i}: hollow");
            RayCastResult front = Ask(shape, pose, ray, FromOutside);
            if (isIn) Assert.Equal((CastStatus.Miss, ray.MaxDistance), (front.Status, front.Distance));
            else AreSame(solid, front, $"{i}: from outside");

            Assert.True(ConcaveQuery.RayCrossings(
                AnyShape.Of(shape), pose, origin, ray.Direction, _scratch, _hits, ray.MaxDistance));
            bool isThrough = solid.Status == CastStatus.Hit && exit.Distance > solid.Distance;
            bool isOut = exit.Status == CastStatus.Hit;
            if (float.IsInfinity(ray.MaxDistance)) Assert.Equal(isIn, _hits.Count % 2 == 1);
            if (isIn) Assert.Equal(isOut ? 1 : 0, _hits.Count);
            else if (isOut) Assert.Equal(isThrough ? 2 : 0, _hits.Count);
            if (isOut && _hits.Count > 0) Assert.Equal((exit.Distance, true), Last());
        }

        Assert.InRange(inside, kind is "triangle" or "flat" or "plate" ? 0 : 5, Budget.Count(120));

        (float, bool) Last() => (_hits[^1].Distance, _hits[^1].Result.IsBackFace);
    }

    [Theory]
    [InlineData("ring", 1)]
    [InlineData("rock", 1)]
    [InlineData("gear", -1)]
    [InlineData("ring", -2)]
    public void BackFacesOfASurfaceArePassedOrSaid(string name, float mirror)
    {
        int backs = 0, passed = 0;
        TriangleMesh mesh = Solids.Named(name, 3).Scaled(new Vector3(mirror, 1, 1));
        AnyShape surface = AnyShape.Surface(mesh);
        for (ulong seed = 1; seed <= 400; seed++)
        {
            var random = new Rng(seed);
            var pose = new RigidPose(random.Rotation(), random.Vector(1));
            Aim(mesh, pose, random, out Vector3 origin, out Vector3 direction);
            string message = $"{name}, seed {seed}";
            RayHit both = ConcaveQuery.RayCast(surface, pose, origin, direction, _scratch);
            RayHit front = ConcaveQuery.RayCast(
                surface, pose, origin, direction, _scratch, sides: RaySides.FrontOnly);
            Assert.Equal(Nearest(mesh, pose, origin, direction, false, out bool isBack), both.Distance);
            Assert.Equal(Nearest(mesh, pose, origin, direction, true, out _), front.Distance);
            Assert.True(both.Result.IsBackFace == isBack, message);
            Assert.False(front.Result.IsBackFace);
            if (both.IsHit) Assert.True(Vector3.Dot(both.Result.Normal, direction) <= 0, message);
            backs += isBack ? 1 : 0;
            passed += isBack && front.IsHit ? 1 : 0;
            ListAgrees(surface, pose, new RayQuery(origin, direction), front, message);
        }

        Assert.True(backs > 50 && (name == "rock" || passed > 5), $"{backs} backs, {passed} passed");
    }

    private void ListAgrees(AnyShape surface, in RigidPose pose, RayQuery ray, RayHit front, string message)
    {
        Assert.True(ConcaveQuery.RayCastAll(
            surface, pose, ray.Origin, ray.Direction, _scratch, _hits, sides: RaySides.FrontOnly));
        int fronts = _hits.Count;
        Assert.True(ConcaveQuery.RayCastAll(surface, pose, ray.Origin, ray.Direction, _scratch, _hits));
        Assert.Equal(fronts, _hits.Count(h => !h.Result.IsBackFace));
        var scene = new CollisionScene();
        scene.Add(surface, pose);
        scene.TryFindRayHit(ray, out RayHit found, sides: RaySides.FrontOnly);
        AreSame(front.Result, found.Result, message);
    }

    /// <summary>Inside out, a closed mesh has its back outside, but for a solid, which knows its inside.</summary>
    [Fact]
    public void ASolidKnowsItsBack()
    {
        TriangleMesh box = Solids.Box(-Vector3.One, Vector3.One), flipped = Solids.Flipped(box);
        Assert.False(First(AnyShape.Surface(box), -3, RaySides.Both).Result.IsBackFace);
        Assert.True(First(AnyShape.Surface(flipped), -3, RaySides.Both).Result.IsBackFace);
        Assert.False(First(AnyShape.Solid(flipped), -3, RaySides.FrontOnly).Result.IsBackFace);
        Assert.Equal(2, First(AnyShape.Surface(box), -3, RaySides.FrontOnly).Distance);
        Assert.Equal(4, First(AnyShape.Surface(flipped), -3, RaySides.FrontOnly).Distance);
        Assert.Equal(CastStatus.OverlappingAtStart, First(AnyShape.Solid(box), 0, RaySides.FrontOnly).Status);
        RayHit within = First(AnyShape.Solid(flipped), 0, RaySides.Hollow);
        Assert.Equal((CastStatus.Hit, 1f, true), (within.Status, within.Distance, within.Result.IsBackFace));
        Assert.Equal(CastStatus.Miss, First(AnyShape.Solid(box), 0, FromOutside).Status);
        foreach (RaySides sides in new[] { RaySides.Both, RaySides.FrontOnly, RaySides.Hollow, FromOutside })
        {
            RayHit start = First(AnyShape.Solid(box), -1, sides, 5), end = First(AnyShape.Solid(box), 1, sides, 5);
            Assert.Equal((CastStatus.Hit, 0f), (start.Status, start.Distance));
            Assert.Equal((CastStatus.Miss, 5f), (end.Status, end.Distance));
        }

        Assert.Equal(0, Allocation.Least(() => First(AnyShape.Solid(box), 0, RaySides.Hollow)));
    }

    /// <summary>A hollow solid is met where it is left; without its back faces, where it is entered again.</summary>
    [Theory]
    [InlineData("ring")]
    [InlineData("gear")]
    [InlineData("rock")]
    public void AHollowSolidAgreesWithItsCrossings(string name)
    {
        int inside = 0, again = 0;
        AnyShape solid = AnyShape.Solid(Solids.Named(name, 5));
        for (ulong seed = 1; seed <= 400; seed++)
        {
            var random = new Rng(seed);
            var pose = new RigidPose(random.Rotation(), random.Vector(1));
            Aim(solid.Mesh!, pose, random, out Vector3 origin, out Vector3 direction);
            Assert.True(ConcaveQuery.RayCrossings(solid, pose, origin, direction, _scratch, _hits));
            bool isIn = ConcaveQuery.Contains(solid, pose, origin, _scratch);
            for (int i = 0; i < _hits.Count; i++) Assert.Equal((i % 2 == 0) == isIn, _hits[i].Result.IsBackFace);
            RayHit hollow = ConcaveQuery.RayCast(solid, pose, origin, direction, _scratch, sides: RaySides.Hollow);
            Assert.Equal(_hits.Count > 0 ? _hits[0].Distance : float.PositiveInfinity, hollow.Distance);
            int entry = _hits.FindIndex(h => !h.Result.IsBackFace);
            RayHit front = ConcaveQuery.RayCast(solid, pose, origin, direction, _scratch, sides: FromOutside);
            Assert.Equal(entry >= 0 ? _hits[entry].Distance : float.PositiveInfinity, front.Distance);
            inside += isIn ? 1 : 0;
            again += isIn && front.IsHit ? 1 : 0;
        }

        Assert.True(inside > 50 && (name == "rock" || again > 20), $"{inside} inside, {again} enter again");
    }

    private static RayCastResult Ask(ConvexShape shape, in RigidPose pose, RayQuery ray, RaySides sides)
    {
        RayCastResult result = ConvexQuery.RayCast(
            shape, pose, ray.Origin, ray.Direction, ray.MaxDistance, sides: sides);
        var batch = new RayCastResult[1];
        RayBatch.RayCast(shape, pose, [ray], batch, sides: sides);
        AreSame(result, batch[0], "batch");
        var scene = new CollisionScene();
        scene.Add(shape, pose);
        var first = new RayHit[1];
        var all = new List<RayHit>();
        scene.FindFirstRayHits([ray], first, sides: sides);
        scene.FindRayHits(ray, all, sides: sides);
        Assert.Equal(result.IsHit ? 1 : 0, all.Count);
        if (result.IsHit) AreSame(result, all[0].Result, "all of the scene");
        if (result.IsHit) AreSame(result, first[0].Result, "first of the scene");
        return result;
    }

    private RayHit First(AnyShape shape, float x, RaySides sides, float most = float.PositiveInfinity) =>
        ConcaveQuery.RayCast(
            shape, Here, new Vector3(x, 0.25f, 0.125f), Vector3.UnitX, _scratch, most, sides: sides);

    /// <summary>A ray from near a triangle to near another one, in the world.</summary>
    private static void Aim(
        TriangleMesh mesh, in RigidPose pose, Rng random, out Vector3 origin, out Vector3 direction)
    {
        Vector3 from = Middle(mesh, random.Below(mesh.TriangleCount)) + random.Vector(0.05);
        Vector3 to = Middle(mesh, random.Below(mesh.TriangleCount)) + random.Vector(0.05);
        origin = pose.TransformPoint(from);
        direction = pose.TransformPoint(to) - origin;
    }

    private static Vector3 Middle(TriangleMesh mesh, int triangle)
    {
        mesh.GetTriangle(triangle, out int a, out int b, out int c);
        return mesh.Scale * (mesh.GetVertex(a) + mesh.GetVertex(b) + mesh.GetVertex(c)) / 3;
    }

    /// <summary>Of all triangles the least distance, and on which side.</summary>
    private static float Nearest(
        TriangleMesh mesh, in RigidPose pose, Vector3 origin, Vector3 direction, bool isFrontOnly, out bool isBack)
    {
        float least = float.PositiveInfinity;
        isBack = false;
        Double3 along = new RotationD(pose.Rotation).InverseRotate(direction);
        for (int i = 0; i < mesh.TriangleCount; i++)
        {
            mesh.GetTriangle(i, out int p, out int q, out int r);
            Vector3 a = mesh.GetVertex(p), b = mesh.GetVertex(q), c = mesh.GetVertex(r);

            // Before the scale that mirrors, by which normals are divided.
            Double3 normal = Double3.Cross((Double3)b - a, (Double3)c - a);
            normal = new Double3(normal.X / mesh.Scale.X, normal.Y / mesh.Scale.Y, normal.Z / mesh.Scale.Z);
            ConvexShape triangle = ConvexShape.Triangle(a, b, c).Scaled(mesh.Scale);
            RayCastResult met = ConvexQuery.RayCast(triangle, pose, origin, direction);
            bool isBehind = Double3.Dot(normal, along) > 0;
            if (!met.IsHit || met.Distance >= least || (isFrontOnly && isBehind)) continue;
            (least, isBack) = (met.Distance, isBehind);
        }

        return least;
    }

    private static void AreSame(in RayCastResult a, in RayCastResult b, string message) =>
        Assert.True(CastBits.AreSame(a, b) && a.IsBackFace == b.IsBackFace, $"{message}: {a}, {b}");
}
