namespace Gjk.Core;

/// <summary>Finds the pairs of parts whose part of one body is at a point. With a great gap all parts are paired, and
/// few of them are at the point: then the tree of the body finds these.</summary>
internal sealed class PairsAtPoint
{
    /// <summary>Count: up to so many pairs of an object each is looked at. It changes the time only.</summary>
    private const int Few = 16;

    /// <summary>Stands for each part of the other body.</summary>
    public const int AnyPart = int.MinValue;

    private readonly List<int> _found = [], _parts = [], _firstOfB = [];
    private readonly List<long> _keys = [];

    /// <summary>How many pairs and parts were looked at.</summary>
    public long Looks;

    /// <summary>Forgets the pairs of another query.</summary>
    public void Clear()
    {
        _keys.Clear();
        Looks = 0;
    }

    /// <summary>Whether an object has so few pairs that each is looked at.</summary>
    public static bool AreFew(ConcaveScratch scratch, int ground)
    {
        (int begin, int end) = scratch.PairsOf(ground);
        return end - begin <= Few;
    }

    /// <summary>The indices of pairs, in order. The list is valid until the next call.</summary>
    /// <param name="scratch">With the pairs.</param>
    /// <param name="ground">The static object, if A is several.</param>
    /// <param name="isA">Whether the body is A.</param>
    /// <param name="other">The part of the other body, or <see cref="AnyPart"/>: then one pair of each part is
    /// enough.</param>
    /// <param name="point">In the body's frame.</param>
    /// <param name="gap">World units: how far from the point a part may be, beyond rounding.</param>
    public List<int> Find(
        ConcaveScratch scratch, int ground, bool isA, int other, in Double3 point, double gap = 0)
    {
        PartSide side = scratch.SideOf(ground, isA);
        (int begin, int end) = scratch.PairsOf(ground);
        _found.Clear();
        if (AreFew(scratch, ground))
        {
            Looks += end - begin;
            for (int k = begin; k < end; k++)
            {
                PairDistance near = scratch.Pairs[k];
                if (other != AnyPart && other != (isA ? near.PartB : near.PartA)) continue;
                if (!CoveredSides.IsClear(side, isA ? near.PartA : near.PartB, point, gap)) _found.Add(k);
            }

            return _found;
        }

        if (_keys.Count == 0) SetKeys(scratch);
        foreach (int part in FindParts(side, point, gap))
        {
            if (CoveredSides.IsClear(side, part, point, gap)) continue;
            int number = side.Mesh is null && side.Compound is null ? PartSide.NoPart : part;
            int k = isA ? FirstPair(begin, end, number, other)
                : other == AnyPart ? _firstOfB[number + 1]
                : FirstPair(begin, end, other, number);
            if (k >= begin && k < end) _found.Add(k);
        }

        if (_found.Count > 1) InPlaceSort.Sort(_found);
        return _found;
    }

    /// <summary>The parts whose boxes are no further from a point than a gap, but for rounding.</summary>
    /// <inheritdoc cref="Find"/>
    public List<int> FindParts(PartSide side, in Double3 point, double gap = 0)
    {
        PartTree tree = side.Tree;
        double touch = 2 * (CoveredSides.Room * (2 * tree.Radius + point.SumOfMagnitudes) + side.Rounding);
        _parts.Clear();
        double most = touch + gap + side.Margin;
        tree.FindNear(0, (point - tree.Origin) * (1 / tree.Unit), most / tree.Unit, _parts);
        Looks += _parts.Count;
        return _parts;
    }

    /// <summary>The first pair of two parts, or of a part of A; -1 where there is none.</summary>
    private int FirstPair(int begin, int end, int partA, int partB)
    {
        long key = KeyOf(partA, partB == AnyPart ? PartSide.NoPart : partB);
        int at = _keys.BinarySearch(begin, end - begin, key, null);
        if (at >= 0) return at;
        return partB == AnyPart && ~at < end && _keys[~at] >> 32 == key >> 32 ? ~at : -1;
    }

    private static long KeyOf(int partA, int partB) => ((long)(partA + 1) << 32) | (uint)(partB + 1);

    private void SetKeys(ConcaveScratch scratch)
    {
        List<PairDistance> pairs = scratch.Pairs;
        _firstOfB.Clear();
        for (int part = PartSide.NoPart; part < scratch.B.PartCount; part++) _firstOfB.Add(-1);
        for (int k = 0; k < pairs.Count; k++)
        {
            PairDistance pair = pairs[k];
            _keys.Add(KeyOf(pair.PartA, pair.PartB));
            if (_firstOfB[pair.PartB + 1] < 0) _firstOfB[pair.PartB + 1] = k;
        }
    }
}
