namespace Gjk.Core;

public sealed partial class CollisionScene
{
    /// <summary>Ratio: four float roundings. A margin is rounded twice: when it is multiplied by this, and when it is
    /// added to a bound.</summary>
    private const float MarginSlack = 1 + 4f / (1 << 24);

    private readonly List<ObjectPair> _candidates = [];
    private readonly PairWarmStarts _pairWarmStarts = new();
    private readonly PairAnswers<GjkStatus> _overlaps = new();
    private readonly Selection<ObjectPair> _selected = new();

    /// <summary>The broad phase alone: the pairs whose bounds overlap, or are within a distance.</summary>
    /// <param name="candidates">Emptied first; then the pairs of ids, sorted.</param>
    /// <param name="distance">At least 0; may be infinite.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The distance is negative or NaN.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    /// <exception cref="InvalidOperationException">There are more pairs than <see cref="IBroadPhase"/> can
    /// find.</exception>
    public void CollectCandidates(List<ObjectPair> candidates, float distance = 0, Workers? workers = null)
    {
        Guard.NotNull(candidates, nameof(candidates));
        Guard.NonNegativeOrInfinite(distance, nameof(distance));
        CollectSlots(distance, candidates, workers);
        if (_objects.IsDirect) return;
        for (int i = 0; i < candidates.Count; i++) candidates[i] = _objects.IdsOf(candidates[i]);
    }

    /// <summary>The narrow phase alone: those pairs that do overlap.</summary>
    /// <param name="candidates">Pairs of ids, from <see cref="CollectCandidates"/> or of your own.</param>
    /// <param name="results">Emptied first; then the pairs that overlap, in the order of the candidates.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <exception cref="ArgumentNullException">A list is missing.</exception>
    /// <exception cref="ArgumentException">The two lists are the same, or there is no object with one of the ids; the
    /// message names the pair.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public void FindOverlapsAmong(List<ObjectPair> candidates, List<ObjectPair> results, Workers? workers = null)
    {
        Guard.NotNull(candidates, nameof(candidates));
        Guard.NotNull(results, nameof(results));
        if (ReferenceEquals(candidates, results))
            throw new ArgumentException("The results need a list of their own.", nameof(results));
        Workers.Check(workers);
        _candidates.Clear();
        for (int i = 0; i < candidates.Count; i++)
        {
            int a = _objects.SlotOf(candidates[i].A), b = _objects.SlotOf(candidates[i].B);
            if (a < 0 || b < 0)
            {
                throw new ArgumentException(
                    FormattableString.Invariant($"Pair {i}, {candidates[i]}, names an object that is not there."),
                    nameof(candidates));
            }
            _candidates.Add(new ObjectPair(a, b));
        }

        // The candidates may come in any order, so no answer is kept from the last frame or for the next one.
        DecideNear(_overlaps, 0, workers, isKept: false);
        CopyOverlaps(results, workers);
    }

    /// <summary>The pairs that overlap, touching included.</summary>
    /// <param name="results">Emptied first; then the pairs of ids, sorted.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public void FindOverlaps(List<ObjectPair> results, Workers? workers = null)
    {
        Guard.NotNull(results, nameof(results));
        CollectSlots(0, _candidates, workers);
        DecideNear(_overlaps, 0, workers);
        CopyOverlaps(results, workers);
    }

    /// <summary>The pairs no further apart than a distance, and how far. A pair whose objects have not moved since the
    /// last call reported it keeps its answer, bit for bit. The query of any other pair that the last call reported
    /// begins where that one ended, if both are convex; so the results are those of <see cref="ConvexQuery"/> within
    /// the accuracy, not always to the last bit. They depend on what was reported for the pair before, and are the same
    /// bits for every broad phase and bound.</summary>
    /// <param name="distance">At least 0; infinite for all pairs.</param>
    /// <param name="results">Emptied first; then the pairs of ids, sorted.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The distance is negative or NaN.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    /// <exception cref="InvalidOperationException">There are more pairs than <see cref="IBroadPhase"/> can
    /// find.</exception>
    public void FindPairsWithin(float distance, List<PairDistance> results, Workers? workers = null)
    {
        Guard.NotNull(results, nameof(results));
        Guard.NonNegativeOrInfinite(distance, nameof(distance));
        CollectSlots(distance, _candidates, workers);
        var job = new SceneDistanceJob(_objects, _candidates, _pairWarmStarts, distance);
        AnswerPairs(_pairWarmStarts, _candidates, job, workers);
        results.Clear();
        for (int i = 0; i < _candidates.Count; i++)
            if (_pairWarmStarts.Now.Results[i].Status != GjkStatus.BeyondMaxDistance)
                results.Add(DistanceOf(i));
    }

    /// <summary>The distance from one object (A) to another (B), with the bits of <see cref="ConvexQuery"/>.</summary>
    /// <param name="idA">The first object.</param>
    /// <param name="idB">The second object, another one.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with one of the ids, or no longer.</exception>
    /// <exception cref="ArgumentException">The two are the same.</exception>
    public DistanceResult Distance(int idA, int idB)
    {
        int a = _objects.RequireSlot(idA, nameof(idA)), b = _objects.RequireSlot(idB, nameof(idB));
        if (a == b) throw new ArgumentException("An object has no distance to itself.", nameof(idB));
        return _objects.Concave.Distance(a, b, float.PositiveInfinity).Result;
    }

    /// <summary>The distance that was found for the i-th pair.</summary>
    private PairDistance DistanceOf(int i)
    {
        ObjectPair ids = _objects.IdsOf(_candidates[i]);
        ref readonly DistanceResult found = ref _pairWarmStarts.Now.Results[i];
        if (!_objects.Concave.Contains(_candidates[i])) return new PairDistance(found, pair: ids);
        ObjectPair parts = _pairWarmStarts.Now.Parts[i];
        return new PairDistance(found, parts.A, parts.B, ids);
    }

    /// <summary>Decides which of the candidates overlap, or are no further apart than a gap.</summary>
    private void DecideNear(
        PairAnswers<GjkStatus> answers, float maxGap, Workers? workers, bool includesConcave = true, bool isKept = true)
    {
        AnswerPairs(
            answers, _candidates, new SceneNearJob(_objects, _candidates, answers, maxGap, includesConcave), workers,
            isKept && _objects.AreMostAtRest(answers.Call));
    }

    /// <summary>Runs a job that finds the answers of a frame's pairs.</summary>
    private void AnswerPairs<TJob>(
        PairHistory frame, List<ObjectPair> pairs, in TJob job, Workers? workers, bool isKept = true)
        where TJob : struct, IShareJob
    {
        frame.BeginFrame(pairs, _objects.Ids, ref _calls, isKept);
        Workers.Run(workers, job, pairs.Count, _objects.Concave.ShareLength);
        frame.CompleteFrame();
    }

    private void CopyOverlaps(List<ObjectPair> results, Workers? workers)
    {
        results.Clear();
        _selected.Collect(
            new OverlappingPairs(_objects, _candidates, _overlaps), _candidates.Count, results, workers);
    }

    /// <summary>Selects the pairs that overlap, with their ids.</summary>
    private readonly struct OverlappingPairs(
        SceneObjects objects, List<ObjectPair> candidates, PairAnswers<GjkStatus> answers) : ISelector<ObjectPair>
    {
        public bool TrySelect(int index, out ObjectPair item)
        {
            item = objects.IdsOf(candidates[index]);
            return answers[index] == GjkStatus.Overlapping;
        }
    }
}
