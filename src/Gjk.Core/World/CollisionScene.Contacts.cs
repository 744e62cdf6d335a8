namespace Gjk.Core;

public sealed partial class CollisionScene
{
    /// <summary>The pairs whose depth or contacts are computed.</summary>
    private readonly List<ObjectPair> _touching = [];

    private readonly PairAnswers<PairDistance> _depths = new();
    private readonly PairAnswers<PairContacts> _contacts = new();
    private readonly SceneUnions _unions;

    /// <summary>Whether static objects that are flush, such as the tiles of a floor, count as one body in
    /// <see cref="FindContacts(float, List{PairContacts}, Workers)"/>: an object has no contact with a side of one that
    /// another one covers. Half-spaces are not joined. True unless it is set.</summary>
    public bool JoinsStatic { get; set; } = true;

    /// <summary>Which pairs are within the gap of the contacts.</summary>
    private readonly PairAnswers<GjkStatus> _within = new();

    private float _contactGap;

    /// <summary>The pairs that overlap, touching included, and how deep: with the bits of
    /// <c>ConvexQuery.SignedDistance</c>. Of objects that are not convex each pair of parts that overlaps has a depth
    /// of its own, as <c>ConcaveQuery.FindDepths</c> gives it. A pair whose objects have not moved since the last call
    /// keeps its answer, which costs next to nothing.</summary>
    /// <param name="results">Emptied first; then the pairs, sorted by ids and parts.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public void FindDepths(List<PairDistance> results, Workers? workers = null)
    {
        Guard.NotNull(results, nameof(results));
        CollectTouching(0, workers);
        _depths.HasLists = _objects.Concave.Any;
        AnswerPairs(_depths, _touching, new SceneDepthJob(_objects, _touching, _depths), workers);
        results.Clear();
        for (int i = 0; i < _depths.Count; i++)
        {
            if (_objects.Concave.Contains(_touching[i])) results.AddRange(_depths.AllFor(i));
            else results.Add(_depths[i]);
        }
    }

    /// <summary>The contact points of all pairs that overlap or are no further apart than a gap: with the bits of
    /// <c>ConvexQuery.Contacts</c>; of objects that are not convex one manifold for each pair of parts, with the bits
    /// of <c>ConcaveQuery.FindContacts</c>; less those at seams of static objects (<see cref="JoinsStatic"/>). A pair
    /// whose objects have not moved since the last call with the same gap keeps its answer, which costs next to
    /// nothing.</summary>
    /// <param name="maxGap">At least 0: points, and pairs, further apart are left out.</param>
    /// <param name="results">Emptied first; then the pairs, sorted by ids and parts.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The gap is negative or NaN.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public void FindContacts(float maxGap, List<PairContacts> results, Workers? workers = null)
    {
        Guard.NotNull(results, nameof(results));
        Guard.NonNegativeOrInfinite(maxGap, nameof(maxGap));
        if (maxGap != _contactGap)
        {
            _within.Forget();
            _contacts.Forget();
        }

        _contactGap = maxGap;
        CollectTouching(maxGap, workers);
        MakeContacts(_touching, _contacts, _unions, maxGap, results, workers, isKept: true);
    }

    private void MakeContacts(
        List<ObjectPair> pairs, PairAnswers<PairContacts> answers, SceneUnions unions, float maxGap,
        List<PairContacts> results, Workers? workers, bool isKept)
    {
        unions.Collect(pairs, JoinsStatic);
        answers.HasLists |= _objects.Concave.Any || unions.Count > 0;
        var job = new SceneContactJob(_objects, pairs, answers, unions, maxGap);
        var joined = new SceneUnionJob(_objects, pairs, answers, unions, maxGap);
        answers.BeginFrame(pairs, _objects.Ids, ref _calls, isKept);
        Workers.Run(workers, job, pairs.Count, _objects.Concave.ShareLength);
        Workers.Run(workers, joined, unions.Count, PairBatch.ConcaveShareLength);
        answers.CompleteFrame();
        results.Clear();
        for (int i = 0; i < answers.Count; i++)
        {
            if (unions.IsJoined(i) || _objects.Concave.Contains(pairs[i])) results.AddRange(answers.AllFor(i));
            else if (answers[i].Manifold.Count > 0) results.Add(answers[i]);
        }
    }

    /// <summary>Collects the pairs that may touch: the convex ones that a distance query finds near enough, and all
    /// others.</summary>
    private void CollectTouching(float maxGap, Workers? workers)
    {
        CollectSlots(maxGap, _candidates, workers);
        PairAnswers<GjkStatus> near = maxGap > 0 ? _within : _overlaps;
        DecideNear(near, maxGap, workers, includesConcave: false);
        _touching.Clear();
        for (int i = 0; i < _candidates.Count; i++)
        {
            bool isNear = maxGap > 0 ? near[i] != GjkStatus.BeyondMaxDistance : near[i] == GjkStatus.Overlapping;
            if (isNear || _objects.Concave.Contains(_candidates[i])) _touching.Add(_candidates[i]);
        }
    }
}
