using Gjk.Exact.Certificates;

namespace Gjk.Bench;

/// <summary>Makes sure that what is timed is a depth: every pair overlaps, none ends at the iteration limit, and each
/// answer is proved from the shapes' supports alone to be a way out.</summary>
public static class DepthCheck
{
    /// <exception cref="FactorCheckException">A pair does not overlap, or its answer is wrong.</exception>
    public static void Run(string name, BenchScene scene)
    {
        foreach (BenchScene.Pair pair in scene.Pairs)
        {
            ref ConvexShape a = ref scene.Shapes[pair.A], b = ref scene.Shapes[pair.B];
            ref RigidPose poseA = ref scene.Poses[pair.A], poseB = ref scene.Poses[pair.B];
            DistanceResult depth = ConvexQuery.SignedDistance(a, poseA, b, poseB);
            string? problem = !IsDepth(depth) ? "it is no depth"
                : !ConvexQuery.Overlaps(a, poseA, b, poseB) ? "the boolean finds no overlap"
                : Certificate.ProblemOfSigned(a, poseA, b, poseB, depth, Math.Max(Motion.Size(a), Motion.Size(b)));
            if (problem is null) continue;
            throw new FactorCheckException(string.Create(
                CultureInfo.InvariantCulture,
                $"{name}, pair {pair.A}-{pair.B}: {depth.Status}, {depth.Distance}; {problem}"));
        }
    }

    /// <summary>True if the shapes overlap, and the depth is known.</summary>
    public static bool IsDepth(in DistanceResult result) =>
        result.Status == GjkStatus.Overlapping && result.Distance < 0 && float.IsFinite(result.Distance);
}
