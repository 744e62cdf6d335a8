using FsCheck;
using FsCheck.Fluent;

namespace Gjk.Core.Tests.Queries;

/// <summary>Laws of the distance between convex sets, on inputs that FsCheck makes and shrinks.</summary>
public class AlgebraicLawTests
{
    private const float Grid = 64;

    /// <summary>Points on a grid, so that sums and differences are exact in float and degenerate positions are
    /// frequent.</summary>
    private static readonly Gen<Vector3> Points =
        from x in Gen.Choose(-160, 160)
        from y in Gen.Choose(-160, 160)
        from z in Gen.Choose(-160, 160)
        select new Vector3(x / Grid, y / Grid, z / Grid);

    private static readonly Gen<TestShape> Hulls = Gen.OneOf(
        from p in Points.ArrayOf(4) select TestShape.Mesh(p),
        from p in Points.ArrayOf(9) select TestShape.Mesh(p),
        from a in Points from b in Points select TestShape.Segment(a, b),
        from p in Points select TestShape.Box(Vector3.Abs(p) / 4));

    private static readonly Gen<Quaternion> Rotations =
        from i in Gen.Choose(0, int.MaxValue)
        select i % 4 == 0 ? Quaternion.Identity : new Rng((ulong)i).Rotation();

    private static readonly Gen<TestPair> Pairs =
        from a in Hulls
        from b in Hulls
        from q in Rotations
        from r in Rotations
        from p in Points
        from s in Points
        select new TestPair("law", a, new RigidPose(q, p), b, new RigidPose(r, s));

    [Fact]
    public void SwapMirrors() => Check(Pairs, pair =>
    {
        DistanceResult r = pair.Distance(), s = pair.Swapped.Distance();
        return Near(pair, r.Distance, s.Distance) && r.Swapped.PointA == r.PointB && r.Swapped.Normal == -r.Normal
            && r.Swapped.Swapped.Normal == r.Normal;
    });

    [Fact]
    public void TranslationOfBothChangesNothing() => Check(from pair in Pairs from t in Points select (pair, t), x =>
        Near(x.pair, x.pair.Distance().Distance, Moved(x.pair, x.t, x.t).Distance().Distance));

    [Fact]
    public void TranslationOfOneChangesTheDistanceByItsLengthAtMost() =>
        Check(from pair in Pairs from t in Points select (pair, t), x =>
    {
        double before = x.pair.Distance().Distance, after = Moved(x.pair, default, x.t).Distance().Distance;
        return Math.Abs(before - after) <= ((Double3)x.t).Length + 2 * Accuracy.Band(
            Math.Max(before, after), x.pair.Scale);
    });

    [Fact]
    public void ADistanceIsThatOfTheMinkowskiDifferenceFromTheOrigin() => Check(
        from p in Points.ArrayOf(5) from q in Points.ArrayOf(5) from s in Points select (p, q, s), x =>
    {
        // Without rotation every difference of vertices is a float, so the difference is a mesh of its own.
        var sums = new Vector3[25];
        for (int i = 0; i < sums.Length; i++) sums[i] = x.p[i / 5] - x.q[i % 5] - x.s;
        TestShape a = TestShape.Mesh(x.p), b = TestShape.Mesh(x.q), difference = TestShape.Mesh(sums);
        var pair = new TestPair("law", a, RigidPose.Identity, b, new RigidPose(x.s));
        var single = new TestPair("law", difference, RigidPose.Identity, TestShape.Point(), RigidPose.Identity);
        return pair.Overlaps() == single.Overlaps()
            && Near(single, pair.Distance().Distance, single.Distance().Distance);
    });

    [Fact]
    public void ALargerShapeIsNotFurther() => Check(from pair in Pairs from p in Points select (pair, p), x =>
    {
        if (x.pair.A.Shape.Kind != ShapeKind.Mesh) return true;
        Vector3[] more = [.. Array.ConvertAll(x.pair.A.Vertices!, v => (Vector3)v), x.p];
        TestPair larger = x.pair with { A = TestShape.Mesh(more) };
        double before = x.pair.Distance().Distance, after = larger.Distance().Distance;
        return after <= before + 2 * Accuracy.Band(before, larger.Scale);
    });

    [Fact]
    public void AShapeTouchesItself() =>
        Check(from s in Hulls from q in Rotations from p in Points select (s, q, p), x =>
        new TestPair("law", x.s, new RigidPose(x.q, x.p), x.s, new RigidPose(x.q, x.p)).Distance().IsOverlapping);

    [Fact]
    public void TheOracleAgrees() => Check(Pairs, pair => OracleVerdict.Problem(pair, out _) is null, 100);

    private static TestPair Moved(TestPair pair, Vector3 a, Vector3 b) => pair with
    {
        PoseA = new RigidPose(pair.PoseA.Rotation, pair.PoseA.Position + a),
        PoseB = new RigidPose(pair.PoseB.Rotation, pair.PoseB.Position + b),
    };

    private static bool Near(TestPair pair, double a, double b) =>
        Math.Abs(a - b) <= 2 * Accuracy.Band(Math.Max(a, b), pair.Scale);

    private static void Check<T>(Gen<T> gen, Func<T, bool> law, int count = 300) =>
        Prop.ForAll(gen.ToArbitrary(), law).Check(
            Config.QuickThrowOnFailure.WithQuietOnSuccess(true).WithMaxTest(Budget.Count(count)).WithReplay(20221, 7));
}
