namespace Gjk.Core.Tests.Concave;

/// <summary>What float says of triangles: bounds hold, and leave little to the exact query.</summary>
public unsafe class TriangleLanesTests
{
    [Fact]
    public void BoundsAreNeverAboveTheDistance()
    {
        var random = new Rng(8);
        float* lanes = stackalloc float[2 * TriangleLanes.Stride];
        float* seeming = stackalloc float[8], bounds = stackalloc float[8];
        int tight = 0, apart = 0;
        for (int round = 0; round < 3000; round++)
        {
            double thin = random.Of(1.0, 1e-3, 1e-6), gap = random.Magnitude(1e-6, 3);
            var corners = new Vector3[8, 6];
            for (int lane = 0; lane < 8; lane++)
            {
                Vector3 way = (Vector3)(random.Direction() * gap), flat = new(1, (float)thin, 1);
                for (int k = 0; k < 6; k++) corners[lane, k] = random.Vector(1) * flat + (k < 3 ? default : way);
                if (random.OneIn(8)) corners[lane, 5] = corners[lane, 4];
                for (int k = 0; k < 6; k++)
                    for (int axis = 0; axis < 3; axis++) lanes[24 * k + 8 * axis + lane] = At(corners[lane, k], axis);
            }

            TriangleLanes.Measure(lanes, 0, seeming, bounds);
            for (int lane = 0; lane < 8; lane++)
            {
                var a = new TriangleShape(corners[lane, 0], corners[lane, 1], corners[lane, 2]);
                var b = new TriangleShape(corners[lane, 3], corners[lane, 4], corners[lane, 5]);
                double distance = ConvexQuery.Distance(a, RigidPose.Identity, b, RigidPose.Identity).Distance;
                Assert.True(
                    bounds[lane] <= BoxLanes.Squared(distance), $"round {round}: {bounds[lane]} of {distance}");
                if (TriangleLanes.AreApart(lanes, 0, BoxLanes.Squared(distance))) Assert.True(round < 0, $"{round}");
                if (!(distance > 1e-3)) continue;
                apart++;
                if (Math.Sqrt(bounds[lane]) > 0.999 * distance) tight++;
            }
        }

        Assert.InRange((double)tight / apart, 0.9, 1);
    }

    /// <summary>Plates a little apart, in any pose: as many equals as triangles, and soon an end.</summary>
    [Fact]
    public void ParallelPlatesAreQuick()
    {
        var random = new Rng(9);
        var scratch = new ConcaveScratch();
        AnyShape plate = AnyShape.Surface(ConcaveShapes.Grid(64));
        for (int round = 0; round < 6; round++)
        {
            float gap = random.Of(0.125f, 0.01f, 1e-3f);
            RigidPose pose = round < 2 ? RigidPose.Identity : ConcaveShapes.Pose(random, 2);
            Vector3 offset = pose.TransformPoint(new Vector3(0.1f, gap, 0.07f));
            PairDistance found = ConcaveQuery.Distance(
                plate, pose, plate, new RigidPose(pose.Rotation, offset), scratch);
            Assert.InRange(found.Distance, gap * 0.999f, gap * 1.001f);
            Assert.InRange(found.Result.LowerBound, gap * 0.998f, found.Distance);
            Assert.InRange(scratch.Search.QueryCount, 1, 2000);
        }
    }

    private static float At(Vector3 v, int axis) => axis == 0 ? v.X : axis == 1 ? v.Y : v.Z;
}
