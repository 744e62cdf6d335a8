namespace Gjk.Core.Tests;

public class HullPredicatesTests
{
    private const int Quadruples = 20000;

    [Theory]
    [InlineData("box", 1)]
    [InlineData("any", 2)]
    [InlineData("tiny", 3)]
    [InlineData("huge", 4)]
    [InlineData("integers", 5)]
    [InlineData("plane", 6)]
    [InlineData("almost", 7)]
    [InlineData("far", 8)]
    [InlineData("wide line", 9)]
    [InlineData("wide plane", 10)]
    [InlineData("deep plane", 11)]
    [InlineData("axis plane", 12)]
    [InlineData("deep plane, nudged", 13)]
    public void SideIsExact(string family, int seed)
    {
        var random = new Rng((ulong)seed);
        int zeros = 0;
        for (int i = 0; i < Quadruples; i++)
        {
            Vector3[] p = Quadruple(family, random);
            var predicates = new HullPredicates(p);
            int expected = HullOracle.Side(p[0], p[1], p[2], p[3]);
            int side = predicates.Side(predicates.PlaneThrough(0, 1, 2), 3, out _);
            Assert.True(
                expected == side,
                $"{family}, seed {seed}, quadruple {i}: {string.Join(" ", p)}: {side} instead of {expected}");
            int determinant = new HullDeterminant().Sign(p[0], p[1], p[2], p[3]);
            Assert.True(
                expected == determinant,
                $"{family}, seed {seed}, quadruple {i}: {string.Join(" ", p)}: determinant {determinant}");
            if (expected == 0) zeros++;
        }

        // The families that are about coplanarity must be coplanar often, and not always.
        if (family is "integers" or "almost") Assert.InRange(zeros, Quadruples / 100, Quadruples * 9 / 10);
        if (family is "plane" or "wide line" or "wide plane" or "deep plane" or "axis plane")
            Assert.Equal(Quadruples, zeros);
    }

    [Theory]
    [InlineData("box", 11)]
    [InlineData("any", 12)]
    [InlineData("tiny", 13)]
    [InlineData("huge", 14)]
    [InlineData("integers", 15)]
    [InlineData("almost", 16)]
    [InlineData("wide line", 17)]
    [InlineData("wide line, nudged", 18)]
    public void TurnIsExact(string family, int seed)
    {
        var random = new Rng((ulong)seed);
        for (int i = 0; i < Quadruples; i++)
        {
            Vector3[] p = Quadruple(family, random);
            var predicates = new HullPredicates(p);
            for (int axis = 0; axis < 3; axis++)
            {
                int expected = HullOracle.Normal(p[0], p[1], p[2])[axis].Sign;
                int turn = predicates.Orientation(0, 1, 2, (axis + 1) % 3, (axis + 2) % 3);
                string where = $"{family}, seed {seed}, triple {i}, axis {axis}: {string.Join(" ", p)}";
                Assert.True(expected == turn, $"{where}: {turn} instead of {expected}");
            }
        }
    }

    [Fact]
    public void OneBitOffALineOrPlaneIsSeen()
    {
        var a = new Vector3(-1, -1, -1);
        var c = new Vector3(1, 1, 1);
        var line = new HullPredicates(
            [a, new Vector3(0.5f, 0.5f, 0.5f), c, new Vector3(0.5f, 0.5f, MathF.BitIncrement(0.5f))]);
        Assert.True(line.AreCollinear(0, 2, 1));
        Assert.False(line.AreCollinear(0, 2, 3));

        // The least float beside coordinates of 1e38: the offset is 83 decimal orders below what it is subtracted from.
        var plane = new HullPredicates(
            [default, new Vector3(1e38f, 0, 0), new Vector3(0, 1e38f, 0), new Vector3(1e38f, 1e38f, float.Epsilon)]);
        Assert.Equal(1, plane.Side(plane.PlaneThrough(0, 1, 2), 3, out _));
    }

    private static Vector3[] Quadruple(string family, Rng random)
    {
        int seed = random.Below(int.MaxValue);
        return family switch
        {
            "box" => HullClouds.Box(seed, 4),
            "any" => HullClouds.AnyFloats(seed, 4),
            "tiny" => HullClouds.SmallIntegers(seed, 4, 5, float.Epsilon),
            "huge" => HullClouds.Box(seed, 4, float.MaxValue),
            "integers" => HullClouds.SmallIntegers(seed, 4, 4, 3),
            "plane" => HullClouds.ExactPlane(seed, 4),
            "wide line" => HullClouds.WideLine(seed, 4),
            "wide line, nudged" => Nudged(HullClouds.WideLine(seed, 4)),
            "wide plane" => HullClouds.WidePlane(seed, 4, 18),
            "deep plane" => HullClouds.WidePlane(seed, 4, 44),
            "deep plane, nudged" => Nudged(HullClouds.WidePlane(seed, 4, 44)),
            "axis plane" => HullClouds.PlaneAlongAxis(seed, 4),
            "far" => HullClouds.Box(seed, 4, 1e-3f).Select(p => p + new Vector3(1e4f, -3e3f, 77)).ToArray(),
            _ => AlmostCoplanar(random),
        };
    }

    private static Vector3[] Nudged(Vector3[] p)
    {
        p[2].Z = MathF.BitIncrement(p[2].Z);
        return p;
    }

    /// <summary>Weights of a quarter keep the fourth point in the plane, or let the last bit push it out.</summary>
    private static Vector3[] AlmostCoplanar(Rng random)
    {
        Vector3[] p = HullClouds.Box(random.Below(int.MaxValue), 4);
        p[3] = 0.25f * p[0] + 0.25f * p[1] + 0.5f * p[2];
        if (random.OneIn(2)) p[2] = p[0] + 2 * (p[1] - p[0]);
        return p;
    }
}
