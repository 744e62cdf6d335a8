namespace Gjk.Core;

public static partial class PairBatch
{
    /// <summary>When the shapes of each pair, which are translated, first touch.</summary>
    /// <param name="shapes">The shapes.</param>
    /// <param name="poses">Where they are at the start, one for each shape.</param>
    /// <param name="translations">Their motions over the fractions from 0 to 1, one for each shape. One that is not
    /// finite gives <see cref="CastStatus.InvalidInput"/> for its pairs alone.</param>
    /// <param name="pairs">Indices into the three.</param>
    /// <param name="results">At least as long as the pairs; gets what <see cref="ConvexQuery"/> says.</param>
    /// <param name="maxFraction">How much of the motion is looked at, as in <see cref="ConvexQuery"/>.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <param name="cancellation">Looked at every hundred pairs or so.</param>
    /// <param name="options">Which contacts are passed; by default none.</param>
    /// <exception cref="ArgumentNullException">An array is null.</exception>
    /// <exception cref="ArgumentException">The lengths do not fit, or a pair's index is outside; the message names the
    /// pair.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The largest fraction is NaN.</exception>
    /// <exception cref="OperationCanceledException">Cancelled; some of the results are written, the rest is as it
    /// was.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public static void Cast(
        ConvexShape[] shapes, RigidPose[] poses, Vector3[] translations, ObjectPair[] pairs, CastResult[] results,
        float maxFraction = 1, Workers? workers = null, CancellationToken cancellation = default,
        in CastOptions options = default)
    {
        Check(shapes, poses, pairs, Guard.NotNull(results, nameof(results)).Length);
        if (Guard.NotNull(translations, nameof(translations)).Length != shapes.Length)
            throw new ArgumentException("There must be as many translations as shapes.", nameof(translations));
        Guard.NotNaN(maxFraction, nameof(maxFraction));
        Workers.Run(
            workers, new CastJob(shapes, poses, translations, pairs, results, maxFraction, options), pairs.Length,
            ShareLength, cancellation);
    }

    private readonly struct CastJob(
        ConvexShape[] shapes, RigidPose[] poses, Vector3[] translations, ObjectPair[] pairs, CastResult[] results,
        float maxFraction, CastOptions options) : IShareJob
    {
        public void Run(int begin, int end)
        {
            for (int i = begin; i < end; i++)
            {
                (int a, int b) = (pairs[i].A, pairs[i].B);
                results[i] = ConvexQuery.Cast(
                    shapes[a], poses[a], translations[a], shapes[b], poses[b], translations[b], maxFraction, options);
            }
        }
    }
}
