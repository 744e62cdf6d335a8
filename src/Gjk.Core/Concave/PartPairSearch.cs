namespace Gjk.Core;

/// <summary>Finds the pair of parts with the least distance. Pairs of boxes wait in a heap, the least bound first. The
/// larger box of a pair is opened. The parts of two leaves are measured one by one, by the exact query.</summary>
/// <remarks>Source: branch and bound over two trees (Quinlan, "Efficient distance computation between non-convex
/// objects", 1994; Johnson and Cohen, 1998, best first). Exactness: a pair of boxes is dropped only if its bound, which
/// is proved, exceeds the least distance that a query of two parts has given, or if a <see cref="PlaneProof"/> says
/// that none of its parts are nearer than that. So the answer is the least of all pairs' answers, whatever the trees
/// are like. It ends: each pair of boxes enters the heap once at most, and each step takes one out. Which of several
/// pairs with the same float distance is named depends on the trees, which depend on the input alone.</remarks>
internal struct PartPairSearch
{
    /// <summary>Count: so many parts are measured in vain, or leaves visited, before planes are tried, which read all
    /// corners. It changes no answer, only which of several equal pairs is named.</summary>
    private const int IdleBeforeProof = 16;

    /// <summary>Count: a plane is tested against all corners only after the search has cost about as much: one pair of
    /// parts costs some 200 corners. It changes the time only.</summary>
    private const int CornersInAsk = 256;

    private int _idle, _visits, _patience;

    /// <summary>Set where only contacts are looked for.</summary>
    private TrianglesApart _triangles;

    /// <summary>How many pairs of parts the exact query has answered.</summary>
    public int QueryCount;

    /// <summary>In pair units, squared and rounded up: pairs with larger bounds cannot matter.</summary>
    public float Reached;

    /// <summary>World units: pairs further apart are not searched for.</summary>
    public float Limit;

    /// <summary>The least distance; valid if <see cref="PartA"/> is not negative.</summary>
    public DistanceResult Best;

    /// <summary>The parts that have it.</summary>
    public int PartA, PartB;

    /// <summary>No pair that was asked, or that a plane dropped, is nearer than this.</summary>
    public float LowerBound;

    public TreeFrame Frame;

    /// <summary>Gets every pair within the limit, where it is not null.</summary>
    public List<PairDistance>? AllPairs;

    /// <summary>Finds all pairs that are no further apart than a distance, in no order.</summary>
    /// <param name="scratch">With both sides set.</param>
    /// <param name="distance">In world units.</param>
    /// <param name="pairs">Cleared, then the pairs.</param>
    public static void Collect(ConcaveScratch scratch, float distance, List<PairDistance> pairs)
    {
        pairs.Clear();
        scratch.Search.AllPairs = pairs;
        Run(scratch, distance);
        scratch.Search.AllPairs = null;
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
        if (search.PartA < 0 && search.DropIf(plane, plane.IsSlabBeyond(scratch.A, scratch.B, search.Limit))) return;
        bool areMeshes = scratch.A.Mesh is not null && scratch.B.Mesh is not null;
        float* bounds = stackalloc float[PartTree.Lanes];
        PartHeap heap = scratch.Heap;
        heap.Clear();
        heap.Push(0, 0, 0);
        fixed (float* boxesA = a.Boxes, boxesB = b.Boxes)
        {
            while (heap.TryPop(out PartHeap.Entry pair) && pair.Bound <= search.Reached)
            {
                int childA = a.Children[pair.A], childB = b.Children[pair.B];
                if (search.IsTimeForWhole(heap) && plane.IsUntried
                    && search.DropIf(plane, plane.IsWholeNoNearer(scratch.A, scratch.B)))
                {
                    return;
                }

                if (search._idle >= IdleBeforeProof && plane.IsSet
                    && search.DropIf(plane, plane.IsNoNearer(scratch.A, pair.A, scratch.B, pair.B)))
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

                bool isA = search.Frame.ChooseOpened(
                    boxesA, pair.A, childA, boxesB, pair.B, childB, out float* node, out float factor,
                    out TurnedBox other);
                BoxLanes.DistanceSquared(node, factor, other, search.Frame.Room, bounds);
                heap.PushChildren(pair, isA, isA ? a.Children : b.Children, bounds, search.Reached);
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
        _idle = _visits = QueryCount = 0;
        int corners = (scratch.A.Mesh?.VertexCount ?? 0) + (scratch.B.Mesh?.VertexCount ?? 0);
        _patience = corners / CornersInAsk;
        PartA = PartB = -1;
        Best = default;
        LowerBound = float.PositiveInfinity;
        SetLimit(scratch, Math.Max(maxDistance, 0));
        _triangles = Limit == 0 ? new TrianglesApart(scratch.A, scratch.B, Frame, default) : default;
    }

    private void SetLimit(ConcaveScratch scratch, float distance)
    {
        Limit = distance;
        Reached = BoxLanes.Squared((distance + scratch.A.Margin + scratch.B.Margin) / Frame.Unit);
    }

    /// <summary>Lowers the bound of all distances by the plane's, if a plane proves that what is dropped is no
    /// nearer.</summary>
    private bool DropIf(PlaneProof plane, bool isShown)
    {
        if (isShown) LowerBound = Math.Min(LowerBound, plane.LowerBound);
        return isShown;
    }

    private void MeasureParts(ConcaveScratch scratch, int boxA, int leafA, int boxB, int leafB)
    {
        // On one side a single part is left. A plane rules out most pairs, and costs little.
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
                if (DropIf(plane, isDropped || IsFaceNoNearer(scratch, partA, partB))) continue;
                if (AllPairs is null || !PlaneProof.IsBeyond(scratch.A, partA, scratch.B, partB, Limit))
                    Measure(scratch, partA, partB);
            }
        }
    }

    private void MeasureTriangles(ConcaveScratch scratch, int leafA, int leafB)
    {
        TriangleFilter filter = scratch.Filter;
        filter.Measure(Frame, scratch.A, leafA, scratch.B, leafB, Reached);
        int firstA = PartTree.FirstOf(leafA), firstB = PartTree.FirstOf(leafB);
        while (filter.TryPopNearest(Reached, out int i, out int j))
        {
            int partA = scratch.A.Tree.Order[firstA + i], partB = scratch.B.Tree.Order[firstB + j];
            if (_triangles.StayApart(partA, partB, 0))
            {
                _idle++;
                LowerBound = Math.Min(LowerBound, 0);
                continue;
            }

            if (DropIf(scratch.Plane, IsFaceNoNearer(scratch, partA, partB))) continue;
            Keep(scratch, partA, partB, PartQuery.TriangleDistance(scratch.A, partA, scratch.B, partB, Limit));
            if (AllPairs is null && PartA >= 0 && Best.IsOverlapping) return;
        }
    }

    /// <summary>Whether a triangle's plane shows that two parts are no nearer; tried where many parts are about as
    /// near.</summary>
    private readonly bool IsFaceNoNearer(ConcaveScratch scratch, int partA, int partB) =>
        _idle >= IdleBeforeProof && scratch.Plane.IsFaceNoNearer(scratch.A, partA, scratch.B, partB);

    private void Measure(ConcaveScratch scratch, int partA, int partB) =>
        Keep(scratch, partA, partB, PartQuery.Distance(scratch.A, partA, scratch.B, partB, Limit));

    /// <summary>Keeps the distance of two parts if it is the least so far.</summary>
    private void Keep(ConcaveScratch scratch, int partA, int partB, in DistanceResult found)
    {
        _idle++;
        QueryCount++;
        if (found.LowerBound < LowerBound) LowerBound = found.LowerBound;
        if (found.Status is GjkStatus.BeyondMaxDistance or GjkStatus.InvalidInput or GjkStatus.InvalidShape) return;
        if (AllPairs is not null)
        {
            AllPairs.Add(new PairDistance(found, scratch.A.NumberOf(partA), scratch.B.NumberOf(partB)));
            return;
        }

        if (PartA < 0 || found.Distance < Best.Distance)
        {
            _idle = 0;
            scratch.Plane.SetNearest(scratch.A, partA, scratch.B, partB, found);
        }
        else if (found.Distance != Best.Distance || !IsBefore(found.IsOverlapping, partA, partB))
        {
            return;
        }

        Best = found;
        (PartA, PartB) = (partA, partB);
        SetLimit(scratch, found.Distance);
    }

    /// <summary>Whether the search has lasted long enough to read all corners.</summary>
    private readonly bool IsTimeForWhole(PartHeap heap) =>
        PartA < 0 ? _visits >= _patience : _idle >= IdleBeforeProof && heap.Count >= _patience;

    /// <summary>While no pair is within the limit: tries the plane of two leaves' first parts, if these are too far
    /// apart. Each time it waits for twice as many leaves.</summary>
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
