namespace Gjk.Core.Tests.Concave.Trees;

/// <summary>Boxes hold their parts, and bounds in float are never above what is true.</summary>
public unsafe class BoxLanesTests
{
    [Fact]
    public void ABoxHoldsTheTrianglesBelowIt()
    {
        var random = new Rng(5);
        for (int round = 0; round < 40; round++)
        {
            TriangleMesh mesh = round % 2 == 0
                ? ConcaveShapes.Torus(9, 7).Scaled(random.Factors(1e-3, 1e3))
                : ConcaveShapes.Soup(random, 80, random.Magnitude(1e-4, 1));
            if (round % 4 == 3) mesh = mesh.Scaled(random.Factors(1e-18, 1e18));
            PartTree tree = mesh.Tree;
            for (int lane = 0; lane < tree.Children.Length; lane++)
                if (tree.Children[lane] != PartTree.Empty) AssertHolds(mesh, tree, lane, tree.Children[lane]);
        }
    }

    /// <summary>The depth is bounded: copies of one triangle, and triangles that shrink.</summary>
    [Fact]
    public void NoInputMakesADeepTree()
    {
        var points = new Vector3[3 * 20_000];
        int[] indices = new int[points.Length];
        for (int i = 0; i < points.Length; i++)
        {
            indices[i] = i;
            points[i] = new Vector3(i % 3, i % 3 == 1 ? 1 : 0, 0) * (float)Math.Pow(2, -(i / 3) % 100);
        }

        Assert.InRange(Depth(new TriangleMesh(points, indices).Tree, 0), 1, 30);
        for (int i = 3; i < points.Length; i++) points[i] = points[i % 3];
        Assert.InRange(Depth(new TriangleMesh(points, indices).Tree, 0), 1, 30);
    }

    [Fact]
    public void TheTreeTakesLittleMemory()
    {
        TriangleMesh mesh = ConcaveShapes.Torus(200, 100);
        PartTree tree = mesh.Tree;
        long bytes = 4L * (tree.Boxes.Length + tree.Children.Length + tree.Order.Length)
            + 12L * (mesh.VertexCount + mesh.TriangleCount);
        Assert.InRange((double)bytes / mesh.TriangleCount, 20, 70);
    }

    /// <summary>The corners of triangles in far and near boxes: their distance, in double, is at least the bound. The
    /// slack is not generous either: bounds of touching boxes come near.</summary>
    [Fact]
    public void BoundsAreNeverAboveTheDistance()
    {
        var random = new Rng(6);
        float* bounds = stackalloc float[8], entries = stackalloc float[8];
        for (int round = 0; round < 400; round++)
        {
            TriangleMesh a = ConcaveShapes.Soup(random, 8, 0.3), b = ConcaveShapes.Soup(random, 3, 0.3);
            double far = random.Magnitude(0.1, 100);
            RigidPose poseA = ConcaveShapes.Pose(random, far), poseB = ConcaveShapes.Pose(random, far);
            TreeFrame.Compose(a.Tree, poseA, b.Tree, poseB, 0, out TreeFrame frame);
            Double3 way = random.Direction();
            var inA = (Vector3)frame.RotationA.InverseRotate(way);
            fixed (float* boxesA = a.Tree.Boxes, boxesB = b.Tree.Boxes)
            {
                TurnedBox.Read(boxesB, 0, frame.FactorB, out TurnedBox box);
                frame.SeenFromA(box, out TurnedBox seen);
                int node = Math.Max(a.Tree.Children[0], 0);
                float* at = boxesA + node * PartTree.Stride;
                BoxLanes.DistanceSquared(at, frame.FactorA, seen, frame.Room, bounds);
                BoxLanes.Entries(at, frame.FactorA, seen, inA, frame.Room, entries);
                for (int lane = 0; lane < 8; lane++)
                {
                    int child = a.Tree.Children[8 * node + lane];
                    if (child < 0 && child != PartTree.Empty)
                        AssertBounds(a, poseA, child, b, poseB, way, frame.Unit, bounds[lane], entries[lane]);
                }
            }
        }
    }

    private static void AssertBounds(
        TriangleMesh a, in RigidPose poseA, int leaf, TriangleMesh b, in RigidPose poseB, in Double3 way, double unit,
        float bound, float entry)
    {
        int first = PartTree.FirstOf(leaf), end = first + PartTree.CountOf(leaf);
        for (int i = first; i < end; i++)
        {
            ConvexShape triangle = a.GetShape(a.Tree.Order[i]);
            for (int j = 0; j < b.TriangleCount; j++)
            {
                ConvexShape other = b.GetShape(j);
                double distance = ConvexQuery.Distance(triangle, poseA, other, poseB).Distance / unit;
                Assert.True(bound <= BoxLanes.Squared(distance), $"{bound} is above {distance * distance}");
                var motion = (Vector3)(way * (10 * unit));
                CastResult hit = ConvexQuery.Cast(triangle, poseA, Vector3.Zero, other, poseB, motion, 100);
                if (hit.IsHit) Assert.True(entry <= hit.Fraction * 10 * 1.00001 + 1e-6, $"{entry} is after {hit}");
            }
        }
    }

    private static int Depth(PartTree tree, int lane)
    {
        int child = tree.Children[lane], depth = 0;
        if (child < 0) return 0;
        for (int i = 0; i < 8; i++) depth = Math.Max(depth, Depth(tree, 8 * child + i));
        return depth + 1;
    }

    internal static void AssertHolds(TriangleMesh mesh, PartTree tree, int lane, int child)
    {
        if (child == PartTree.Empty) return;
        if (child >= 0)
        {
            for (int i = 0; i < 8; i++) AssertHolds(mesh, tree, lane, tree.Children[8 * child + i]);
            return;
        }

        int at = lane / 8 * PartTree.Stride + lane % 8;
        for (int i = PartTree.FirstOf(child); i < PartTree.FirstOf(child) + PartTree.CountOf(child); i++)
        {
            mesh.GetCorners(tree.Order[i], out Double3 a, out Double3 b, out Double3 c);
            foreach (Double3 corner in (Double3[])[a, b, c])
            {
                Double3 p = (corner - tree.Origin) * (1 / tree.Unit) - At(tree, at);
                for (int axis = 0; axis < 3; axis++)
                {
                    double along = Math.Abs(Double3.Dot(p, At(tree, at + PartTree.Axes + 24 * axis)));
                    Assert.True(along <= tree.Boxes[at + PartTree.Halves + 8 * axis], $"lane {lane}, axis {axis}");
                }
            }
        }
    }

    private static Double3 At(PartTree tree, int at) => new(tree.Boxes[at], tree.Boxes[at + 8], tree.Boxes[at + 16]);
}
