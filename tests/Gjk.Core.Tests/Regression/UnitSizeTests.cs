namespace Gjk.Core.Tests.Regression;

/// <summary>Products of lengths left the range of double for pairs below 1e-35 (wrong, or overlapping) and near 3e38
/// (InvalidShape). Such a pair is solved at unit size, by a power of two.</summary>
public class UnitSizeTests
{
    [Theory]
    [InlineData(-148)]
    [InlineData(-140)]
    [InlineData(-120)]
    [InlineData(-100)]
    [InlineData(-61)]
    [InlineData(-59)]
    [InlineData(59)]
    [InlineData(61)]
    [InlineData(100)]
    [InlineData(124)]
    public void PairsOfAnySizeAreExact(int exponent)
    {
        var unit = (float)System.Math.Pow(2, exponent);
        int separated = 0, count = Budget.Count(150);
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            var rng = new Rng(340_000 + seed);
            TestPair pair = Lattice(rng, unit);
            DistanceResult r = pair.Distance();
            string? problem = OracleVerdict.Problem(pair, r, out ExactAnswer exact);
            Assert.True(problem is null, $"{problem}\n{pair}");
            bool overlaps = ConvexQuery.Overlaps(
                pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, out GjkStatus status);
            Assert.True(overlaps == r.IsOverlapping && status == r.Status, $"{status}, not {r.Status}\n{pair}");
            WarmStart warm = default;
            for (int i = 0; i < 2; i++)
            {
                DistanceResult w = ConvexQuery.Distance(pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, ref warm);
                Assert.True(
                    w.Status == r.Status && w.Distance == r.Distance,
                    $"warm {w.Status} {w.Distance:R}, cold {r.Status} {r.Distance:R}\n{pair}");
            }

            separated += exact.Overlap ? 0 : 1;
        }

        Assert.InRange(separated, 0.2 * count, 0.95 * count);
    }

    /// <summary>A power of two changes no bit of the answer, only its exponent.</summary>
    [Theory]
    [InlineData(-90)]
    [InlineData(90)]
    public void TheBitsAreThoseOfTheOrdinaryPair(int exponent)
    {
        var unit = (float)System.Math.Pow(2, exponent);
        for (ulong seed = 0; seed < 200; seed++)
        {
            DistanceResult ordinary = Lattice(new Rng(350_000 + seed), 1).Distance();
            DistanceResult sized = Lattice(new Rng(350_000 + seed), unit).Distance();
            Assert.Equal(ordinary.Status, sized.Status);
            Assert.Equal(ordinary.Distance * unit, sized.Distance);
            Assert.Equal(ordinary.LowerBound * unit, sized.LowerBound);
            Assert.Equal(ordinary.Normal, sized.Normal);
            Assert.Equal(ordinary.PointA * unit, sized.PointA);
            Assert.Equal(ordinary.PointB * unit, sized.PointB);
            Assert.Equal(ordinary.LocalPointB * unit, sized.LocalPointB);
            Assert.Equal(ordinary.Iterations, sized.Iterations);
        }
    }

    /// <summary>Coordinates are whole multiples of the unit, so that the smallest floats hold them, too.</summary>
    private static TestPair Lattice(Rng rng, float unit)
    {
        TestShape a = TestShape.Mesh(Corners(rng, unit)), b = rng.Below(3) == 0
            ? TestShape.Sphere(unit)
            : TestShape.Mesh(Corners(rng, unit));
        Vector3 position = new Vector3(rng.Below(13) - 6, rng.Below(13) - 6, rng.Below(13) - 6) * unit;
        return new TestPair(
            $"unit {unit:R}", a, new RigidPose(rng.Rotation(), default), b, new RigidPose(rng.Rotation(), position));
    }

    private static Vector3[] Corners(Rng rng, float unit)
    {
        var corners = new Vector3[6];
        for (int i = 0; i < corners.Length; i++)
            corners[i] = new Vector3(rng.Below(9) - 4, rng.Below(9) - 4, rng.Below(9) - 4) * unit;
        return corners;
    }
}
