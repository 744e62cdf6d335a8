namespace Gjk.Core.Tests.Queries;

/// <summary>A query allocates nothing, whatever the shapes and the answer.</summary>
public class AllocationTests
{
    private const int Pairs = 100;

    public static TheoryData<string> Kinds => [.. Generators.AllKinds, .. Generators.LaterKinds, "bigHull"];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void NothingIsAllocatedThroughConvexShape(string kind)
    {
        TestPair[] pairs =
            [.. Enumerable.Range(0, Pairs).Select(i => Generators.Pair((ulong)i, [kind, "hull", "sphere"]))];
        AssertNone(() =>
        {
            foreach (TestPair p in pairs)
            {
                ConvexQuery.Distance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB);
                ConvexQuery.Distance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, 0.1f);
                ConvexQuery.Overlaps(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, out _);
                ConvexQuery.SignedDistance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB);
                ContactManifold manifold = default;
                ConvexQuery.Contacts(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, 0.1f, out manifold);
            }
        });
    }

    [Fact]
    public void NothingIsAllocatedThroughTheStructsAndTheirDecorators()
    {
        TestPair[] pairs = [.. Enumerable.Range(0, Pairs).Select(i => Generators.Pair((ulong)i, ["hull"]))];
        AssertNone(() =>
        {
            foreach (TestPair p in pairs)
            {
                var mesh = new ConvexMesh(p.A.Shape.Hull!);
                var round = new Rounded<Scaled<BoxShape>>(new Scaled<BoxShape>(new BoxShape(new(0.5f)), -0.5f), 0.1f);
                ConvexQuery.Distance(mesh, p.PoseA, new CapsuleShape(0.25f, 0.5f), p.PoseB);
                ConvexQuery.Distance(new Scaled<ConvexMesh>(mesh, 2), p.PoseA, round, p.PoseB);
                ConvexQuery.Overlaps(
                    new TriangleShape(default, new(1), new(1, 0, 0)), p.PoseA, new ConeShape(0.5f, 1), p.PoseB);
                ContactManifold manifold = default;
                ConvexQuery.Contacts(mesh, p.PoseA, round, p.PoseB, 1, out manifold);
                ConvexQuery.Contacts(
                    new CylinderShape(1, 1), p.PoseA, new CapsuleShape(1, 1), p.PoseB, 1, out manifold);
            }
        });
    }

    [Fact]
    public void NothingIsAllocatedOnTheHardestPairs()
    {
        HardCase[] cases = [.. CaseFamily.Load("touch").Cases, .. CaseFamily.Load("degenerate").Cases];
        var warm = default(WarmStart);
        AssertNone(() =>
        {
            foreach (HardCase c in cases)
            {
                ConvexQuery.Distance(c.Pair.A.Shape, c.Pair.PoseA, c.Pair.B.Shape, c.Pair.PoseB, ref warm);
                ConvexQuery.Distance(c.Pair.A.Shape, c.Pair.PoseA, c.Pair.B.Shape, c.Pair.PoseB);
                ConvexQuery.Overlaps(c.Pair.A.Shape, c.Pair.PoseA, c.Pair.B.Shape, c.Pair.PoseB);
            }
        });
    }

    [Fact]
    public void TheMeasureSeesAnAllocation() => Assert.True(Allocation.Least(() => GC.KeepAlive(new byte[64])) >= 64);

    private static void AssertNone(Action work) => Assert.Equal(0, Allocation.Least(work));
}
