namespace Gjk.Core;

/// <summary>How deep a scene's pairs overlap. Pairs at rest keep their answers: what they would get.</summary>
internal readonly struct SceneDepthJob(
    SceneObjects objects, List<ObjectPair> pairs, PairAnswers<PairDistance> answers) : IShareJob
{
    public void Run(int begin, int end)
    {
        ConcaveScratch? scratch = objects.Parts.RentIfAny();
        int last = answers.Seek(begin);
        for (int i = begin; i < end; i++)
        {
            ObjectPair pair = pairs[i];
            if (objects.TryKeep(answers, pair, i, ref last)) continue;
            if (objects.Parts.Has(pair)) objects.Parts.FindDepths(pair, scratch!, answers.Parts(i));
            else answers[i] = objects.DepthOf(pair);
        }

        objects.Parts.Return(scratch);
    }
}

/// <summary>Where a scene's pairs touch that are not joined. Pairs at rest keep their answers: what they would
/// get.</summary>
internal readonly struct SceneContactJob(
    SceneObjects objects, List<ObjectPair> pairs, PairAnswers<PairContacts> answers, SceneUnions unions, float maxGap)
    : IShareJob
{
    public void Run(int begin, int end)
    {
        ConcaveScratch? scratch = objects.Parts.RentIfAny();
        int last = answers.Seek(begin);
        for (int i = begin; i < end; i++)
        {
            ObjectPair pair = pairs[i];
            if (unions.Has(i)) continue;
            if (objects.TryKeep(answers, pair, i, ref last) && SceneUnions.CountIn(answers[i]) == 0) continue;
            answers[i] = default;
            if (objects.Parts.Has(pair)) objects.Parts.FindContacts(pair, maxGap, scratch!, answers.Parts(i));
            else answers[i] = objects.ContactsOf(pair, maxGap);
        }

        objects.Parts.Return(scratch);
    }
}

/// <summary>Where bodies touch static objects that are joined.</summary>
internal readonly struct SceneUnionJob(
    SceneObjects objects, List<ObjectPair> pairs, PairAnswers<PairContacts> answers, SceneUnions unions, float maxGap)
    : IShareJob
{
    public void Run(int begin, int end)
    {
        ConcaveScratch scratch = objects.Parts.Rent();
        for (int i = begin; i < end; i++) unions.Find(i, pairs, answers, maxGap, scratch);
        objects.Parts.Return(scratch);
    }
}
