namespace Gjk.Core.Tests.Arithmetic;

/// <summary>The sign of a sum is that of the sum in integers, however much of it cancels.</summary>
public class ExactSumTests
{
    private const int Tries = 1000;

    [Fact]
    public void TheSignIsThatOfTheExactSum()
    {
        var sum = new ExactSum();
        int zeros = 0;
        for (ulong seed = 0; seed < (ulong)Budget.Count(Tries); seed++)
        {
            sum.Clear();
            Fraction expected = 0;
            foreach (double term in Terms(new Rng(seed)))
            {
                sum.Add(term);
                expected += term;
                Assert.True(expected.Sign == sum.Sign, $"seed {seed}: {sum.Sign}, truly {expected.Sign}");
            }

            if (expected.Sign == 0) zeros++;
        }

        Assert.InRange(zeros, 1, Budget.Count(Tries) - 1);
    }

    [Fact]
    public void ACleanSumIsZero()
    {
        var sum = new ExactSum();
        Assert.Equal(0, sum.Sign);
        sum.Add(-1e30);
        Assert.Equal(-1, sum.Sign);
        sum.Clear();
        Assert.Equal(0, sum.Sign);
        sum.Add(0);
        Assert.Equal(0, sum.Sign);
    }

    [Fact]
    public void TheLeastTermDecidesWhereAllOthersCancel()
    {
        // The range of what the predicates add: products of three floats.
        double largest = Math.ScaleB(1, 383), least = Math.ScaleB(1, -447);
        foreach (double sign in new[] { 1.0, -1.0 })
        {
            var sum = new ExactSum();
            foreach (double term in new[] { largest, 1, sign * least, -largest, -1 }) sum.Add(term);
            Assert.Equal(Math.Sign(sign), sum.Sign);
        }
    }

    /// <summary>Products of two floats and their opposites in another order; in half of the cases one more.</summary>
    private static List<double> Terms(Rng rng)
    {
        double[] half = [.. Enumerable.Range(0, 2 + rng.Below(11)).Select(_ => Product(rng))];
        List<double> terms = [.. half, .. half.Select(x => -x).OrderBy(_ => rng.Next())];
        if (rng.Below(2) == 0) terms.Insert(rng.Below(terms.Count), Product(rng));
        return terms;
    }

    private static double Product(Rng rng) =>
        (double)rng.Float(-1, 1) * rng.Float(-1, 1) * Math.ScaleB(1, rng.Below(300) - 150);
}
