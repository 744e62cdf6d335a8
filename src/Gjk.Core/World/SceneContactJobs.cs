namespace Gjk.Core;

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
