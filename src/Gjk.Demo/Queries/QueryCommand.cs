namespace Gjk.Demo.Queries;

/// <summary>Computes the distance, or the signed distance, of every pair of a scene in the poses of its first frame,
/// and writes the answers as CSV.</summary>
internal static class QueryCommand
{
    /// <param name="scene">The scene.</param>
    /// <param name="table">The table to write.</param>
    /// <param name="maxDistance">Pairs further apart are reported as such, without a distance. +infinity asks for all
    /// distances.</param>
    /// <param name="onlyNear">Whether pairs further apart are left out.</param>
    /// <param name="depth">Whether overlapping pairs are answered with their depth.</param>
    /// <param name="parts">Whether two columns say which triangles or parts the distance is between.</param>
    /// <param name="cancel">Ends the work. No file is left then.</param>
    /// <returns>The exit code.</returns>
    public static int Run(
        Scene scene, PairTable table, float maxDistance, bool onlyNear, bool depth, bool parts,
        CancellationToken cancel)
    {
        SceneObject[] objects = scene.Objects;
        var scratch = new ConcaveScratch();
        return table.Write(
            CsvWriter.Distances + (parts ? CsvWriter.Parts : ""),
            (rows, a, b) =>
            {
                PairDistance answer = Answer(objects[a], objects[b], maxDistance, depth, scratch);
                // Two half-spaces have no distance, so they are not near.
                bool isFar = answer.Result.Status is GjkStatus.BeyondMaxDistance or GjkStatus.InvalidShape;
                if (onlyNear && isFar) return;
                CheckStatus verdict = table.IsChecked ? Check(objects[a], objects[b], answer.Result, depth) : default;
                if (parts) rows.Write(a, b, answer, verdict);
                else rows.Write(a, b, answer.Result, verdict);
            },
            cancel);
    }

    private static PairDistance Answer(
        SceneObject a, SceneObject b, float maxDistance, bool depth, ConcaveScratch scratch)
    {
        if (!depth || !float.IsPositiveInfinity(maxDistance))
        {
            PairDistance result = ConcaveQuery.Distance(a.Any, a.Pose, b.Any, b.Pose, scratch, maxDistance);
            if (!depth || !result.IsOverlapping) return result;
        }

        return ConcaveQuery.SignedDistance(a.Any, a.Pose, b.Any, b.Pose, scratch);
    }

    /// <summary>Supports of parts say nothing about the rest of a shape, so that its answer stays open.</summary>
    private static CheckStatus Check(SceneObject a, SceneObject b, in DistanceResult answer, bool depth)
    {
        if (!a.IsConvex || !b.IsConvex) return CheckStatus.Open;
        return (depth
            ? AnswerCheck.SignedDistance(a.Shape, a.Pose, b.Shape, b.Pose, answer)
            : AnswerCheck.Distance(a.Shape, a.Pose, b.Shape, b.Pose, answer)).Status;
    }
}
