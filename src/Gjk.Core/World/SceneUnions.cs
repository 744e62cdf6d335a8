namespace Gjk.Core;

/// <summary>The bodies of a scene that may touch several static objects, such as the tiles of a floor. These objects
/// count as one body, whose seams do not show.</summary>
internal sealed class SceneUnions(SceneObjects objects)
{
    private ulong[] _keys = new ulong[16];
    private bool[] _isJoined = new bool[16];

    /// <summary>The range of each body's pairs among the keys.</summary>
    private readonly List<(int Begin, int End)> _bodies = [];

    public int Count => _bodies.Count;

    /// <summary>Whether the i-th pair is one of a body and a joined object.</summary>
    public bool IsJoined(int i) => _isJoined[i];

    /// <summary>Collects the bodies, and their pairs.</summary>
    /// <param name="pairs">Those that may touch.</param>
    /// <param name="joins">Whether static objects are joined at all.</param>
    public void Collect(List<ObjectPair> pairs, bool joins)
    {
        _bodies.Clear();
        if (_keys.Length < pairs.Count)
        {
            _keys = new ulong[2 * pairs.Count];
            _isJoined = new bool[_keys.Length];
        }

        Array.Clear(_isJoined, 0, pairs.Count);
        int count = 0;
        for (int i = 0; joins && i < pairs.Count; i++)
        {
            ObjectPair pair = pairs[i];
            bool isStatic = objects.Settings[pair.A].IsStatic;
            if (isStatic != objects.Settings[pair.B].IsStatic && !IsEndless(pair.A) && !IsEndless(pair.B))
                _keys[count++] = (ulong)(uint)(isStatic ? pair.B : pair.A) << 32 | (uint)i;
        }

        InPlaceSort.Sort(_keys, 0, count);
        for (int begin = 0, end; begin < count; begin = end)
        {
            end = begin + 1;
            while (end < count && _keys[end] >> 32 == _keys[begin] >> 32) end++;
            if (end < begin + 2) continue;
            _bodies.Add((begin, end));
            for (int k = begin; k < end; k++) _isJoined[(int)(uint)_keys[k]] = true;
        }
    }

    /// <summary>Finds the contacts of one of the bodies.</summary>
    /// <param name="index">Which one.</param>
    /// <param name="pairs">As collected.</param>
    /// <param name="answers">Gets those of its pairs.</param>
    /// <param name="maxGap">World units.</param>
    /// <param name="scratch">Memory for the search.</param>
    public void FindContacts(
        int index, List<ObjectPair> pairs, PairAnswers<PairContacts> answers, float maxGap, ConcaveScratch scratch)
    {
        (int begin, int end) = _bodies[index];
        if (TryKeepAll(begin, end, pairs, answers)) return;
        JoinGrounds(begin, end, pairs, answers, maxGap, scratch);
        if (scratch.GroundCount == 1)
        {
            // One alone is not joined.
            int i = scratch.Grounds[0].PairIndex;
            scratch.GroundCount = 0;
            objects.Concave.FindContacts(pairs[i], maxGap, scratch, answers.AllFor(i));
        }

        if (scratch.GroundCount == 0) return;
        JoinedGrounds.FindContacts(scratch, maxGap, maxGap, scratch.Joined);
        float deepest = DeepFaces.FindGap(scratch, scratch.Joined, maxGap);
        if (deepest > maxGap)
        {
            JoinGrounds(begin, end, pairs, answers, deepest, scratch);
            JoinedGrounds.FindContacts(scratch, deepest, maxGap, scratch.Joined);
            DeepFaces.RemoveBeyond(scratch.Joined, maxGap);
        }

        var body = (int)(_keys[begin] >> 32);
        foreach (PairContacts one in scratch.Joined)
        {
            int i = scratch.Grounds[one.Pair.A].PairIndex;
            PairContacts placed = pairs[i].A == body ? one.Swapped : one;
            answers.AllFor(i).Add(placed.WithPair(objects.IdsOf(pairs[i])));
        }

        scratch.GroundCount = 0;
    }

    /// <summary>Collects the static objects that a body is near, and its pairs of parts with them.</summary>
    private void JoinGrounds(
        int begin, int end, List<ObjectPair> pairs, PairAnswers<PairContacts> answers, float maxGap,
        ConcaveScratch scratch)
    {
        var body = (int)(_keys[begin] >> 32);
        scratch.B.TrySet(objects.Concave[body], objects.Poses[body]);
        scratch.Pairs.Clear();
        scratch.GroundCount = 0;
        for (int k = begin; k < end; k++)
        {
            var i = (int)(uint)_keys[k];
            answers.AllFor(i).Clear();
            answers[i] = new PairContacts(end - begin, PartSide.NoPart, default, default);
            int slot = pairs[i].A == body ? pairs[i].B : pairs[i].A;
            Aabb box = objects.Bounds[slot].BoxAt(objects.Poses[slot]);
            JoinedGrounds.Add(scratch, objects.Concave[slot], objects.Poses[slot], box, i, maxGap);
        }
    }

    /// <summary>How many objects are joined in a pair's answer; 0 for a pair that is not joined.</summary>
    public static int JoinedCount(in PairContacts answer) => answer.Manifold.Count == 0 ? Math.Max(answer.PartA, 0) : 0;

    /// <summary>A half-space has no seam, and goes on everywhere.</summary>
    private bool IsEndless(int slot) => objects.Shapes[slot].Kind == ShapeKind.HalfSpace;

    /// <summary>Keeps the last answers of a body's pairs, if neither the body nor an object has moved, been added or
    /// removed.</summary>
    private bool TryKeepAll(int begin, int end, List<ObjectPair> pairs, PairAnswers<PairContacts> answers)
    {
        for (int k = begin; k < end; k++)
        {
            var i = (int)(uint)_keys[k];
            if (!answers.KnowsAny || !objects.AreAtRest(pairs[i], answers.LastCall)) return false;
            if (JoinedCount(answers.LastAnswer(i)) != end - begin) return false;
        }

        for (int k = begin; k < end; k++)
        {
            var i = (int)(uint)_keys[k];
            int last = answers.Seek(i);
            answers.TryKeep(i, ref last);
        }

        return true;
    }
}

/// <summary>Finds the contacts of bodies with static objects that are joined.</summary>
internal readonly struct SceneUnionJob(
    SceneObjects objects, List<ObjectPair> pairs, PairAnswers<PairContacts> answers, SceneUnions unions, float maxGap)
    : IShareJob
{
    public void Run(int begin, int end)
    {
        ConcaveScratch scratch = objects.Concave.Rent();
        for (int i = begin; i < end; i++) unions.FindContacts(i, pairs, answers, maxGap, scratch);
        objects.Concave.Return(scratch);
    }
}
