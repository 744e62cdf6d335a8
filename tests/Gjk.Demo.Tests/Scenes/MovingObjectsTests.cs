namespace Gjk.Demo.Tests.Scenes;

/// <summary>Scenes of any number of objects, and their motion.</summary>
public sealed class MovingObjectsTests
{
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void AboutHalfOfTheObjectsTouchAnother(bool cubes)
    {
        const int Count = 2000;
        BuiltInScene scene = cubes ? BuiltInScenes.Cubes(Count) : BuiltInScenes.Spheres(Count);
        Assert.Equal((Count, Count), (scene.Poses.Count, scene.ObjectNames.Distinct().Count()));
        Assert.Equal(scene.Vertices, (cubes ? BuiltInScenes.Cubes() : BuiltInScenes.Spheres()).Vertices);
        var shape = ConvexShape.Mesh(scene.Vertices);
        var world = new CollisionScene();
        foreach (RigidPose pose in scene.Poses) world.Add(shape, pose);
        List<ObjectPair> pairs = [];
        world.FindOverlaps(pairs);
        Assert.InRange(pairs.SelectMany(p => new[] { p.A, p.B }).Distinct().Count(), 0.4 * Count, 0.6 * Count);
    }

    [Fact]
    public void TheRoomGrowsWithTheObjects()
    {
        Vector3 small = BuiltInScenes.Cubes(100).Room.Max, large = BuiltInScenes.Cubes(100_000).Room.Max;
        Assert.Equal(10, large.X / small.X, 1e-5);
        Assert.Equal(1100 / Math.Log(2), Math.Pow(small.X, 3), 1e-3);
    }

    [Theory]
    [InlineData(0.01)]
    [InlineData(3)]
    [InlineData(1000)]
    public void NobodyLeavesTheRoom(double speed)
    {
        foreach (BuiltInScene scene in new[] { BuiltInScenes.Cubes(), BuiltInScenes.Spheres(50) })
        {
            var objects = new MovingObjects(scene, speed);
            for (int frame = 0; frame < 300; frame++)
            {
                objects.Advance();
                Assert.All(
                    objects.Poses,
                    p => Assert.Equal(Vector3.Clamp(p.Position, scene.Room.Min, scene.Room.Max), p.Position));
            }
        }
    }

    /// <summary>In the middle of a room. The quaternion's real part is 1 / sqrt(1 + tan²) of half the angle.</summary>
    [Fact]
    public void AStepIsTheSpeedAndATurnIsTwiceThat()
    {
        BuiltInScene scene = BuiltInScenes.Cubes(500);
        var objects = new MovingObjects(scene, 0.01);
        objects.Advance();
        int straight = 0;
        for (int i = 0; i < objects.Poses.Length; i++)
        {
            RigidPose before = scene.Poses[i], after = objects.Poses[i];
            float moved = Vector3.Distance(before.Position, after.Position);
            Assert.InRange(moved, 0, 0.01001f);
            if (Math.Abs(moved - 0.01f) < 1e-5f) straight++;
            Assert.Equal(
                1 / Math.Sqrt(1 + 0.01 * 0.01), Math.Abs(Quaternion.Dot(before.Rotation, after.Rotation)), 1e-6);
        }

        Assert.InRange(straight, 480, 500);
    }

    [Fact]
    public void TheWayCanBeGoneAgain()
    {
        BuiltInScene scene = BuiltInScenes.Spheres(30);
        var objects = new MovingObjects(scene, 0.7);
        Assert.Equal(scene.Poses, objects.Poses);
        for (int frame = 0; frame < 40; frame++) objects.Advance();
        RigidPose[] there = [.. objects.Poses];
        objects.Rewind();
        Assert.Equal(scene.Poses, objects.Poses);
        for (int frame = 0; frame < 40; frame++) objects.Advance();
        Assert.Equal(there, objects.Poses);
    }

    [Fact]
    public void WithoutSpeedNothingMoves()
    {
        var objects = new MovingObjects(BuiltInScenes.Cubes(), 0);
        objects.Advance();
        Assert.False(objects.IsMoving);
        Assert.Equal(BuiltInScenes.Cubes().Poses, objects.Poses);
    }
}
