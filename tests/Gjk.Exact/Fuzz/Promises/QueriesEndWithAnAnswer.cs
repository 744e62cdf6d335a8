namespace Gjk.Exact.Fuzz.Promises;

/// <summary>A valid pair gets an answer: no cap is reached, no input called invalid, no NaN.</summary>
internal static class QueriesEndWithAnAnswer
{
    public static string? Broken(FuzzPair pair)
    {
        DistanceResult r = pair.Answer;
        if (r.Status is not (GjkStatus.Separated or GjkStatus.Overlapping))
            return $"status {r.Status} after {r.Iterations} iterations";
        if (!float.IsFinite(r.Distance) || !float.IsFinite(r.LowerBound) || r.Distance < 0 || r.LowerBound < 0)
            return Say.Line($"distance {r.Distance}, lower bound {r.LowerBound}");
        System.ReadOnlySpan<Vector3> vectors = [r.PointA, r.PointB, r.Normal, r.LocalPointA, r.LocalPointB];
        foreach (Vector3 v in vectors)
        {
            if (!float.IsFinite(v.X) || !float.IsFinite(v.Y) || !float.IsFinite(v.Z))
                return Say.Line($"a point or the normal is {v}");
        }

        return null;
    }
}
