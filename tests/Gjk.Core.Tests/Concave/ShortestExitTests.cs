namespace Gjk.Core.Tests.Concave;

/// <summary>A convex body whose middle is in a solid leaves it by the shortest of the ways across its faces' planes
/// that lead out.</summary>
public class ShortestExitTests
{
    /// <summary>World units: what is so far out is out, in spite of rounding.</summary>
    private const float Slack = 1e-4f;

    private readonly ConcaveScratch _scratch = new();

    [Fact]
    public void TheFaceFarFromTheMiddleMayBeTheNearestOne()
    {
        var solid = AnyShape.Solid(ConcaveShapes.Box(new Vector3(0.6868645f, 0.53999335f, 1.6926337f)));
        var body = ConvexShape.Box(new Vector3(0.6f, 0.5f, 0.4f) * 0.28083283f);
        var pose = new RigidPose(
            new Quaternion(0.0798277f, -0.2660921f, 0.0056694f, 0.9606198f),
            new Vector3(0.0499274f, -0.0716841f, 0.071885f));
        CastResult start = Start(body, pose, solid);
        Assert.True((start.Normal - Vector3.UnitY).Length() < 1e-6f, $"{start}");
        Assert.Equal(0.630f, start.Depth, 1e-3f);
    }

    /// <summary>The plane of the other arm's end is nearer, but does not lead out.</summary>
    [Fact]
    public void BesideAReflexEdgeTheWayLeadsOut()
    {
        var ball = ConvexShape.Sphere(0.1f);
        var pose = new RigidPose(new Vector3(-0.3f, 0, -0.3f));
        CastResult start = Start(ball, pose, Outline("L"));
        Assert.Equal(1.1f, start.Depth, 1e-5f);
        Assert.Equal(1, Math.Abs(start.Normal.Y), 1e-6f);
        Assert.False(IsInAfter(start, ball, pose, Outline("L")));
    }

    [Theory]
    [InlineData("box")]
    [InlineData("L")]
    [InlineData("star")]
    [InlineData("gear")]
    [InlineData("ring")]
    public void NoWayAcrossAFaceThatLeadsOutIsShorter(string name)
    {
        AnyShape solid = name == "ring" ? AnyShape.Solid(ConcaveShapes.Torus(24, 16, 1.5f, 0.7f)) : Outline(name);
        AnyShape[] solids =
        [
            solid,
            AnyShape.Solid(solid.Mesh!.Scaled(new Vector3(-1, 1, 1))),
            AnyShape.Of(new CompoundShape([new CompoundPart(solid, RigidPose.Identity)])),
        ];
        var random = new Rng(4702);
        int count = Budget.Whole(400), begun = 0;
        for (int i = 0; i < count; i++)
        {
            AnyShape outer = solids[i % 3];
            ConvexShape body = random.Below(5) switch
            {
                0 => ConvexShape.Sphere(random.Float(0.05, 0.3)),
                1 => ConvexShape.Capsule(random.Float(0.05, 0.15), random.Float(0.05, 0.3)),
                2 => ConvexShape.Box(new Vector3(random.Float(0.05, 0.3), 0.1f, 0.2f)),
                3 => ConvexShape.Cone(random.Float(0.05, 0.2), random.Float(0.05, 0.2)),
                _ => ConvexShape.Mesh([.. Enumerable.Range(0, 14).Select(_ => random.Vector(0.2))]),
            };
            var pose = new RigidPose(random.Rotation(), random.Vector(2) * new Vector3(1, 0.5f, 1));
            var middle = (Vector3)((Double3)pose.Position
                + new RotationD(pose.Rotation).Rotate(body.Center));
            if (!ConcaveQuery.Contains(outer, RigidPose.Identity, middle, _scratch)) continue;
            begun++;
            CastResult start = Start(body, pose, outer);
            string where = $"{name} {i}: {body} at {pose}, {start}";
            Assert.Equal(CastStatus.OverlappingAtStart, start.Status);
            double least = ShortestOf(body, pose, outer, solids[i % 3 % 2].Mesh!, start.Depth - 1e-5);
            Assert.True(least >= start.Depth - 1e-5, $"{where}, but {least} is enough");
            Assert.False(IsInAfter(start, body, pose, outer), where);
        }

        Assert.True(begun > count / 20, $"{begun}");
    }

    /// <summary>The shortest way across the plane of a face that leads out, if it is shorter than a limit.</summary>
    private double ShortestOf(
        in ConvexShape body, in RigidPose pose, in AnyShape solid, TriangleMesh mesh, double limit)
    {
        double best = double.PositiveInfinity;
        for (int i = 0; i < mesh.TriangleCount; i++)
        {
            mesh.GetCorners(i, out Double3 a, out Double3 b, out Double3 c);
            Double3 outward = Double3.Cross(b - a, c - a) * mesh.Mirror;
            outward *= mesh.OutwardOf(i) / outward.Length;
            Double3 back = new RotationD(pose.Rotation).InverseRotate(-outward);
            body.Support(back, out Double3 point);
            double lift = Double3.Dot(outward, a - pose.Position) + Double3.Dot(back, body.Center + point)
                + body.Margin;
            if (!(lift > 0 && lift < Math.Min(best, limit))) continue;
            var moved = new RigidPose(
                pose.Rotation, (Vector3)((Double3)pose.Position + outward * (lift + Slack / 10)));
            if (!ConcaveQuery.Overlaps(solid, RigidPose.Identity, AnyShape.Of(body), moved, _scratch)) best = lift;
        }

        return best;
    }

    private bool IsInAfter(in CastResult start, in ConvexShape body, in RigidPose pose, in AnyShape solid)
    {
        var moved = new RigidPose(pose.Rotation, pose.Position - start.Normal * (start.Depth + Slack));
        return ConcaveQuery.Overlaps(AnyShape.Of(body), moved, solid, RigidPose.Identity, _scratch);
    }

    private CastResult Start(in ConvexShape body, in RigidPose pose, in AnyShape solid) => ConcaveQuery.Cast(
        AnyShape.Of(body), pose, Vector3.Zero, solid, RigidPose.Identity, Vector3.Zero, _scratch).Result;

    /// <summary>A prism of height 2 whose outline is seen whole from a point.</summary>
    private static AnyShape Outline(string name)
    {
        Vector2 seen = name == "L" ? new Vector2(-1) : Vector2.Zero;
        Vector2[] points = name switch
        {
            "box" => [new(-2, -1), new(2, -1), new(2, 1), new(-2, 1)],
            "L" => [new(-2, -2), new(2, -2), new(2, 0), new(0, 0), new(0, 2), new(-2, 2)],
            "star" => Toothed(5, 2, 0.7f, 2),
            _ => Toothed(12, 4, 2, 2.5f),
        };
        int count = points.Length;
        Vector3[] corners =
        [
            .. points.Select(p => new Vector3(p.X, 1, p.Y)), .. points.Select(p => new Vector3(p.X, -1, p.Y)),
            new(seen.X, 1, seen.Y), new(seen.X, -1, seen.Y),
        ];
        var indices = new List<int>();
        for (int i = 0; i < count; i++)
        {
            int k = (i + 1) % count;
            indices.AddRange([2 * count, k, i, 2 * count + 1, count + i, count + k]);
            indices.AddRange([i, k, count + k, i, count + k, count + i]);
        }

        return AnyShape.Solid(new TriangleMesh(corners, indices));
    }

    private static Vector2[] Toothed(int teeth, int each, float inner, float outer) =>
        [.. Enumerable.Range(0, teeth * each).Select(i => (i % each < each / 2 ? outer : inner) * new Vector2(
            MathF.Cos(MathF.Tau * i / (teeth * each)), MathF.Sin(MathF.Tau * i / (teeth * each))))];
}
