namespace Gjk.Core;

public static partial class PairBatch
{
    /// <summary>Pairs per share where shapes are not convex: each costs as much as many convex ones.</summary>
    internal const int ConcaveShareLength = 8;

    /// <summary>How far apart each pair of shapes is, which need not be convex.</summary>
    /// <param name="shapes">The shapes.</param>
    /// <param name="poses">Where they are, one for each shape.</param>
    /// <param name="pairs">Indices into the two; each pair has the place that it had in the last call.</param>
    /// <param name="results">At least as long as the pairs; gets what <see cref="ConcaveQuery"/> says.</param>
    /// <param name="scratch">Memory for all threads' searches.</param>
    /// <param name="warmStarts">At least as long as the pairs, and updated; null for cold queries.</param>
    /// <param name="maxDistance">As in <see cref="ConcaveQuery"/>: pairs that are further apart are done early.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <param name="cancellation">Looked at every few pairs.</param>
    /// <exception cref="ArgumentNullException">An array or the scratch is null.</exception>
    /// <exception cref="ArgumentException">The lengths do not fit, or a pair's index is outside; the message names the
    /// pair.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The largest distance is NaN.</exception>
    /// <exception cref="OperationCanceledException">Cancelled; some of the results and warm starts are written, the
    /// rest is as it was.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public static void Distance(
        AnyShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, PairDistance[] results, ConcaveScratch scratch,
        PartWarmStart[]? warmStarts = null, float maxDistance = float.PositiveInfinity, Workers? workers = null,
        CancellationToken cancellation = default)
    {
        Check(shapes, poses, pairs, Guard.NotNull(results, nameof(results)).Length);
        Guard.NotNull(scratch, nameof(scratch));
        if (warmStarts is not null && warmStarts.Length < pairs.Length)
            throw new ArgumentException("There must be at least as many warm starts as pairs.", nameof(warmStarts));
        Guard.NotNaN(maxDistance, nameof(maxDistance));
        Workers.Run(
            workers, new ConcaveDistanceJob(shapes, poses, pairs, results, scratch, warmStarts, maxDistance),
            pairs.Length, ConcaveShareLength, cancellation);
    }

    private readonly struct ConcaveDistanceJob(
        AnyShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, PairDistance[] results, ConcaveScratch scratches,
        PartWarmStart[]? warmStarts, float maxDistance) : IShareJob
    {
        public void Run(int begin, int end)
        {
            ConcaveScratch scratch = scratches.Rent();
            for (int i = begin; i < end; i++)
            {
                (int a, int b) = (pairs[i].A, pairs[i].B);
                PartWarmStart cold = default;
                ref PartWarmStart start = ref cold;
                if (warmStarts is not null) start = ref warmStarts[i];
                results[i] = ConcaveQuery.Distance(
                    shapes[a], poses[a], shapes[b], poses[b], ref start, scratch, maxDistance);
            }

            scratches.Return(scratch);
        }
    }
}
