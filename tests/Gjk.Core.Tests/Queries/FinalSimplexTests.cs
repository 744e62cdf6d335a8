namespace Gjk.Core.Tests.Queries;

/// <summary>The simplex that a query hands out: weights that are weights, ids that name its points, sums that are the
/// witness points.</summary>
public class FinalSimplexTests
{
    public static TheoryData<string> Families => [.. CaseFamily.Names];

    [Theory]
    [MemberData(nameof(Families))]
    public void ItsWeightedSumsAreTheWitnessPoints(string family)
    {
        foreach (HardCase c in CaseFamily.Load(family).Cases)
        {
            TestPair p = c.Pair;
            DistanceResult r = ConvexQuery.Distance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, out FinalSimplex simplex);
            Assert.Equal(ResultBits.Of(p.Distance()), ResultBits.Of(r));
            Assert.InRange(simplex.Count, 1, 4);
            double sum = 0, reach = p.Scale + ((Double3)p.PoseA.Position - p.PoseB.Position).Length;
            Double3 onA = default, onB = default;
            for (int i = 0; i < simplex.Count; i++)
            {
                Assert.True(simplex.Weight(i) >= 0, $"weight {simplex.Weight(i):R}: {p}");
                sum += simplex.Weight(i);
                onA += simplex.PointOnA(i) * simplex.Weight(i);
                onB += simplex.PointOnB(i) * simplex.Weight(i);
                AssertVertex(p.A, simplex.IdA(i), simplex.PointOnA(i), reach);
                AssertVertex(p.B, simplex.IdB(i), simplex.PointOnB(i), reach);
            }

            Assert.Equal(1, sum, 1e-14);
            double scale = p.Scale == 0 ? r.Distance : p.Scale;
            double offA = (onA - r.LocalPointA).Length, offB = (onB - r.LocalPointB).Length;
            Assert.True(
                offA <= Accuracy.WitnessScale * (scale + onA.Length),
                $"LocalPointA is {offA:R} off the weighted sum: {p.Name}");
            Assert.True(
                offB <= Accuracy.WitnessScale * (scale + onB.Length),
                $"LocalPointB is {offB:R} off the weighted sum: {p.Name}");
        }
    }

    [Fact]
    public void AnIndexThatIsNoneIsRefused()
    {
        ConvexQuery.Distance(
            new PointShape(), RigidPose.Identity, new PointShape(), new RigidPose(new(1, 2, 3)),
            out FinalSimplex simplex);
        Assert.Equal(1, simplex.Count);
        foreach (int index in new[] { -1, 1, 4, int.MaxValue, int.MinValue })
        {
            Action[] calls =
            [
                () => simplex.Weight(index), () => simplex.PointOnA(index), () => simplex.PointOnB(index),
                () => simplex.IdA(index), () => simplex.IdB(index),
            ];
            foreach (Action call in calls)
            {
                var e = Assert.Throws<ArgumentOutOfRangeException>(call);
                Assert.Equal("index", e.ParamName);
                Assert.StartsWith("There is no such pair of points.", e.Message);
            }
        }
    }

    [Fact]
    public void AnInvalidQueryHasNone()
    {
        ConvexQuery.Distance(
            default(ConvexShape), RigidPose.Identity, new PointShape(), RigidPose.Identity, out FinalSimplex simplex);
        Assert.Equal(0, simplex.Count);
        Assert.Throws<ArgumentOutOfRangeException>(() => simplex.Weight(0));
    }

    private static void AssertVertex(TestShape shape, int id, Double3 point, double reach)
    {
        Assert.True(shape.Shape.TryGetVertex(id, out Double3 vertex), $"no vertex {id} in {shape.Text}");

        vertex += shape.Shape.Center;

        // Support points are kept relative to the centre and, for B, turned and moved: roundings of double at the reach
        // of the pair.
        Assert.True(
            (vertex - point).Length <= 1e-12 * (reach + point.Length),
            $"vertex {id} is {vertex}, the simplex has {point}");
    }
}
