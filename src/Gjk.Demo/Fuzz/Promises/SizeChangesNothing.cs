using System;
using System.Numerics;
using Gjk.Core;

namespace Gjk.Demo.Fuzz.Promises;

/// <summary>A pair in another unit of length has the same answer in that unit. The factors are powers of two, so that the larger and the smaller pair are exactly the same.</summary>
internal sealed class SizeChangesNothing : IPromise
{
    private const float Least = 1e-30f, Most = 1e30f;

    public string Name => "another unit of length changes nothing";

    public string? Broken(FuzzPair pair)
    {
        if (pair.A.Scale != Vector3.One || pair.B.Scale != Vector3.One) return null;
        foreach (float factor in (ReadOnlySpan<float>)[1024, 1f / 1024])
        {
            Vector3 a = pair.PoseA.Position * factor, b = pair.PoseB.Position * factor;
            if (!IsExact(a) || !IsExact(b)) continue;
            var scale = new Vector3(factor);
            DistanceResult r = ConvexQuery.Distance(
                pair.A.Scaled(scale), new RigidPose(pair.PoseA.Rotation, a), pair.B.Scaled(scale), new RigidPose(pair.PoseB.Rotation, b));
            string? problem = Same.Problem(pair, r, Say.Line($"times {factor}"), 1 / factor);
            if (problem is not null) return problem;
        }

        return null;
    }

    /// <summary>Far from where floats lose digits or end.</summary>
    private static bool IsExact(Vector3 v) => IsExact(v.X) && IsExact(v.Y) && IsExact(v.Z);

    private static bool IsExact(float x) => x == 0 || Math.Abs(x) is > Least and < Most;
}
