namespace Gjk.Core.Tests.Concave;

/// <summary>Solid meshes rest, slide and tip on a plain solver as the convex bodies do that they are the surfaces
/// of.</summary>
public class RestingSolidTests
{
    private const float DriftPerSecond = 0.005f;

    private static readonly Vector3 Half = new(0.3f, 0.2f, 0.25f);

    private static readonly Vector3 Inertia =
        new Vector3(Half.Y * Half.Y + Half.Z * Half.Z, Half.X * Half.X + Half.Z * Half.Z,
            Half.X * Half.X + Half.Y * Half.Y) / 3;

    public static TheoryData<string> Grounds => new(
        "field", "two-sided", "turned filled T-junctions", "tiles", "block");

    [Theory]
    [MemberData(nameof(Grounds))]
    public void ABoxOfTrianglesRests(string ground)
    {
        for (int i = 0; i < 3; i++)
        {
            StackSolver solver = Made(ground);
            Quaternion yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, 0.4f * i);
            solver.Add(SolidBox(), new RigidPose(yaw, new Vector3(1.5f + 0.1f * i, 0.197f, 1.5f)), 1, Inertia);
            AssertStays(solver, 1);
        }
    }

    [Theory]
    [InlineData(1e-5f)]
    [InlineData(1e-3f)]
    public void AStackOfBoxesOfTrianglesRests(float noise)
    {
        StackSolver solver = Made("field");
        var rng = new Rng(3);
        for (int i = 0; i < 3; i++)
        {
            var at = new Vector3(
                1.5f + rng.Float(-noise, noise), 0.2f + 0.4f * i - 0.004f * (i + 1), 1.5f + rng.Float(-noise, noise));
            Quaternion yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(-noise, noise));
            solver.Add(SolidBox(), new RigidPose(yaw, at), 1, Inertia);
        }

        AssertStays(solver, 3);
    }

    /// <summary>On an edge it falls onto a face, as the convex box does, and both end up as high.</summary>
    [Theory]
    [MemberData(nameof(Grounds))]
    public void ABoxOfTrianglesTipsOver(string ground)
    {
        var lean = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, 0.6f);
        foreach (AnyShape body in new[] { SolidBox(), AnyShape.Of(ConvexShape.Box(Half)) })
        {
            StackSolver solver = Made(ground);
            solver.Add(body, new RigidPose(lean, new Vector3(1.4f, 0.36f, 1.5f)), 1, Inertia);
            for (int frame = 0; frame < 240; frame++) solver.Advance();
            Assert.InRange(solver.Speed, 0, 0.02f);
            RigidPose end = solver.Bodies[^1].Pose;
            float flat = MathF.Abs(Vector3.Transform(Vector3.UnitY, end.Rotation).Y);
            Assert.True(flat > 0.999f, $"{ground}, {body.Kind}: {end}");
            Assert.InRange(end.Position.Y, 0.19f, 0.205f);
        }
    }

    [Theory]
    [MemberData(nameof(Grounds))]
    public void ABallOfTrianglesRollsAndDoesNotFallThrough(string ground)
    {
        StackSolver solver = Made(ground);
        TriangleMesh ball = Solids.Scaled(Solids.Named("ball", 0), 0.25f);
        solver.Add(AnyShape.Solid(ball), new RigidPose(new Vector3(0.5f, 0.2f, 1.5f)), 1, new Vector3(0.016f));
        solver.Bodies[^1].Velocity = new Vector3(1, 0, 0);
        float highest = 0;
        for (int frame = 0; frame < 90; frame++)
        {
            solver.Advance();
            float height = solver.Bodies[^1].Pose.Position.Y;
            Assert.True(height > 0.18f, $"{ground}, {frame}: {height}");
            highest = Math.Max(highest, height);
        }

        Assert.InRange(highest, 0.19f, 0.23f);
        Assert.True(solver.Bodies[^1].Pose.Position.X > 0.8f);
    }

    private static AnyShape SolidBox() => AnyShape.Solid(ConcaveShapes.Box(Half));

    private static StackSolver Made(string ground)
    {
        var solver = new StackSolver(20);
        if (ground == "block")
        {
            solver.Add(
                AnyShape.Solid(Solids.Box(new Vector3(0, -2, 0), new Vector3(3, 0, 3))), RigidPose.Identity);
        }
        else
        {
            solver.Add(Floors.Named(ground), RigidPose.Identity);
        }

        return solver;
    }

    private static void AssertStays(StackSolver solver, int bodies)
    {
        for (int frame = 0; frame < 60; frame++) solver.Advance();
        Vector3[] before = [.. solver.Bodies.TakeLast(bodies).Select(b => b.Pose.Position)];
        for (int frame = 0; frame < 120; frame++) solver.Advance();
        for (int i = 0; i < bodies; i++)
        {
            float drift = (solver.Bodies[^(bodies - i)].Pose.Position - before[i]).Length() / 2;
            Assert.True(drift <= DriftPerSecond, $"{i} drifts by {drift} a second");
        }
    }
}
