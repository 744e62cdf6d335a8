namespace Gjk.Core.Tests.Queries;

/// <summary>What may be done to a pair without changing its distance: for changes that float represents
/// exactly.</summary>
public class InvarianceTests
{
    private const int Count = 150;

    /// <summary>Kinds whose shapes are not scaled yet.</summary>
    private static readonly string[] Plain =
        ["segment", "triangle", "sphere", "capsule", "box", "hull", "flat", "needle"];

    [Theory]
    [InlineData(1e-3f)]
    [InlineData(0.125f)]
    [InlineData(7.5f)]
    [InlineData(1e3f)]
    public void AUniformScaleMultipliesTheDistance(float factor) => Each(pair =>
    {
        // A at the origin and B where the product of its position and the factor is a float, so that nothing is
        // rounded.
        TestPair exact =
            pair with { PoseA = new RigidPose(pair.PoseA.Rotation, default), PoseB = OnGrid(pair.PoseB, factor) };
        return (exact.Distance(), exact.Resized(factor).Distance(), factor, exact.Scale * factor);
    });

    [Theory]
    [InlineData(16)]
    [InlineData(4096)]
    public void ATranslationOfBothChangesNothing(float offset) => Each(pair =>
    {
        TestPair near = pair with { PoseA = OnGrid(pair.PoseA), PoseB = OnGrid(pair.PoseB) };
        var shift = new Vector3(offset, -2 * offset, 3 * offset);
        TestPair far = near with
        {
            PoseA = new RigidPose(near.PoseA.Rotation, near.PoseA.Position + shift),
            PoseB = new RigidPose(near.PoseB.Rotation, near.PoseB.Position + shift),
        };
        return (near.Distance(), far.Distance(), 1, near.Scale);
    });

    [Fact]
    public void ATurnByAThirdOfBothChangesNothing() => Each(pair =>
    {
        // (x, y, z) to (y, z, x) turns the world, the shapes and the quaternions' axes without rounding anything.
        var turned = new TestPair(
            pair.Name, Relabel(pair.A), Relabel(pair.PoseA), Relabel(pair.B), Relabel(pair.PoseB));
        return (pair.Distance(), turned.Distance(), 1, pair.Scale);
    }, "hull", "flat", "needle");

    [Fact]
    public void TheOppositeQuaternionChangesNothing() => Each(pair =>
        (
            pair.Distance(),
            (pair with { PoseB = new RigidPose(-pair.PoseB.Rotation, pair.PoseB.Position) }).Distance(),
            1, pair.Scale));

    [Fact]
    public void AQuaternionOfAnotherLengthChangesNothing() => Each(pair =>
    {
        // Each component's product rounds, which turns the shape by 1e-7 at most.
        RigidPose longer = new(Quaternion.Multiply(pair.PoseB.Rotation, 1.0009f), pair.PoseB.Position);
        DistanceResult a = pair.Distance(), b = (pair with { PoseB = longer }).Distance();
        Assert.True(
            Math.Abs(a.Distance - b.Distance) <= 1e-6 * pair.Scale, $"{a.Distance:R} became {b.Distance:R}: {pair}");
        return (a, a, 1, pair.Scale);
    });

    [Fact]
    public void RepeatedVerticesChangeNothing() => Each(pair =>
    {
        Vector3[] points = [.. pair.A.Vertices!.Select(v => (Vector3)v)];
        Vector3[] more = [.. points, .. points.Reverse(), points[0], -(-points[0])];
        TestPair repeated = pair with { A = TestShape.Mesh(more) };
        return (pair.Distance(), repeated.Distance(), 1, pair.Scale);
    }, "hull", "flat", "needle");

    [Fact]
    public void TheMarginIsSubtractedFromTheDistance() => Each(pair =>
    {
        // Widening both by r brings them nearer by 2 r.
        const float R = 0.0625f;
        DistanceResult core = ConvexQuery.Distance(pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB);
        DistanceResult wide = ConvexQuery.Distance(
            new Rounded<ConvexShape>(pair.A.Shape, R), pair.PoseA, new Rounded<ConvexShape>(pair.B.Shape, R),
            pair.PoseB);
        double expected = Math.Max(0, core.Distance - 2.0 * R);
        Assert.True(
            Math.Abs(wide.Distance - expected) <= 2 * Accuracy.Band(core.Distance, pair.Scale),
            $"{core.Distance:R} widened {wide.Distance:R}: {pair}");
        return (core, core, 1, pair.Scale);
    });

    private static RigidPose OnGrid(in RigidPose pose, float factor = 1)
    {
        // Few enough bits that the product with the factor is a float.
        const float Grid = 1024;
        Vector3 p = pose.Position;
        var snapped = new Vector3(
            MathF.Round(p.X * Grid) / Grid, MathF.Round(p.Y * Grid) / Grid, MathF.Round(p.Z * Grid) / Grid);
        bool exact = (double)factor * 1024 == Math.Floor((double)factor * 1024);
        return new RigidPose(pose.Rotation, exact ? snapped : new Vector3(MathF.ScaleB(1, MathF.ILogB(p.X)), 0, 0));
    }

    private static RigidPose Relabel(in RigidPose p) =>
        new(new Quaternion(p.Rotation.Y, p.Rotation.Z, p.Rotation.X, p.Rotation.W), Relabel(p.Position));

    private static Vector3 Relabel(Vector3 v) => new(v.Y, v.Z, v.X);

    private static TestShape Relabel(TestShape s) => TestShape.Mesh([.. s.Vertices!.Select(v => Relabel((Vector3)v))]);

    private static void Each(
        Func<TestPair, (DistanceResult Before, DistanceResult After, double Factor, double Scale)> change,
        params string[] kinds)
    {
        for (ulong i = 0; i < (ulong)Budget.Count(Count); i++)
        {
            TestPair pair = Generators.Pair(80_000 + i, kinds.Length == 0 ? Plain : kinds, 1.2);
            (DistanceResult before, DistanceResult after, double factor, double scale) = change(pair);
            double expected = before.Distance * factor;
            Assert.True(
                before.Status == after.Status,
                $"{before.Status} {before.Distance:R} became {after.Status} {after.Distance:R}: {pair}");
            Assert.True(
                Math.Abs(after.Distance - expected) <= 2 * Accuracy.Band(expected, scale),
                $"{expected:R} became {after.Distance:R}: {pair}");
        }
    }
}
