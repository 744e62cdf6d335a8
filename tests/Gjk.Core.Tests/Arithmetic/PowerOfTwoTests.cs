namespace Gjk.Core.Tests.Arithmetic;

/// <summary>Powers of two, and choices by a sign.</summary>
public class PowerOfTwoTests
{
    [Fact]
    public void ItIsTheLargestThatIsNotAbove()
    {
        var rng = new Rng(1);
        for (int i = 0; i < 2000; i++)
        {
            int exponent = rng.Below(2045) - 1022;
            double power = Math.ScaleB(1, exponent);
            Assert.Equal(power, PowerOfTwo.AtMost(power));
            Assert.Equal(power, PowerOfTwo.AtMost(power * (1 + rng.Unit())));
            Assert.Equal(power, PowerOfTwo.AtMost(Math.BitDecrement(2 * power)));
        }
    }

    [Theory]
    [InlineData(-1e-300, 1, -2)]
    [InlineData(double.NegativeInfinity, 1, -2)]
    [InlineData(0.0, 0, 2)]
    [InlineData(5.0, 0, 2)]
    public void ZeroOfEitherSignCountsAsPositive(double x, int isNegative, double ofSizeTwo)
    {
        Assert.Equal(isNegative, BranchFree.IsNegative(x));
        Assert.Equal(ofSizeTwo, BranchFree.WithSign(2, x));
        if (x != 0) return;
        Assert.Equal(0, BranchFree.IsNegative(-x));
        Assert.Equal(2, BranchFree.WithSign(2, -x));
    }
}
