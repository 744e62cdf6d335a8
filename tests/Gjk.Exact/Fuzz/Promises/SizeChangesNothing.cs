namespace Gjk.Exact.Fuzz.Promises;

/// <summary>A pair in another unit of length has the same answer in that unit. The factors are powers of two, so that
/// the larger and the smaller pair are exactly the same.</summary>
internal static class SizeChangesNothing
{
    private const float Least = 1e-30f, Most = 1e30f;

    public static string? Broken(FuzzPair pair)
    {
        foreach (float factor in (ReadOnlySpan<float>)[1024, 1f / 1024, 1L << 50, 1f / (1L << 50)])
        {
            Vector3 a = pair.PoseA.Position * factor, b = pair.PoseB.Position * factor;
            if (!(factor * (pair.Scale + pair.Centers.Length) < Most)) continue;
            if (!IsExact(a) || !IsExact(b) || !TryResize(pair.A, factor, out ConvexShape shapeA)
                || !TryResize(pair.B, factor, out ConvexShape shapeB))
                continue;
            DistanceResult r = ConvexQuery.Distance(
                shapeA, new RigidPose(pair.PoseA.Rotation, a), shapeB, new RigidPose(pair.PoseB.Rotation, b));
            string? problem = Same.Problem(pair, r, Say.Line($"times {factor}"), 1 / factor);
            if (problem is not null) return problem;
        }

        return null;
    }

    /// <summary>False for what keeps its factors and is no mesh: the shape inside cannot be had.</summary>
    private static bool TryResize(in ConvexShape shape, float factor, out ConvexShape resized)
    {
        resized = default;
        Vector3 factors = shape.Scale * factor;
        if (!IsExact(factors) || factors.X == 0 || (shape.Hull is null && shape.Scale != Vector3.One)) return false;
        resized = (shape.Hull is { } hull ? ConvexShape.Mesh(hull) : shape).Scaled(factors);
        return true;
    }

    /// <summary>Far from where floats lose digits or end.</summary>
    private static bool IsExact(Vector3 v) => IsExact(v.X) && IsExact(v.Y) && IsExact(v.Z);

    private static bool IsExact(float x) => x == 0 || Math.Abs(x) is > Least and < Most;
}
