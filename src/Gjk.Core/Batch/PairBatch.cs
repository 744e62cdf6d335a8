namespace Gjk.Core;

/// <summary>One question about many pairs: shapes, poses and pairs in, results out, in the order of the pairs and with
/// the same bits for one thread or many. It keeps nothing between calls, so the pairs may be spread over as many
/// machines as there are.</summary>
/// <remarks>Thread-safe as long as nobody writes to the arrays. Arguments are checked before anything is written. A
/// <c>default</c> shape or pose among them gives <see cref="GjkStatus.InvalidInput"/> for its pairs alone.</remarks>
public static partial class PairBatch
{
    /// <summary>Pairs per share: some 20 to 100 microseconds of work, long against the taking of a share, short against
    /// a frame.</summary>
    internal const int ShareLength = 128;

    /// <summary>Whether each pair overlaps.</summary>
    /// <param name="shapes">The shapes.</param>
    /// <param name="poses">Where they are, one for each shape.</param>
    /// <param name="pairs">Indices into the two.</param>
    /// <param name="results">At least as long as the pairs; gets <see cref="GjkStatus.Overlapping"/>,
    /// <see cref="GjkStatus.Separated"/>, or why there is no answer.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <param name="cancellation">Looked at every hundred pairs or so.</param>
    /// <exception cref="ArgumentNullException">An array is null.</exception>
    /// <exception cref="ArgumentException">The lengths do not fit, or a pair's index is outside; the message names the
    /// pair.</exception>
    /// <exception cref="OperationCanceledException">Cancelled; some of the results are written, the rest is as it
    /// was.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public static void Overlaps(
        ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, GjkStatus[] results, Workers? workers = null,
        CancellationToken cancellation = default)
    {
        Check(shapes, poses, pairs, Guard.NotNull(results, nameof(results)).Length);
        Workers.Run(workers, new OverlapJob(shapes, poses, pairs, results), pairs.Length, ShareLength, cancellation);
    }

    /// <summary>How far apart each pair is.</summary>
    /// <param name="shapes">The shapes.</param>
    /// <param name="poses">Where they are, one for each shape.</param>
    /// <param name="pairs">Indices into the two.</param>
    /// <param name="results">At least as long as the pairs.</param>
    /// <param name="maxDistance">As in <see cref="ConvexQuery"/>: pairs that are further apart are done early.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <param name="cancellation">Looked at every hundred pairs or so.</param>
    /// <exception cref="ArgumentNullException">An array is null.</exception>
    /// <exception cref="ArgumentException">The lengths do not fit, or a pair's index is outside; the message names the
    /// pair.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The largest distance is NaN.</exception>
    /// <exception cref="OperationCanceledException">Cancelled; some of the results are written, the rest is as it
    /// was.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public static void Distance(
        ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, DistanceResult[] results,
        float maxDistance = float.PositiveInfinity, Workers? workers = null, CancellationToken cancellation = default)
    {
        Check(shapes, poses, pairs, Guard.NotNull(results, nameof(results)).Length);
        Guard.NotNaN(maxDistance, nameof(maxDistance));
        Workers.Run(
            workers, new DistanceJob(shapes, poses, pairs, results, null, maxDistance), pairs.Length,
            ShareLength, cancellation);
    }

    /// <summary>As the other, each pair beginning where its last query ended: much faster for pairs that move
    /// little.</summary>
    /// <param name="shapes">The shapes.</param>
    /// <param name="poses">Where they are, one for each shape.</param>
    /// <param name="pairs">Indices into the two; each pair has the place that it had in the last call.</param>
    /// <param name="results">At least as long as the pairs.</param>
    /// <param name="warmStarts">At least as long as the pairs; updated. Cleared ones are cold starts.</param>
    /// <param name="maxDistance">As in <see cref="ConvexQuery"/>.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <param name="cancellation">Looked at every hundred pairs or so.</param>
    /// <exception cref="ArgumentNullException">An array is null.</exception>
    /// <exception cref="ArgumentException">The lengths do not fit, or a pair's index is outside; the message names the
    /// pair.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The largest distance is NaN.</exception>
    /// <exception cref="OperationCanceledException">Cancelled; some of the results and warm starts are written, the
    /// rest is as it was.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public static void Distance(
        ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, DistanceResult[] results, WarmStart[] warmStarts,
        float maxDistance = float.PositiveInfinity, Workers? workers = null, CancellationToken cancellation = default)
    {
        Check(shapes, poses, pairs, Guard.NotNull(results, nameof(results)).Length);
        if (Guard.NotNull(warmStarts, nameof(warmStarts)).Length < pairs.Length)
            throw new ArgumentException("There must be at least as many warm starts as pairs.", nameof(warmStarts));
        Guard.NotNaN(maxDistance, nameof(maxDistance));
        Workers.Run(
            workers, new DistanceJob(shapes, poses, pairs, results, warmStarts, maxDistance), pairs.Length,
            ShareLength, cancellation);
    }

    /// <summary>How far apart each pair is, or how deep it overlaps.</summary>
    /// <param name="shapes">The shapes.</param>
    /// <param name="poses">Where they are, one for each shape.</param>
    /// <param name="pairs">Indices into the two.</param>
    /// <param name="results">At least as long as the pairs; gets what <see cref="ConvexQuery"/> says.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <param name="cancellation">Looked at every hundred pairs or so.</param>
    /// <exception cref="ArgumentNullException">An array is null.</exception>
    /// <exception cref="ArgumentException">The lengths do not fit, or a pair's index is outside; the message names the
    /// pair.</exception>
    /// <exception cref="OperationCanceledException">Cancelled; some of the results are written, the rest is as it
    /// was.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public static void SignedDistance(
        ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, DistanceResult[] results, Workers? workers = null,
        CancellationToken cancellation = default)
    {
        Check(shapes, poses, pairs, Guard.NotNull(results, nameof(results)).Length);
        Workers.Run(
            workers, new SignedDistanceJob(shapes, poses, pairs, results), pairs.Length, ShareLength, cancellation);
    }

    private static void Check<TShape>(TShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, int resultCount)
    {
        Guard.NotNull(shapes, nameof(shapes));
        Guard.NotNull(poses, nameof(poses));
        Guard.NotNull(pairs, nameof(pairs));
        if (poses.Length != shapes.Length)
            throw new ArgumentException("There must be as many poses as shapes.", nameof(poses));
        if (resultCount < pairs.Length)
            throw new ArgumentException("There must be at least as many results as pairs.", "results");
        for (int i = 0; i < pairs.Length; i++)
        {
            if ((uint)pairs[i].A >= (uint)shapes.Length || (uint)pairs[i].B >= (uint)shapes.Length)
                throw new ArgumentException(
                    FormattableString.Invariant($"Pair {i} is {pairs[i]}, but there are {shapes.Length} shapes."),
                    nameof(pairs));
        }
    }

    private readonly struct SignedDistanceJob(
        ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, DistanceResult[] results) : IShareJob
    {
        public void Run(int begin, int end)
        {
            for (int i = begin; i < end; i++)
            {
                (int a, int b) = (pairs[i].A, pairs[i].B);
                PairQuery.SignedDistance(shapes[a], poses[a], shapes[b], poses[b], out results[i]);
            }
        }
    }

    private readonly struct OverlapJob(
        ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, GjkStatus[] results) : IShareJob
    {
        public void Run(int begin, int end)
        {
#if NET
            if (WideBatch.IsSupported)
            {
                var question = new WideOverlaps(ref results[begin]);
                new WideBatch(shapes, poses, ref pairs[begin], ref Unsafe.NullRef<bool>())
                    .Run(end - begin, ref question);
                return;
            }
#endif
            for (int i = begin; i < end; i++)
            {
                (int a, int b) = (pairs[i].A, pairs[i].B);
                ConvexQuery.Overlaps(shapes[a], poses[a], shapes[b], poses[b], out results[i]);
            }
        }
    }

    private readonly struct DistanceJob(
        ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, DistanceResult[] results, WarmStart[]? warmStarts,
        float maxDistance) : IShareJob
    {
        public unsafe void Run(int begin, int end)
        {
#if NET
            if (WideBatch.IsSupported)
            {
                ref WarmStart first = ref Unsafe.NullRef<WarmStart>();
                if (warmStarts is not null) first = ref warmStarts[begin];
                var question = new WideDistances(ref results[begin], ref first, maxDistance);
                new WideBatch(shapes, poses, ref pairs[begin], ref Unsafe.NullRef<bool>())
                    .Run(end - begin, ref question);
                return;
            }
#endif
            fixed (WarmStart* starts = warmStarts)
            {
                for (int i = begin; i < end; i++)
                {
                    (int a, int b) = (pairs[i].A, pairs[i].B);
                    WarmStart* warm = starts == null ? null : starts + i;
                    PairQuery.Distance(shapes[a], poses[a], shapes[b], poses[b], warm, maxDistance, out results[i]);
                }
            }
        }
    }
}
