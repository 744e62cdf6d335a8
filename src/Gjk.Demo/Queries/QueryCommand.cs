using System.Threading;
using Gjk.Core;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Queries;

/// <summary>
/// Computes the distance, or the signed distance, of every pair of a scene in the poses of its first frame, and writes
/// the answers as CSV.
/// </summary>
internal static class QueryCommand
{
    /// <param name="scene">The scene.</param>
    /// <param name="table">The table to write.</param>
    /// <param name="maxDistance">Pairs further apart are reported as such, without a distance. +infinity asks for all
    /// distances.</param>
    /// <param name="depth">Whether overlapping pairs are answered with their depth.</param>
    /// <param name="cancel">Ends the work. No file is left then.</param>
    /// <returns>The exit code.</returns>
    public static int Run(Scene scene, PairTable table, float maxDistance, bool depth, CancellationToken cancel)
    {
        SceneObject[] objects = scene.Objects;
        return table.Write(
            CsvWriter.Distances,
            (rows, a, b) =>
            {
                DistanceResult answer = Answer(objects[a], objects[b], maxDistance, depth);
                rows.Write(a, b, answer, table.IsChecked ? Check(objects[a], objects[b], answer, depth) : default);
            },
            cancel);
    }

    private static DistanceResult Answer(SceneObject a, SceneObject b, float maxDistance, bool depth)
    {
        if (depth && float.IsPositiveInfinity(maxDistance))
            return ConvexQuery.SignedDistance(a.Shape, a.Pose, b.Shape, b.Pose);
        DistanceResult result = ConvexQuery.Distance(a.Shape, a.Pose, b.Shape, b.Pose, maxDistance);
        return depth && result.IsOverlapping
            ? ConvexQuery.SignedDistance(a.Shape, a.Pose, b.Shape, b.Pose)
            : result;
    }

    private static CheckStatus Check(SceneObject a, SceneObject b, in DistanceResult answer, bool depth) => (depth
        ? AnswerCheck.SignedDistance(a.Shape, a.Pose, b.Shape, b.Pose, answer)
        : AnswerCheck.Distance(a.Shape, a.Pose, b.Shape, b.Pose, answer)).Status;
}
