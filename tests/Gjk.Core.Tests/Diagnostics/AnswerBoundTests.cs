using Gjk.Core.Tests.Support.Rays;

namespace Gjk.Core.Tests.Diagnostics;

/// <summary>What the check trusts: the gap between two planes, as it computes it, is the true one to within its noise,
/// and the noise is small enough to prove what matters.</summary>
public class AnswerBoundTests
{
    /// <summary>In units of the noise; computed with 640 digits.</summary>
    [Theory]
    [InlineData("hull")]
    [InlineData("needle")]
    [InlineData("box")]
    [InlineData("madeFarOff")]
    [InlineData("madeUneven")]
    public void AGapIsTrueToItsNoise(string kind)
    {
        double worst = 0;
        for (ulong i = 0; i < (ulong)Budget.Few(400); i++)
        {
            TestPair p = Generators.Pair(i, [kind, "hull"]);
            ConvexShape a = p.A.Shape, b = p.B.Shape;
            PosedPair.Of(ref a, p.PoseA, ref b, p.PoseB, out PosedPair pair);
            Double3 n = new Rng(i).UnitVector();
            Assert.True(PosedPair.TryUnit(n, out n));
            double error = Math.Abs(pair.Gap(ref a, ref b, n, out _) - TrueGap(p, n));
            worst = Math.Max(worst, error / pair.Noise);

            // No more than is derived: what is far from its own origin is placed in double-double.
            double offset = a.Center.SumOfMagnitudes + b.Center.SumOfMagnitudes;
            double turned = pair.Size + (offset > 4 * pair.Size ? 0 : offset);
            double most = 8e-15 * turned + 2.4e-15 * (pair.Size + pair.Between.SumOfMagnitudes);
            Assert.True(pair.Noise <= most, $"noise {pair.Noise:R}, at most {most:R}\n{p}");
        }

        // The derived bound is for the worst of all pairs; what occurs is a part of it, but no small one.
        Assert.InRange(worst, 0.01, 1);
    }

    /// <summary>Moved and swept pairs carry what was lost on the way.</summary>
    [Fact]
    public void AMovedGapIsTrueToItsNoise()
    {
        for (ulong i = 0; i < (ulong)Budget.Few(400); i++)
        {
            var rng = new Rng(i);
            TestPair p = Generators.Pair(i, ["hull", "box"]);
            ConvexShape a = p.A.Shape, b = p.B.Shape;
            Double3 n = rng.UnitVector(), far = (Double3)rng.UnitVector() * rng.LogFloat(1, 1e12);
            Assert.True(PosedPair.TryUnit(n, out n));
            PosedPair.Of(ref a, p.PoseA, ref b, p.PoseB, out PosedPair pair);
            PosedPair back = pair.Moved(far).Moved(-far);
            double error = Math.Abs(back.Gap(ref a, ref b, n, out _) - TrueGap(p, n));
            Assert.True(error <= back.Noise, $"{error:R} of {back.Noise:R}\n{p}");
        }
    }

    private static double TrueGap(TestPair p, in Double3 n)
    {
        FixedVector unit = n;
        Fixed least = p.B.Vertices!.Select(v => FixedVector.Dot(unit, World(v, p.PoseB))).Aggregate(Least);
        Fixed most = p.A.Vertices!.Select(v => FixedVector.Dot(unit, World(v, p.PoseA))).Aggregate(Most);
        return (double)((least - most - (Fixed)p.A.Margin - (Fixed)p.B.Margin) / unit.Length);

        static Fixed Least(Fixed x, Fixed y) => x < y ? x : y;
        static Fixed Most(Fixed x, Fixed y) => x > y ? x : y;
    }

    /// <summary>v + 2 u × (u × v + w v) / |q|², and the position.</summary>
    private static FixedVector World(in Double3 local, in RigidPose pose)
    {
        Quaternion q = pose.Rotation;
        FixedVector v = local, u = new Double3(q.X, q.Y, q.Z);
        Fixed w = q.W, norm = FixedVector.Dot(u, u) + w * w;
        return v + FixedVector.Cross(u, FixedVector.Cross(u, v) + v * w) * ((Fixed)2.0 / norm) + pose.Position;
    }
}
