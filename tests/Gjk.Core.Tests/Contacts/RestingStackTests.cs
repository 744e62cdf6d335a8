namespace Gjk.Core.Tests.Contacts;

/// <summary>Five seconds of equal bodies that stand on each other, on a plain solver that begins each frame with what
/// points of the same name had before: they come to rest, and names stay.</summary>
public class RestingStackTests
{
    private const float Rest = 0.005f;

    private static readonly ConvexShape Cube = ConvexShape.Box(new Vector3(0.5f));

    private static readonly Vector3 CubeInertia = new(1f / 6);

    [Theory]
    [InlineData(3, 0)]
    [InlineData(3, 1e-3f)]
    [InlineData(5, 0)]
    [InlineData(5, 1e-5f)]
    [InlineData(5, 1e-3f)]
    [InlineData(10, 0)]
    [InlineData(10, 1e-3f)]
    public void AStackOfCubesRests(int count, float noise) => AssertRests(
        (solver, rng) =>
        {
            for (int i = 0; i < count; i++)
            {
                var at = new Vector3(rng.Float(-noise, noise), 0.5f + i - 0.004f * (i + 1), rng.Float(-noise, noise));
                solver.Add(Cube, new RigidPose(Yaw(rng, noise), at), 1, CubeInertia);
            }
        },
        count > 5 ? 60 : 20);

    [Theory]
    [InlineData(0)]
    [InlineData(1e-3f)]
    public void APyramidOfCubesRests(float noise) => AssertRests(
        (solver, rng) =>
        {
            for (int row = 0; row < 5; row++)
            {
                for (int i = 0; i < 5 - row; i++)
                {
                    var at = new Vector3(
                        i * 1.05f + row * 0.525f + rng.Float(-noise, noise), 0.5f + row - 0.004f * (row + 1),
                        rng.Float(-noise, noise));
                    solver.Add(Cube, new RigidPose(Yaw(rng, noise), at), 1, CubeInertia);
                }
            }
        });

    [Theory]
    [InlineData(0)]
    [InlineData(1e-4f)]
    public void AWallOfBricksRests(float noise) => AssertRests(
        (solver, rng) =>
        {
            var brick = ConvexShape.Box(new Vector3(0.5f, 0.25f, 0.25f));
            Vector3 inertia = new Vector3(0.5f, 1.25f, 1.25f) / 12;
            for (int row = 0; row < 5; row++)
            {
                for (int i = 0; i < 5 - (row & 1); i++)
                {
                    var at = new Vector3(
                        i * 1.001f + (row & 1) * 0.5005f + rng.Float(-noise, noise),
                        0.25f + row * 0.5f - 0.004f * (row + 1), rng.Float(-noise, noise));
                    solver.Add(brick, new RigidPose(Yaw(rng, noise), at), 1, inertia);
                }
            }
        });

    /// <summary>Three layers of logs between two walls.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void APileOfLogsRests(bool areCapsules) => AssertRests(
        (solver, rng) =>
        {
            const float Radius = 0.3f;
            ConvexShape log = areCapsules ? ConvexShape.Capsule(Radius, 1) : ConvexShape.Cylinder(Radius, 1);
            Vector3 inertia = new(0.356f, 0.045f, 0.356f);
            var lying = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2);
            foreach (float side in new[] { -1.1f, 1.1f })
                solver.Add(ConvexShape.Box(new Vector3(2, 1, 0.2f)), new RigidPose(new Vector3(0, 0.5f, side)));
            for (int row = 0; row < 3; row++)
            {
                for (int i = 0; i < 3 - row; i++)
                {
                    var at = new Vector3(
                        rng.Float(-1e-3, 1e-3), Radius + row * Radius * 1.7320508f - 0.003f * (row + 1),
                        (2 * i - 2 + row) * Radius);
                    solver.Add(log, new RigidPose(Yaw(rng, 1e-3f) * lying, at), 1, inertia);
                }
            }
        });

    private static Quaternion Yaw(Rng rng, float noise) =>
        Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(-noise, noise));

    private static void AssertRests(Action<StackSolver, Rng> build, int sweeps = 20)
    {
        var solver = new StackSolver(sweeps);
        solver.Add(ConvexShape.Box(new Vector3(20, 1, 20)), new RigidPose(new Vector3(0, -1, 0)));
        build(solver, new Rng(3));
        float most = 0;
        for (int frame = 0; frame < 300; frame++)
        {
            if (frame == 60) solver.ForgetNames();
            solver.Advance();
            if (frame >= 240) most = MathF.Max(most, solver.Speed);
        }

        Assert.InRange(most, 0, Rest);
        Assert.InRange(solver.PairsWithTheSameNames, 0.99 * solver.Pairs, solver.Pairs);
        Assert.NotEqual(0, solver.Pairs);
    }
}
