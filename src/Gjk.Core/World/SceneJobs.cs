namespace Gjk.Core;

/// <summary>Which of a scene's pairs overlap, or are no further apart than a gap. Those that are not convex may be left
/// out; they have no answer then. Pairs at rest keep their answers, which are what they would get.</summary>
/// <param name="objects">The objects.</param>
/// <param name="pairs">The pairs, sorted.</param>
/// <param name="answers">Gets the answers. With a gap, all pairs are near of which it does not say
/// <see cref="GjkStatus.BeyondMaxDistance"/>.</param>
/// <param name="maxGap">World units; 0 asks which overlap.</param>
/// <param name="asksParts">Whether pairs that are not convex are asked.</param>
internal readonly struct SceneNearJob(
    SceneObjects objects, List<ObjectPair> pairs, PairAnswers<GjkStatus> answers, float maxGap, bool asksParts)
    : IShareJob
{
    public unsafe void Run(int begin, int end)
    {
        bool* answered = stackalloc bool[end - begin];
        int last = answers.Seek(begin);
        bool anyAsked = false;
        for (int i = begin; i < end; i++)
        {
            bool isKept = objects.TryKeep(answers, pairs[i], i, ref last) && answers[i] != GjkStatus.None;
            bool hasParts = objects.Parts.Has(pairs[i]);
            anyAsked |= !isKept && (asksParts || !hasParts);
            answered[i - begin] = isKept || hasParts;
            if (!isKept) answers[i] = GjkStatus.None;
        }

        if (!anyAsked) return;
        Ask(begin, end, answered);
        if (asksParts && objects.Parts.Any) AskParts(begin, end);
    }

    private unsafe void Ask(int begin, int end, bool* answered)
    {
#if NET
        if (WideBatch.IsSupported)
        {
            AskWide(begin, end, answered);
            return;
        }
#endif
        ConvexShape[] shapes = objects.Shapes;
        RigidPose[] poses = objects.Poses;
        for (int i = begin; i < end; i++)
        {
            if (answered[i - begin]) continue;
            (int a, int b) = (pairs[i].A, pairs[i].B);
            if (i + Prefetch.PairsAhead < end)
            {
                int next = pairs[i + Prefetch.PairsAhead].B;
                Prefetch.Objects(ref shapes[next], ref poses[next]);
            }

            if (maxGap > 0) answers[i] = ConvexQuery.Distance(shapes[a], poses[a], shapes[b], poses[b], maxGap).Status;
            else ConvexQuery.Overlaps(shapes[a], poses[a], shapes[b], poses[b], out answers[i]);
        }
    }

#if NET
    private unsafe void AskWide(int begin, int end, bool* answered)
    {
        var batch = new WideBatch(
            objects.Shapes, objects.Poses, ref CollectionsMarshal.AsSpan(pairs)[begin], ref *answered);
        if (maxGap > 0)
        {
            Span<DistanceResult> results = stackalloc DistanceResult[end - begin];
            var distances = new WideDistances(ref results[0], ref Unsafe.NullRef<WarmStart>(), maxGap);
            batch.Run(end - begin, ref distances);
            for (int i = begin; i < end; i++)
                if (!answered[i - begin]) answers[i] = results[i - begin].Status;
            return;
        }

        var overlaps = new WideOverlaps(ref answers[begin]);
        batch.Run(end - begin, ref overlaps);
    }

#endif
    private void AskParts(int begin, int end)
    {
        ConcaveScratch scratch = objects.Parts.Rent();
        for (int i = begin; i < end; i++)
        {
            if (answers[i] == GjkStatus.None && objects.Parts.Has(pairs[i]))
                answers[i] = objects.Parts.Distance(pairs[i], maxGap, scratch).Result.Status;
        }

        objects.Parts.Return(scratch);
    }
}

/// <summary>How far apart a scene's pairs are, from where each was in the frame before.</summary>
/// <remarks>The bits of an answer depend on the answers that were reported for the pair, and on nothing else. A pair
/// that was reported in the frame before begins where it ended. A pair that was not may have been looked at or not,
/// which depends on the bounds; what it remembers is used only to see quickly that it still is too far apart, and else
/// it begins cold, as each pair does that is not convex. A pair that was reported and whose objects have not moved
/// since keeps its answer.</remarks>
internal readonly struct SceneDistanceJob(
    SceneObjects objects, List<ObjectPair> pairs, PairWarmStarts warmStarts, float maxDistance)
    : IShareJob
{
    /// <summary>Ratio to the distance asked for and both radii: a lower bound that exceeds the distance by this much
    /// leaves no doubt that a cold query says the same. The promise for curved shapes, which is the weakest one. More
    /// costs time only; no pair is known that needs as much (CandidateBitsTests has those that come exactly to the
    /// distance).</summary>
    private const double ClearlyBeyond = 1e-6;

    public void Run(int begin, int end)
    {
        int last = warmStarts.Seek(begin);
        PairWarmStarts.Frame now = warmStarts.Now, before = warmStarts.Last;
        for (int i = begin; i < end; i++)
        {
            bool keepsShapes = objects.KeepShapes(pairs[i], warmStarts.LastCall);
            PairState state = warmStarts.Resume(i, keepsShapes, ref last);
            now.Kept[i] = state == PairState.Reported && objects.Rest(pairs[i], warmStarts.LastCall)
                && before.Results[last].Distance <= maxDistance;
            if (!now.Kept[i]) continue;
            now.Results[i] = before.Results[last];
            now.Parts[i] = before.Parts[last];
        }

        Ask(begin, end);
        if (objects.Parts.Any) AskParts(begin, end);
        for (int i = begin; i < end; i++)
        {
            ref DistanceResult result = ref now.Results[i];
            bool isUnclear = now.States[i] == PairState.Beyond && !IsClearlyBeyond(pairs[i], result);
            if (isUnclear && !objects.Parts.Has(pairs[i]))
            {
                now.Starts[i].Clear();
                AskAlone(i);
            }

            bool isBeyond = result.Status == GjkStatus.BeyondMaxDistance;
            now.States[i] = isBeyond ? PairState.Beyond : PairState.Reported;
        }
    }

    /// <summary>Asks about the pairs that keep no answer, each from its warm start.</summary>
    private void Ask(int begin, int end)
    {
#if NET
        if (WideBatch.IsSupported)
        {
            var question = new WideDistances(
                ref warmStarts.Now.Results[begin], ref warmStarts.Now.Starts[begin], maxDistance);
            ref ObjectPair first = ref CollectionsMarshal.AsSpan(pairs)[begin];
            new WideBatch(objects.Shapes, objects.Poses, ref first, ref warmStarts.Now.Kept[begin])
                .Run(end - begin, ref question);
            return;
        }
#endif
        for (int i = begin; i < end; i++)
            if (!warmStarts.Now.Kept[i]) AskAlone(i);
    }

    /// <summary>Asks about the pairs that are not convex, cold.</summary>
    private void AskParts(int begin, int end)
    {
        ConcaveScratch scratch = objects.Parts.Rent();
        for (int i = begin; i < end; i++)
        {
            if (warmStarts.Now.Kept[i] || !objects.Parts.Has(pairs[i])) continue;
            PairDistance found = objects.Parts.Distance(pairs[i], maxDistance, scratch);
            warmStarts.Now.Results[i] = found.Result;
            warmStarts.Now.Parts[i] = new ObjectPair(found.PartA, found.PartB);
        }

        objects.Parts.Return(scratch);
    }

    private void AskAlone(int i)
    {
        (ConvexShape[] shapes, RigidPose[] poses, ObjectPair pair) = (objects.Shapes, objects.Poses, pairs[i]);
        warmStarts.Now.Results[i] = ConvexQuery.Distance(
            shapes[pair.A], poses[pair.A], shapes[pair.B], poses[pair.B], ref warmStarts.Now.Starts[i], maxDistance);
    }

    private bool IsClearlyBeyond(ObjectPair pair, in DistanceResult result)
    {
        double size = maxDistance + objects.Bounds[pair.A].Radius + objects.Bounds[pair.B].Radius;
        return result.Status == GjkStatus.BeyondMaxDistance && result.LowerBound > maxDistance + ClearlyBeyond * size;
    }
}
