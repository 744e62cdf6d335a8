namespace Gjk.Core;

/// <summary>Decides which of a scene's pairs overlap, or are no further apart than a gap. Pairs that are not convex may
/// be left out; they have no answer then. Pairs at rest keep their answers, which a new query would repeat.</summary>
/// <param name="objects">The objects.</param>
/// <param name="pairs">The pairs, sorted.</param>
/// <param name="answers">Gets the answers. With a gap, a pair is near unless its answer is
/// <see cref="GjkStatus.BeyondMaxDistance"/>.</param>
/// <param name="maxGap">World units; 0 decides which pairs overlap.</param>
/// <param name="includesConcave">Whether pairs that are not convex are decided, too.</param>
internal readonly struct SceneNearJob(
    SceneObjects objects, List<ObjectPair> pairs, PairAnswers<GjkStatus> answers, float maxGap, bool includesConcave)
    : IShareJob
{
    public unsafe void Run(int begin, int end)
    {
        bool* answered = stackalloc bool[end - begin];
        int last = answers.Seek(begin);
        bool isAnyLeft = false;
        for (int i = begin; i < end; i++)
        {
            bool isKept = objects.TryKeep(answers, pairs[i], i, ref last) && answers[i] != GjkStatus.None;
            bool isConcave = objects.Concave.Contains(pairs[i]);
            isAnyLeft |= !isKept && (includesConcave || !isConcave);
            answered[i - begin] = isKept || isConcave;
            if (!isKept) answers[i] = GjkStatus.None;
        }

        if (!isAnyLeft) return;
        SolveConvex(begin, end, answered);
        if (includesConcave && objects.Concave.Any) SolveConcave(begin, end);
    }

    private unsafe void SolveConvex(int begin, int end, bool* answered)
    {
#if NET
        if (WideBatch.IsSupported)
        {
            SolveWide(begin, end, answered);
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
    private unsafe void SolveWide(int begin, int end, bool* answered)
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
    private void SolveConcave(int begin, int end)
    {
        ConcaveScratch scratch = objects.Concave.Rent();
        for (int i = begin; i < end; i++)
        {
            if (answers[i] == GjkStatus.None && objects.Concave.Contains(pairs[i]))
                answers[i] = objects.Concave.Distance(pairs[i], maxGap, scratch).Result.Status;
        }

        objects.Concave.Return(scratch);
    }
}

/// <summary>Measures how far apart a scene's pairs are, each from its warm start.</summary>
/// <remarks>The bits of an answer depend on the earlier reported answers of the pair alone. A pair that was reported in
/// the last frame begins where that query ended. Whether a pair that was not reported was queried depends on the
/// bounds. So its warm start is only used to see quickly that the pair is still too far apart; otherwise the query
/// begins cold. Pairs that are not convex always begin cold. A reported pair whose objects have not moved since keeps
/// its answer.</remarks>
internal readonly struct SceneDistanceJob(
    SceneObjects objects, List<ObjectPair> pairs, PairWarmStarts warmStarts, float maxDistance)
    : IShareJob
{
    /// <summary>Ratio to the distance asked for and both radii: where a lower bound exceeds the distance by this much,
    /// a cold query also reports BeyondMaxDistance. It is the accuracy promised for curved shapes, the weakest promise.
    /// More costs time only; no pair is known that needs as much (CandidateBitsTests has pairs that come exactly to the
    /// distance).</summary>
    private const double ClearlyBeyond = 1e-6;

    public void Run(int begin, int end)
    {
        int last = warmStarts.Seek(begin);
        PairWarmStarts.Frame now = warmStarts.Now, before = warmStarts.Last;
        for (int i = begin; i < end; i++)
        {
            bool haveKeptShapes = objects.HaveKeptShapes(pairs[i], warmStarts.LastCall);
            PairState state = warmStarts.Resume(i, haveKeptShapes, ref last);
            now.Kept[i] = state == PairState.Reported && objects.AreAtRest(pairs[i], warmStarts.LastCall)
                && before.Results[last].Distance <= maxDistance;
            if (!now.Kept[i]) continue;
            now.Results[i] = before.Results[last];
            now.Parts[i] = before.Parts[last];
        }

        SolveConvex(begin, end);
        if (objects.Concave.Any) SolveConcave(begin, end);
        for (int i = begin; i < end; i++)
        {
            ref DistanceResult result = ref now.Results[i];
            bool isUnclear = now.States[i] == PairState.Beyond && !IsClearlyBeyond(pairs[i], result);
            if (isUnclear && !objects.Concave.Contains(pairs[i]))
            {
                now.Starts[i].Clear();
                SolveOne(i);
            }

            bool isBeyond = result.Status == GjkStatus.BeyondMaxDistance;
            now.States[i] = isBeyond ? PairState.Beyond : PairState.Reported;
        }
    }

    /// <summary>Queries the pairs that keep no answer, each from its warm start.</summary>
    private void SolveConvex(int begin, int end)
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
            if (!warmStarts.Now.Kept[i]) SolveOne(i);
    }

    /// <summary>Queries the pairs that are not convex, cold.</summary>
    private void SolveConcave(int begin, int end)
    {
        ConcaveScratch scratch = objects.Concave.Rent();
        for (int i = begin; i < end; i++)
        {
            if (warmStarts.Now.Kept[i] || !objects.Concave.Contains(pairs[i])) continue;
            PairDistance found = objects.Concave.Distance(pairs[i], maxDistance, scratch);
            warmStarts.Now.Results[i] = found.Result;
            warmStarts.Now.Parts[i] = new ObjectPair(found.PartA, found.PartB);
        }

        objects.Concave.Return(scratch);
    }

    private void SolveOne(int i)
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

/// <summary>Finds how deep a scene's pairs overlap. Pairs at rest keep their answers, which a new query would
/// repeat.</summary>
internal readonly struct SceneDepthJob(
    SceneObjects objects, List<ObjectPair> pairs, PairAnswers<PairDistance> answers) : IShareJob
{
    public void Run(int begin, int end)
    {
        ConcaveScratch? scratch = objects.Concave.RentIfAny();
        int last = answers.Seek(begin);
        for (int i = begin; i < end; i++)
        {
            ObjectPair pair = pairs[i];
            if (objects.TryKeep(answers, pair, i, ref last)) continue;
            if (objects.Concave.Contains(pair)) objects.Concave.FindDepths(pair, scratch!, answers.AllFor(i));
            else answers[i] = objects.DepthOf(pair);
        }

        objects.Concave.Return(scratch);
    }
}

/// <summary>Finds the contacts of a scene's pairs that are not joined. Pairs at rest keep their answers, which a new
/// query would repeat.</summary>
internal readonly struct SceneContactJob(
    SceneObjects objects, List<ObjectPair> pairs, PairAnswers<PairContacts> answers, SceneUnions unions, float maxGap)
    : IShareJob
{
    public void Run(int begin, int end)
    {
        ConcaveScratch? scratch = objects.Concave.RentIfAny();
        int last = answers.Seek(begin);
        for (int i = begin; i < end; i++)
        {
            ObjectPair pair = pairs[i];
            if (unions.IsJoined(i)) continue;
            if (objects.TryKeep(answers, pair, i, ref last) && SceneUnions.JoinedCount(answers[i]) == 0) continue;
            answers[i] = default;
            if (objects.Concave.Contains(pair)) objects.Concave.FindContacts(pair, maxGap, scratch!, answers.AllFor(i));
            else answers[i] = objects.ContactsOf(pair, maxGap);
        }

        objects.Concave.Return(scratch);
    }
}
