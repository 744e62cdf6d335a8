using System;
using System.Collections.Generic;
using System.Linq;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Cases;

/// <summary>Casts whose outcomes, fractions and normals are proved.</summary>
public class HardCastTests
{
    public static TheoryData<string> Families => [.. CastFamily.Names];

    /// <summary>
    /// Every outcome as in the truth, but within a graze of 1e-9 of the size; the way within 1e-7 of the size or the
    /// way; the normal, where it is the only one, within 1e-6.
    /// </summary>
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
            else if (c.IsNormalUnique && ((Vector3D)r.Normal - c.Normal).Length > 1e-6)
                faults.Add($"{c.Pair}: {r}, the normal truly {c.Normal}");
        }

        Assert.True(faults.Count == 0, $"{faults.Count}: " + string.Join("\n", faults.Take(12)));
    }
}
