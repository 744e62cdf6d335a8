namespace Gjk.Core.Tests.Queries.Rays;

/// <summary>What Jolt's own tests expect of rays (UnitTests/Physics/RayShapeTests.cpp): through each shape between two
/// points of its surface, from before, between and beyond them; solid and hollow, with and without back faces, alone
/// and as an object of a scene.</summary>
public class PeerRayTests
{
    private const float Never = float.PositiveInfinity;

    private static readonly RigidPose Body =
        new(Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 4), new Vector3(2, 3, 4));

    private static readonly Vector3[] Corners =
    [
        .. from x in (float[])[-2, 3] from y in (float[])[-4, 5] from z in (float[])[-6, 7] select new Vector3(x, y, z),
    ];

    public static TheoryData<string> Kinds =>
        ["box", "sphere", "hull", "capsule", "tapered", "cylinder", "scaled", "mirrored", "compound", "second"];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void RaysMeetTheSurfaceWhereItIs(string kind)
    {
        (AnyShape shape, (Vector3 A, Vector3 B)[] lines) = Make(kind);
        var scene = new CollisionScene();
        scene.Add(shape, Body);
        foreach ((Vector3 a, Vector3 b) in lines)
        {
            foreach ((Vector3 from, Vector3 to) in new[] { (a, b), (b, a) })
            {
                Vector3 d = to - from, before = from - 0.1f * d, inside = from + 0.1f * d, last = to - 0.1f * d;
                Vector3 beyond = to + 0.1f * d;
                Ask(shape, scene, from - 2 * d, before, Never, Never);
                Ask(shape, scene, before, before, Never, Never);
                Ask(shape, scene, before, inside, 0.5f, Never);
                Ask(shape, scene, before, beyond, 0.1f / 1.2f, 1.1f / 1.2f);
                Ask(shape, scene, last, last, 0, Never);
                Ask(shape, scene, last, beyond, 0, 0.5f);
                Ask(shape, scene, beyond, to + 2 * d, Never, Never);
            }
        }
    }

    [Fact]
    public void RaysPassAHull()
    {
        ConvexShape hull = ConvexShape.Mesh(Corners);
        foreach (float y in new[] { -5f, 0, 6 })
        {
            RayCastResult r =
                ConvexQuery.RayCast(hull, RigidPose.Identity, new Vector3(-3, y, 0), Vector3.UnitY, 1);
            Assert.Equal(CastStatus.Miss, r.Status);
        }
    }

    /// <summary>Fractions of the ray: where it enters, 0 where it begins inside, and where it leaves.</summary>
    private static void Ask(AnyShape shape, CollisionScene scene, Vector3 from, Vector3 to, float enter, float leave)
    {
        // Jolt takes a direction of length 0 as a point; here a point is a ray that reaches no distance.
        float length = (to - from).Length();
        Vector3 direction = length > 0 ? to - from : Vector3.UnitX;
        float first = enter > 0 ? enter : leave;
        foreach ((RaySides sides, float expected) in new[]
            {
                (RaySides.Both, enter), (RaySides.FrontOnly, enter), (RaySides.Hollow, first),
                (RaySides.Hollow | RaySides.FrontOnly, enter > 0 ? enter : Never),
            })
        {
            RayHit r = ConcaveQuery.RayCast(
                shape, RigidPose.Identity, from, direction, new ConcaveScratch(), length, sides: sides);
            Check(r.Status, r.Distance, expected * length);
            var ray = new RayQuery(Body.TransformPoint(from), Vector3.Transform(direction, Body.Rotation), length);
            bool isHit = scene.TryFindRayHit(ray, out RayHit hit, sides: sides);
            Assert.Equal(float.IsFinite(expected), isHit);
            if (isHit) Check(hit.Status, hit.Distance, expected * length);
        }

        if (shape.Kind != AnyShapeKind.Convex) return;
        RayCastResult end = ConvexQuery.RayExit(shape.Convex, RigidPose.Identity, from, direction, length);
        if (enter < Never) Check(end.Status, end.Distance, leave * length);
        else Assert.Equal(CastStatus.Miss, end.Status);
    }

    private static void Check(CastStatus status, float distance, float expected)
    {
        CastStatus right = expected == 0 ? CastStatus.OverlappingAtStart
            : float.IsFinite(expected) ? CastStatus.Hit : CastStatus.Miss;
        Assert.Equal(right, status);
        if (right == CastStatus.Hit) Assert.Equal(expected, distance, expected * 1e-5f);
    }

    private static (AnyShape Shape, (Vector3 A, Vector3 B)[] Lines) Make(string kind)
    {
        if (kind is "compound" or "second") return InCompound(kind == "compound" ? 0 : 1);
        (ConvexShape shape, (Vector3 A, Vector3 B)[] lines) = Convex(kind);
        return (AnyShape.Of(shape), lines);
    }

    private static (ConvexShape Shape, (Vector3 A, Vector3 B)[] Lines) Convex(string kind) => kind switch
    {
        "box" => (ConvexShape.Box(new Vector3(2, 3, 4)), Through(new(-2, -3, -4), new(2, 3, 4))),
        "sphere" => (ConvexShape.Sphere(2), Through(new(-2), new(2))),
        "hull" => (ConvexShape.Mesh(Corners), Through(Corners[0], Corners[7])),
        "capsule" => (ConvexShape.Capsule(2, 4), Through(new(-2, -6, -2), new(2, 6, 2))),
        "tapered" => (ConvexShape.TaperedCapsule(4, 2, 3),
        [
            (new(0, 7, 0), new(0, -5, 0)), (new(-4, 3, 0), new(4, 3, 0)), (new(0, 3, -4), new(0, 3, 4)),
        ]),
        "cylinder" => (ConvexShape.Cylinder(2, 4), Through(new(-2, -4, -2), new(2, 4, 2))),
        "scaled" => (ConvexShape.Mesh(Corners).Scaled(new(2, 3, 4)), Through(new(-4, -12, -24), new(6, 15, 28))),
        _ => (ConvexShape.Mesh(Corners).Scaled(new(-2, 3, 4)), Through(new(-6, -12, -24), new(4, 15, 28))),
    };

    private static (AnyShape Shape, (Vector3 A, Vector3 B)[] Lines) InCompound(int part)
    {
        Quaternion Turned(Vector3 axis, float tenths) => Quaternion.CreateFromAxisAngle(axis, tenths * MathF.PI / 10);
        RigidPose[] poses =
        [
            new(Turned(Vector3.UnitX, 1) * Turned(Vector3.UnitY, 2), new Vector3(10, 20, 30)),
            new(Turned(Vector3.UnitZ, 3), new Vector3(40, 50, 60)),
        ];
        ConvexShape hull = ConvexShape.Mesh(Corners);
        (Vector3 A, Vector3 B)[] lines = Through(Corners[0], Corners[7]);
        return (
            AnyShape.Of(new CompoundShape([new CompoundPart(hull, poses[0]), new CompoundPart(hull, poses[1])])),
            [.. lines.Select(l => (poses[part].TransformPoint(l.A), poses[part].TransformPoint(l.B)))]);
    }

    /// <summary>Along each axis of a box that is given by two corners.</summary>
    private static (Vector3 A, Vector3 B)[] Through(Vector3 low, Vector3 high) =>
    [
        (low * Vector3.UnitX, high * Vector3.UnitX), (low * Vector3.UnitY, high * Vector3.UnitY),
        (low * Vector3.UnitZ, high * Vector3.UnitZ),
    ];
}
