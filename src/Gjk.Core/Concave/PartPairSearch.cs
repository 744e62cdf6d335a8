namespace Gjk.Core;

/// <summary>The pair of parts with the least distance: pairs of boxes wait in a heap, the least bound first, the larger
/// box of a pair is opened, and two leaves' parts are asked one by one, by the exact query.</summary>
/// <remarks>Source: branch and bound over two trees (Quinlan, "Efficient distance computation between non-convex
/// objects", 1994; Johnson and Cohen, 1998, best first). Exactness: a pair of boxes is dropped only if its bound, which
/// is proved, exceeds the least distance that a query of two parts has given, or if a <see cref="PlaneProof"/> says
/// that none of its parts are nearer than that. So the answer is the least of all pairs' answers, whatever the trees
/// are like. It ends: each pair of boxes enters the heap once at most, and each step takes one out. Which of several
/// pairs with the same float distance is named depends on the trees, which depend on the input alone.</remarks>
internal struct PartPairSearch
{
    /// <summary>Count: so many parts are asked in vain, or leaves looked at, before planes are tried, which costs a
    /// look at each corner. It changes no answer but the names of equals.</summary>
    private const int IdleBeforeProof = 16;

    /// <summary>Count: a plane is held against all corners when a search has lasted so long that they cost no more than
    /// what it has cost already: some 200 times a corner's time goes into a pair. More or less changes nothing but the
    /// time.</summary>
    private const int CornersInAsk = 256;

    private int _idle, _visits, _patience;

    /// <summary>How many pairs of parts the exact query answered.</summary>
    public int Asked;

    /// <summary>In pair units, squared and rounded up: bounds above it cannot matter.</summary>
    public float Reached;

    /// <summary>World units: pairs further apart are not looked for.</summary>
    public float Limit;

    /// <summary>The least distance; valid if <see cref="PartA"/> is not negative.</summary>
    public DistanceResult Best;

    /// <summary>The parts that have it.</summary>
    public int PartA, PartB;

    /// <summary>No pair that was asked, or that a plane dropped, is nearer than this.</summary>
    public float LowerBound;

    public TreeFrame Frame;

    /// <summary>Takes every pair within the limit, where it is not null.</summary>
    public List<PairDistance>? All;

    /// <summary>Finds all pairs that are no further apart than a distance, in no order.</summary>
    /// <param name="scratch">With both sides set.</param>
    /// <param name="distance">In world units.</param>
    /// <param name="pairs">Cleared, then the pairs.</param>
    public static void Collect(ConcaveScratch scratch, float distance, List<PairDistance> pairs)
    {
        pairs.Clear();
        scratch.Search.All = pairs;
        Run(scratch, distance);
        scratch.Search.All = null;
    }

    /// <summary>Finds the least distance that is at most the limit.</summary>
    /// <param name="scratch">With both sides set.</param>
    /// <param name="maxDistance">In world units.</param>
    /// <param name="guessA">The part of A to measure first; it need not be near, or be there at all.</param>
    /// <param name="guessB">The part of B, likewise.</param>
    public static unsafe void Run(
        ConcaveScratch scratch, float maxDistance, int guessA = PartSide.NoPart, int guessB = PartSide.NoPart)
    {
        ref PartPairSearch search = ref scratch.Search;
        PartTree a = scratch.A.Tree, b = scratch.B.Tree;
        search.Reset(scratch, maxDistance);
        if ((uint)guessA < (uint)a.Order.Length && (uint)guessB < (uint)b.Order.Length)
        {
            search.Measure(scratch, guessA, guessB);
            if (search.PartA >= 0 && search.Best.IsOverlapping) return;
        }

        // Most pairs of a scene are so far apart that the balls around them tell.
        if (search.Frame.LeastDistanceSquared > search.Reached) return;
        PlaneProof plane = scratch.Plane;
        if (search.PartA < 0 && search.Drops(plane, plane.IsSlabBeyond(scratch.A, scratch.B, search.Limit))) return;
        bool areMeshes = scratch.A.Mesh is not null && scratch.B.Mesh is not null;
        float* bounds = stackalloc float[PartTree.Lanes];
        PartHeap heap = scratch.Heap;
        heap.Clear();
        heap.Add(0, 0, 0);
        fixed (float* boxesA = a.Boxes, boxesB = b.Boxes)
        {
            while (heap.TryTake(out PartHeap.Entry pair) && pair.Bound <= search.Reached)
            {
                int childA = a.Children[pair.A], childB = b.Children[pair.B];
                if (search.IsTimeForWhole(heap) && plane.IsUntried
                    && search.Drops(plane, plane.IsWholeNoNearer(scratch.A, scratch.B)))
                {
                    return;
                }

                if (search._idle >= IdleBeforeProof && plane.IsSet
                    && search.Drops(plane, plane.IsNoNearer(scratch.A, pair.A, scratch.B, pair.B)))
                {
                    continue;
                }

                if (childA < 0 && childB < 0)
                {
                    search._visits++;
                    if (search.PartA < 0) search.TryPlaneBeyond(scratch, childA, childB);
                    if (areMeshes) search.MeasureTriangles(scratch, childA, childB);
                    else search.MeasureParts(scratch, pair.A, childA, pair.B, childB);
                    if (search.PartA >= 0 && search.Best.IsOverlapping) return;
                    continue;
                }

                bool isA = search.Frame.Open(
                    boxesA, pair.A, childA, boxesB, pair.B, childB, out float* node, out float factor,
                    out TurnedBox other);
                BoxLanes.DistanceSquared(node, factor, other, search.Frame.Room, bounds);
                heap.AddBelow(pair, isA, isA ? a.Children : b.Children, bounds, search.Reached);
            }
        }
    }

    private void Reset(ConcaveScratch scratch, float maxDistance)
    {
        TreeFrame.Compose(
            scratch.A.Tree, scratch.A.Pose, scratch.B.Tree, scratch.B.Pose, scratch.A.Margin + scratch.B.Margin,
            out Frame);
        if (scratch.A.Mesh is not null && scratch.B.Mesh is not null) scratch.Filter.Reset(Frame);
        scratch.Plane.Clear();
        _idle = _visits = Asked = 0;
        int corners = (scratch.A.Mesh?.VertexCount ?? 0) + (scratch.B.Mesh?.VertexCount ?? 0);
        _patience = corners / CornersInAsk;
        PartA = PartB = -1;
        Best = default;
        LowerBound = float.PositiveInfinity;
        SetLimit(scratch, Math.Max(maxDistance, 0));
    }

    private void SetLimit(ConcaveScratch scratch, float distance)
    {
        Limit = distance;
        Reached = BoxLanes.Squared((distance + scratch.A.Margin + scratch.B.Margin) / Frame.Unit);
    }

    /// <summary>Notes how near what is dropped may be, if a plane shows that it is no nearer.</summary>
    private bool Drops(PlaneProof plane, bool isShown)
    {
        if (isShown) LowerBound = Math.Min(LowerBound, plane.LowerBound);
        return isShown;
    }

    private void MeasureParts(ConcaveScratch scratch, int boxA, int leafA, int boxB, int leafB)
    {
        // What is left of either is a single part: a plane tells most pairs apart, and costs little.
        PlaneProof plane = scratch.Plane;
        int firstA = PartTree.FirstOf(leafA), endA = firstA + PartTree.CountOf(leafA);
        int firstB = PartTree.FirstOf(leafB), endB = firstB + PartTree.CountOf(leafB);
        bool isOneA = endA == firstA + 1;
        for (int i = firstA; i < endA; i++)
        {
            for (int j = firstB; j < endB; j++)
            {
                int partA = scratch.A.Tree.Order[i], partB = scratch.B.Tree.Order[j];
                bool isDropped = plane.IsSet && (isOneA
                    ? plane.IsPartNoNearer(scratch.A, boxA, scratch.B, partB)
                    : plane.IsNoNearerPart(scratch.A, partA, scratch.B, boxB));
                if (Drops(plane, isDropped || IsFaceNoNearer(scratch, partA, partB))) continue;
                if (All is null || !PlaneProof.IsBeyond(scratch.A, partA, scratch.B, partB, Limit))
                    Measure(scratch, partA, partB);
            }
        }
    }

    private void MeasureTriangles(ConcaveScratch scratch, int leafA, int leafB)
    {
        TriangleFilter filter = scratch.Filter;
        filter.Measure(Frame, scratch.A, leafA, scratch.B, leafB, Reached);
        int firstA = PartTree.FirstOf(leafA), firstB = PartTree.FirstOf(leafB);
        while (filter.TryTake(Reached, out int i, out int j))
        {
            int partA = scratch.A.Tree.Order[firstA + i], partB = scratch.B.Tree.Order[firstB + j];
            if (Drops(scratch.Plane, IsFaceNoNearer(scratch, partA, partB))) continue;
            Keep(scratch, partA, partB, PartQuery.TriangleDistance(scratch.A, partA, scratch.B, partB, Limit));
            if (All is null && PartA >= 0 && Best.IsOverlapping) return;
        }
    }

    /// <summary>Whether many parts are about as near, and a triangle's plane shows that these are no
    /// nearer.</summary>
    private readonly bool IsFaceNoNearer(ConcaveScratch scratch, int partA, int partB) =>
        _idle >= IdleBeforeProof && scratch.Plane.IsFaceNoNearer(scratch.A, partA, scratch.B, partB);

    private void Measure(ConcaveScratch scratch, int partA, int partB) =>
        Keep(scratch, partA, partB, PartQuery.Distance(scratch.A, partA, scratch.B, partB, Limit));

    /// <summary>Keeps the distance of two parts if it is the least so far.</summary>
    private void Keep(ConcaveScratch scratch, int partA, int partB, in DistanceResult found)
    {
        _idle++;
        Asked++;
        if (found.LowerBound < LowerBound) LowerBound = found.LowerBound;
        if (found.Status is GjkStatus.BeyondMaxDistance or GjkStatus.InvalidInput or GjkStatus.InvalidShape) return;
        if (All is not null)
        {
            All.Add(new PairDistance(found, scratch.A.NumberOf(partA), scratch.B.NumberOf(partB)));
            return;
        }

        if (PartA < 0 || found.Distance < Best.Distance)
        {
            _idle = 0;
            scratch.Plane.Set(scratch.A, partA, scratch.B, partB, found);
        }
        else if (found.Distance != Best.Distance || !IsBefore(found.IsOverlapping, partA, partB))
        {
            return;
        }

        Best = found;
        (PartA, PartB) = (partA, partB);
        SetLimit(scratch, found.Distance);
    }

    /// <summary>Whether all corners may be looked at.</summary>
    private readonly bool IsTimeForWhole(PartHeap heap) =>
        PartA < 0 ? _visits >= _patience : _idle >= IdleBeforeProof && heap.Count >= _patience;

    /// <summary>While nothing is near enough, the plane of two leaves' first parts is tried if these are too far apart,
    /// each for twice as long as the last one.</summary>
    private readonly void TryPlaneBeyond(ConcaveScratch scratch, int leafA, int leafB)
    {
        if (_visits < IdleBeforeProof || (_visits & (_visits - 1)) != 0) return;
        int partA = scratch.A.Tree.Order[PartTree.FirstOf(leafA)];
        int partB = scratch.B.Tree.Order[PartTree.FirstOf(leafB)];
        DistanceResult found = PartQuery.Distance(scratch.A, partA, scratch.B, partB, Limit);
        if (found.Status == GjkStatus.BeyondMaxDistance)
            scratch.Plane.SetBeyond(scratch.A, partA, scratch.B, partB, found.Normal, Limit);
    }

    private readonly bool IsBefore(bool isOverlapping, int partA, int partB) =>
        isOverlapping != Best.IsOverlapping ? isOverlapping
        : partA < PartA || (partA == PartA && partB < PartB);
}
