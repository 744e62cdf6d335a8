namespace Gjk.Core.Tests.Geometry;

/// <summary>Boxes on a small lattice, where every way of touching occurs.</summary>
public class AabbTests
{
    [Fact]
    public void BoxesOverlapWhereTheyShareAPoint()
    {
        var rng = new Rng(1);
        int overlapping = 0;
        for (int i = 0; i < 5000; i++)
        {
            Aabb a = Any(rng), b = Any(rng);
            bool shares = SharesAPoint(a, b);
            Assert.Equal(shares, a.Overlaps(b));
            Assert.Equal(shares, b.Overlaps(a));
            if (shares) overlapping++;
        }

        Assert.InRange(overlapping, 500, 4500);
    }

    [Fact]
    public void TheLongestSideIsNotRoundedToFloat()
    {
        var box = new Aabb(new Vector3(0, -1, -float.MaxValue), new Vector3(1, 16777216, float.MaxValue));
        Assert.Equal(2.0 * float.MaxValue, box.LongestSide);
        Assert.Equal(16777217.0, new Aabb(new Vector3(0, -1, 0), new Vector3(1, 16777216, 1)).LongestSide);
    }

    [Fact]
    public void AnEmptyBoxIsRefused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new Aabb(Vector3.Zero, new Vector3(1, 1, -1)));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Aabb(Vector3.Zero, new Vector3(1, float.NaN, 1)));
        Assert.Equal(0, new Aabb(Vector3.One, Vector3.One).LongestSide);
    }

    /// <summary>The corners are numbers of the lattice, so one of its points is shared if any is.</summary>
    private static bool SharesAPoint(in Aabb a, in Aabb b)
    {
        for (int i = 0; i < 125; i++)
        {
            var p = new Vector3(i % 5, i / 5 % 5, i / 25);
            if (Holds(a, p) && Holds(b, p)) return true;
        }

        return false;
    }

    private static bool Holds(in Aabb box, Vector3 p) => Vector3.Clamp(p, box.Min, box.Max) == p;

    private static Aabb Any(Rng rng)
    {
        Vector3 p = Corner(rng), q = Corner(rng);
        return new Aabb(Vector3.Min(p, q), Vector3.Max(p, q));
    }

    private static Vector3 Corner(Rng rng) => new(rng.Below(5), rng.Below(5), rng.Below(5));
}
