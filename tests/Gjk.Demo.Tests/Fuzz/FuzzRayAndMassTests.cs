using Gjk.Exact.Fuzz;
using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Demo.Tests.Fuzz;

/// <summary>The judges of rays and masses take the library's answers and no answers of other shapes.</summary>
public class FuzzRayAndMassTests
{
    private static readonly RigidPose There =
        new(Quaternion.Normalize(new Quaternion(0.1f, -0.2f, 0.3f, 0.9f)), new Vector3(-3, 0.25f, 0.5f));

    private static readonly Vector3[] Corners =
        [new(1, 0.2f, 0), new(-0.5f, 1, 0.1f), new(-0.4f, -0.9f, 0.3f), new(0.1f, 0, 1), new(0, 0.1f, -1)];

    public static TheoryData<string> Kinds => ["box", "sphere", "hull", "cone", "capsule"];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void RaysOfAShapeElsewhereAreNoticed(string kind)
    {
        ConvexShape shape = Shape(kind);
        FuzzPair pair = Pair(shape);
        Vector3 origin = pair.PoseB.Position, direction = pair.Motion.B;
        RayCastResult enter = ConvexQuery.RayCast(shape, pair.PoseA, origin, direction);
        RayCastResult leave = ConvexQuery.RayExit(shape, pair.PoseA, origin, direction);
        Assert.Equal((CastStatus.Hit, CastStatus.Hit), (enter.Status, leave.Status));
        Assert.Null(Problem(enter, leave));
        Assert.NotNull(Problem(leave, enter));
        Assert.NotNull(Problem(default, leave));
        foreach (float by in new[] { -1e-3f, 1e-3f })
        {
            var other = new RigidPose(new Vector3(by, 0, 0));
            Assert.NotNull(Problem(ConvexQuery.RayCast(shape, other, origin, direction), leave));
            Assert.NotNull(Problem(enter, ConvexQuery.RayExit(shape, other, origin, direction)));
        }

        RayCastResult missed = ConvexQuery.RayCast(shape, pair.PoseA, origin, -direction);
        Assert.NotNull(Problem(missed, missed));

        string? Problem(in RayCastResult one, in RayCastResult two) =>
            RaysEnterAndLeave.Problem(pair, origin, direction, one, two);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void MassesOfAnotherShapeAreNoticed(string kind)
    {
        ConvexShape shape = Shape(kind);
        FuzzPair pair = Pair(shape);
        MassProperties mass = shape.GetMassProperties(), placed = shape.Placed(There).GetMassProperties();
        Assert.Null(MassIsOfTheShape.Problem(pair, mass, placed));
        Assert.NotNull(MassIsOfTheShape.Problem(pair, mass, mass));
        Assert.NotNull(MassIsOfTheShape.Problem(pair, shape.Rounded(0.01f).GetMassProperties(), placed));
        Assert.NotNull(MassIsOfTheShape.Problem(pair, placed, placed));
    }

    [Fact]
    public void AHullThatLacksACornerIsNoticed()
    {
        ConvexShape less = ConvexShape.Mesh(Corners[1..]);
        Assert.NotNull(MassIsOfTheShape.Problem(
            Pair(Shape("hull")), less.GetMassProperties(), less.Placed(There).GetMassProperties()));
    }

    private static ConvexShape Shape(string kind) => kind switch
    {
        "box" => ConvexShape.Box(new Vector3(0.5f, 1, 0.75f)),
        "sphere" => ConvexShape.Sphere(0.8f),
        "hull" => ConvexShape.Mesh(Corners),
        "cone" => ConvexShape.Cone(0.7f, 1),
        _ => ConvexShape.Capsule(0.5f, 0.7f),
    };

    private static FuzzPair Pair(in ConvexShape shape) =>
        new FuzzPair(shape, RigidPose.Identity, ConvexShape.Point(), There)
            .Moving(new PairMotion(default, new Vector3(6, -0.5f, -0.75f)));
}
