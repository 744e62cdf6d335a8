namespace Gjk.Core.Tests.BroadPhase;

/// <summary>The slab test misses no box that the path touches and is never late, judged in exact arithmetic; and it
/// takes in little else.</summary>
public class SweptBoxTests
{
    /// <summary>Ratio to the way: a box this far from the path must be left out.</summary>
    private const double Generous = 1e-10;

    [Fact]
    public void NoBoxIsMissedAndNoEntryIsLate()
    {
        int meets = 0, tries = Budget.Count(20_000);
        for (int i = 0; i < tries; i++)
        {
            var rng = new Rng((ulong)i);
            (Aabb box, Aabb start, Vector3 motion, float most) = Case(rng);
            var path = new SweptBox(start, motion, most);
            (Fraction entry, Fraction exit) = Exact(box, start, motion, most);
            bool isMet = path.Meets(box, path.Limit, out double found);
            if (!(entry <= exit)) continue;
            meets++;
            Assert.True(isMet, $"seed {i}: {box}, path of {start} by {motion} up to {most:R} is missed");
            Assert.True((Fraction)found <= entry, $"seed {i}: the entry {found:R} is late");
            Assert.True(path.Meets(box, found, out _), $"seed {i}: not met up to its own entry");
        }

        Assert.InRange((double)meets / tries, 0.3, 0.7);
    }

    [Fact]
    public void ABoxBesideThePathIsLeftOut()
    {
        for (int i = 0; i < Budget.Count(5_000); i++)
        {
            var rng = new Rng((ulong)i);
            (Aabb box, Aabb start, Vector3 motion, float most) = Case(rng);
            double way = Way(box, start);
            if (way > 1e30) continue;
            var wide = new Aabb(box.Min - new Vector3((float)(Generous * way)), box.Max);
            wide = new Aabb(wide.Min, wide.Max + new Vector3((float)(Generous * way)));
            (Fraction entry, Fraction exit) = Exact(wide, start, motion, most);
            var path = new SweptBox(start, motion, most);
            if (entry <= exit) continue;
            bool isMet = path.Meets(box, path.Limit, out double found);
            bool isBeyond = !float.IsInfinity(most) && entry >= (Fraction)(double)most;
            Assert.True(!isMet || isBeyond, $"seed {i}: {box}, {start} by {motion} up to {most:R}, {found:R}");
        }
    }

    [Theory]
    [InlineData(0.5f)]
    [InlineData(1f)]
    [InlineData(3e-45f)]
    [InlineData(1e30f)]
    [InlineData(0f)]
    public void WhatRoundsToTheSameFractionIsNotLeftOut(float fraction)
    {
        // Down and up again twice: as a fraction, and as a distance.
        double next = Math.BitIncrement(Math.BitIncrement(fraction));
        Assert.True(SweptBox.After(fraction) >= next);
        Assert.True(SweptBox.After(fraction) <= fraction * (1 + 1e-5) + 1e-43);
    }

    [Fact]
    public void APathIsARayWhereItsBoxIsAPoint()
    {
        var rng = new Rng(5);
        for (int i = 0; i < 1000; i++)
        {
            (Aabb box, Aabb start, Vector3 motion, float most) = Case(rng);
            var point = new Aabb(start.Min, start.Min);
            var path = new SweptBox(point, motion, most);
            var ray = new SweptBox(start.Min, motion, most);
            Assert.Equal(
                (path.Meets(box, path.Limit, out double a), a), (ray.Meets(box, ray.Limit, out double b), b));
        }
    }

    [Fact]
    public void ThreeAxesAtATimeSayWhatOneAtATimeSays()
    {
        for (int i = 0; i < Budget.Count(5_000); i++)
        {
            (Aabb box, Aabb start, Vector3 motion, float most) = Case(new Rng((ulong)i));
            var path = new SweptBox(start, motion, most);
            bool isMet = path.Meets(box, path.Limit, out double entry);
            bool isMetScalar = path.MeetsScalar(box.Min, box.Max, path.Limit, out double scalar);
            Assert.True((isMet, entry) == (isMetScalar, scalar), $"seed {i}: {entry:R}, one at a time {scalar:R}");
        }
    }

    [Fact]
    public void WhatIsNoPathIsRefused()
    {
        Vector3 one = Vector3.One, bad = new(0, float.NaN, 0), far = new(float.PositiveInfinity, 0, 0);
        var box = new Aabb(-one, one);
        foreach (Vector3 v in new[] { bad, far })
        {
            Refused("translation", () => new SweptBox(box, v));
            Refused("direction", () => new SweptBox(one, v));
            Refused("origin", () => new SweptBox(v, one));
        }

        foreach (float most in new[] { -1, float.NaN, -float.Epsilon })
        {
            Refused("maxFraction", () => new SweptBox(box, one, most));
            Refused("maxFraction", () => new SweptBox(one, one, most));
        }
    }

    private static void Refused(string name, Func<SweptBox> make) =>
        Assert.Equal(name, Assert.Throws<ArgumentOutOfRangeException>(() => make()).ParamName);

    /// <summary>Sizes of all kinds; coordinates on a coarse grid in half of them, so that ends and corners
    /// meet.</summary>
    private static (Aabb Box, Aabb Start, Vector3 Motion, float Most) Case(Rng rng)
    {
        float unit = rng.Below(4) switch { 0 => rng.LogFloat(1e-30, 1e30), 1 => 1e-44f, _ => 1 };
        Aabb box = Box(rng, unit, rng.Below(4) == 0 ? 0 : 3), start = Box(rng, unit, rng.Below(3) == 0 ? 0 : 1);
        Vector3 aim = Place(rng, box) - Place(rng, start);
        Vector3 motion = rng.Below(5) switch
        {
            0 => aim,
            1 or 2 => aim * rng.LogFloat(1e-2, 1e3),
            3 => new Vector3(aim.X, rng.Below(2) * aim.Y, 0),
            _ => new Vector3(aim.X, aim.Y * 1e-8f, aim.Z * 1e-30f),
        };
        if (rng.Below(30) == 0) motion = default;
        if (!Guard.IsFinite(motion)) motion = Vector3.UnitX;
        float most = rng.Below(3) switch { 0 => float.PositiveInfinity, 1 => 1, _ => rng.LogFloat(1e-3, 1e3) };
        return (box, start, motion, most);
    }

    private static Aabb Box(Rng rng, float unit, int side)
    {
        Vector3 min = Grid(rng, rng.Vector(-3, 3)), size = Grid(rng, rng.Vector(0, 1) * side);
        return new Aabb(min * unit, min * unit + Vector3.Abs(size) * unit);
    }

    private static Vector3 Grid(Rng rng, Vector3 v) => rng.Below(2) == 0 ? v
        : new Vector3(MathF.Round(v.X), MathF.Round(v.Y), MathF.Round(v.Z));

    /// <summary>A corner, the centre, or somewhere between.</summary>
    private static Vector3 Place(Rng rng, in Aabb box) => rng.Below(4) switch
    {
        0 => box.Min,
        1 => box.Max,
        2 => Vector3.Lerp(box.Min, box.Max, 0.5f),
        _ => Vector3.Lerp(box.Min, box.Max, rng.Float(0, 1)),
    };

    private static double Way(in Aabb box, in Aabb start)
    {
        Double3 a = (Double3)box.Max - start.Min, b = (Double3)start.Max - box.Min;
        return Math.Max(Math.Max(Math.Max(a.X, a.Y), a.Z), Math.Max(Math.Max(b.X, b.Y), b.Z));
    }

    /// <summary>The fractions at which the closed boxes begin and cease to overlap; the first is later if
    /// never.</summary>
    private static (Fraction Entry, Fraction Exit) Exact(in Aabb box, in Aabb start, Vector3 motion, float most)
    {
        Fraction entry = 0.0, exit = float.IsInfinity(most) ? 1e300 : (double)most;
        for (int i = 0; i < 3; i++)
        {
            Fraction low = (Fraction)(double)box.Min[i] - (double)start.Max[i];
            Fraction high = (Fraction)(double)box.Max[i] - (double)start.Min[i];
            if (motion[i] == 0)
            {
                if (low.Sign > 0 || high.Sign < 0) return (1.0, 0.0);
                continue;
            }

            Fraction first = Positive(low / (double)motion[i]), last = Positive(high / (double)motion[i]);
            if (motion[i] < 0) (first, last) = (last, first);
            entry = entry <= first ? first : entry;
            exit = last <= exit ? last : exit;
        }

        return (entry, exit);
    }

    private static Fraction Positive(Fraction x) =>
        x.Denominator.Sign < 0 ? new Fraction(-x.Numerator, -x.Denominator) : x;
}
