namespace Gjk.Core;

/// <summary>Which of a scene's pairs are no further apart than a gap: all but those of which it says
/// <see cref="GjkStatus.BeyondMaxDistance"/>. Pairs that are not convex are not asked. Pairs at rest keep their
/// answers, which are what they would get.</summary>
internal readonly struct SceneWithinJob(
    SceneObjects objects, List<ObjectPair> pairs, PairAnswers<GjkStatus> answers, float maxGap) : IPartJob
{
    public unsafe void Run(int begin, int end)
    {
        bool* kept = stackalloc bool[end - begin];
        int last = answers.Seek(begin);
        bool anyAsked = false;
        for (int i = begin; i < end; i++)
        {
            kept[i - begin] = objects.TryKeep(answers, pairs[i], i, ref last);
            anyAsked |= !kept[i - begin];
        }

        if (!anyAsked) return;
#if NET
        if (WideBatch.IsSupported)
        {
            Span<DistanceResult> results = stackalloc DistanceResult[end - begin];
            var question = new WideDistances(ref results[0], ref kept[0], maxGap);
            new WideBatch(objects.Shapes, objects.Poses, ref CollectionsMarshal.AsSpan(pairs)[begin])
                .Ask(end - begin, ref question);
            for (int i = begin; i < end; i++)
                if (!kept[i - begin]) answers[i] = results[i - begin].Status;
            return;
        }
#endif
        for (int i = begin; i < end; i++)
        {
            if (kept[i - begin]) continue;
            ObjectPair pair = pairs[i];
            answers[i] = ConvexQuery.Distance(
                objects.Shapes[pair.A], objects.Poses[pair.A], objects.Shapes[pair.B], objects.Poses[pair.B],
                maxGap).Status;
        }
    }
}

/// <summary>How deep a scene's pairs overlap. Pairs at rest keep their answers: what they would get.</summary>
internal readonly struct SceneDepthJob(
    SceneObjects objects, List<ObjectPair> pairs, PairAnswers<PairDistance> answers) : IPartJob
{
    public void Run(int begin, int end)
    {
        ConcaveScratch? scratch = objects.Parts.Any ? objects.Parts.Rent() : null;
        int last = answers.Seek(begin);
        for (int i = begin; i < end; i++)
        {
            ObjectPair pair = pairs[i];
            if (objects.TryKeep(answers, pair, i, ref last)) continue;
            if (objects.Parts.Has(pair))
            {
                objects.Parts.FindDepths(pair, scratch!, answers.Parts(i));
                continue;
            }

            answers[i] = objects.DepthOf(pair);
        }

        if (scratch is not null) objects.Parts.Return(scratch);
    }
}

/// <summary>Where a scene's pairs touch. Pairs at rest keep their answers, which are what they would get.</summary>
internal readonly struct SceneContactJob(
    SceneObjects objects, List<ObjectPair> pairs, PairAnswers<PairContacts> answers, float maxGap) : IPartJob
{
    public void Run(int begin, int end)
    {
        ConcaveScratch? scratch = objects.Parts.Any ? objects.Parts.Rent() : null;
        int last = answers.Seek(begin);
        for (int i = begin; i < end; i++)
        {
            ObjectPair pair = pairs[i];
            if (objects.TryKeep(answers, pair, i, ref last)) continue;
            if (objects.Parts.Has(pair))
            {
                objects.Parts.FindContacts(pair, maxGap, scratch!, answers.Parts(i));
                continue;
            }

            answers[i] = objects.ContactsOf(pair, maxGap);
        }

        if (scratch is not null) objects.Parts.Return(scratch);
    }
}
