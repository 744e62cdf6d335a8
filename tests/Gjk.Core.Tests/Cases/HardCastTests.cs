namespace Gjk.Core.Tests.Cases;

/// <summary>Casts whose outcomes, fractions and normals are proved.</summary>
public class HardCastTests
{
    public static TheoryData<string> Families => [.. CastFamily.Names];

    /// <summary>Every outcome as in the truth, but within a graze of 1e-9 of the size; the way within 1e-7 of the size
    /// or the way; the normal, where it is the only one, within 1e-6.</summary>
    [Theory]
    [MemberData(nameof(Families))]
    public void EveryCastIsExact(string family)
    {
        List<string> faults = [];
        foreach (CastCase c in CastFamily.Load(family))
        {
            CastResult r = c.Cast();
            double scale = Math.Max(c.Pair.A.LongestSide, c.Pair.B.LongestSide), way = c.Velocity.Length();
            if (r.Status != c.Outcome)
                faults.Add($"{c.Pair}: {r}, truly {c.Outcome} {c.Fraction:R}");
            else if (c.Outcome != CastStatus.Hit)
                continue;
            else if (Math.Abs(r.Fraction - c.Fraction) * way > 1e-7 * Math.Max(scale, c.Fraction * way))
                faults.Add($"{c.Pair}: {r}, truly {c.Fraction:R}");
            else if (c.IsNormalUnique && ((Double3)r.Normal - c.Normal).Length > 1e-6)
                faults.Add($"{c.Pair}: {r}, the normal truly {c.Normal}");
        }

        Assert.True(faults.Count == 0, $"{faults.Count}: " + string.Join("\n", faults.Take(12)));
    }

    /// <summary>Hulls that are flat but for rounding, whose faces' normals prove nothing: what a point meets, asked as
    /// a cast and as a ray.</summary>
    [Fact]
    public void FlatHullsAreMetWhereTheyAre()
    {
        IReadOnlyList<CastCase> cases = CastFamily.Load(CastFamily.Flat);
        List<string> faults = [];
        foreach (CastCase c in cases)
        {
            CastResult cast = c.Cast();
            RayCastResult ray = c.Ray();
            bool isRight = cast.Status == c.Outcome && ray.Status == c.Outcome;
            if (isRight && c.Outcome == CastStatus.Hit)
            {
                isRight = Math.Abs(cast.Fraction - c.Fraction) <= 3e-6
                    && Math.Abs(ray.Distance / c.Velocity.Length() - c.Fraction) <= 3e-6;
            }

            if (!isRight) faults.Add($"{c.Pair}: {cast}, {ray}, truly {c.Outcome} {c.Fraction:R}");
        }

        Assert.InRange(cases.Count(c => c.Outcome == CastStatus.Hit), 150, cases.Count - 150);
        Assert.True(faults.Count == 0, $"{faults.Count}: " + string.Join("\n", faults.Take(12)));
    }
}
