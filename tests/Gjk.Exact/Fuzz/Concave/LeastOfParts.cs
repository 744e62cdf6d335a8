namespace Gjk.Exact.Fuzz.Concave;

/// <summary>Distances against single queries of all pairs of parts, and against integers of any size.</summary>
internal static class LeastOfParts
{
    /// <summary>How many pairs of parts besides the named one are solved exactly.</summary>
    private const int Samples = 3;

    public static string? Distance(ConcavePair pair)
    {
        if (pair.IsUnknown) return null;
        PairDistance r = pair.Answer;
        bool isAnswer = r.Status is GjkStatus.Separated or GjkStatus.Overlapping;
        if (!isAnswer || r.IsOverlapping != pair.IsOverlap)
            return Say.Line($"{r}, but of all parts {pair.Least:R}, holds a piece {pair.HoldsPiece}");
        if (pair.HoldsPiece)
            return r.Distance == 0 && (r.PartA == -1 || r.PartB == -1) ? null : Say.Line($"inside: {r}");
        int index = pair.IndexOf(r.PartA, r.PartB);
        if (index < 0 || r.Distance != pair.Least || r.Result.LowerBound > pair.Least)
            return Say.Line($"{r}, bound {r.Result.LowerBound:R}, but the least of all parts is {pair.Least:R}");
        DistanceResult part = pair.All[index];
        return part.Distance == r.Distance && part.PointA == r.Result.PointA && part.PointB == r.Result.PointB
            && part.Normal == r.Result.Normal
            ? null
            : Say.Line($"{r}, but the parts say {part}");
    }

    public static string? Exact(ConcavePair pair)
    {
        PairDistance r = pair.Answer;
        int index = pair.IndexOf(r.PartA, r.PartB);
        if (index < 0 || pair.HoldsPiece) return null;
        Rng random = pair.Random(1);
        for (int i = 0; i <= Samples; i++)
        {
            int at = i == 0 ? index : random.Below(pair.PairCount);
            int partA = at / pair.PartsB.Length, partB = at % pair.PartsB.Length;
            if (pair.RawA.CornersOf(partA) is not { } a || pair.RawB.CornersOf(partB) is not { } b) continue;
            double truth = ExactOracle.Solve(
                a, pair.PartsA[partA].Margin, pair.PoseA, b, pair.PartsB[partB].Margin, pair.PoseB).Distance;
            double scale = pair.ScaleOf(partA, partB), band = Accuracy.Band(truth, scale) + Accuracy.LeastFloat;
            bool isRight = Math.Abs(pair.All[at].Distance - truth) <= band;
            if (!isRight || r.Result.LowerBound > truth + (truth > 0 ? Accuracy.LeastFloat : 0))
            {
                return Say.Line(
                    $"{r}, bound {r.Result.LowerBound:R}; parts {partA} and {partB}: {pair.All[at].Distance:R}, ")
                    + Say.Line($"truly {truth:R}");
            }
        }

        return null;
    }

    public static string? Limits(ConcavePair pair)
    {
        PairDistance r = pair.Answer;
        bool isOverlap = ConcaveQuery.Overlaps(pair.A, pair.PoseA, pair.B, pair.PoseB, pair.Scratch);
        if (isOverlap != r.IsOverlapping) return Say.Line($"Overlaps says {isOverlap}, Distance {r}");
        PairDistance within = ConcaveQuery.Distance(
            pair.A, pair.PoseA, pair.B, pair.PoseB, pair.Scratch, r.Distance);


        // A curved distance is right to a band, and a plane may prove that it is a little more.
        double band = pair.CurvedBandOf(r);
        bool isOpen = band > 0 && within.Result.LowerBound <= r.Distance + band;
        if (within.Status == GjkStatus.BeyondMaxDistance && isOpen) return null;
        if (within.Status != r.Status || within.Distance != r.Distance) return Say.Line($"within: {within}, not {r}");
        if (!(r.Distance > 0)) return null;
        float less = pair.Random(2).OneIn(2) ? MathF.BitDecrement(r.Distance) : r.Distance * 0.5f;
        PairDistance beyond = ConcaveQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, pair.Scratch, less);
        return beyond.Status == GjkStatus.BeyondMaxDistance && beyond.Result.LowerBound <= r.Distance
            ? null
            : Say.Line($"beyond {less:R}: {beyond}, bound {beyond.Result.LowerBound:R}, but {r}");
    }

    public static string? Within(ConcavePair pair)
    {
        if (pair.IsUnknown) return null;
        Rng random = pair.Random(3);
        float[] sorted = [.. pair.All.Select(one => one.Distance).Order()];
        float reach = sorted[(int)(random.Unit() * random.Unit() * sorted.Length)];
        if (random.OneIn(3)) reach *= random.Float(1, 1.1);
        if (!float.IsFinite(reach)) return null;
        var found = new List<PairDistance>();
        ConcaveQuery.FindPairsWithin(pair.A, pair.PoseA, pair.B, pair.PoseB, reach, pair.Scratch, found);
        int next = 0;
        for (int i = 0; i < pair.PairCount; i++)
        {
            if (!(pair.All[i].Distance <= reach)) continue;
            bool isNext = next < found.Count && pair.IndexOf(found[next].PartA, found[next].PartB) == i;
            if (!isNext || found[next].Distance != pair.All[i].Distance)
                return Say.Line($"within {reach:R}: pair {i} of the parts, {pair.All[i]}, is missing or wrong");
            next++;
        }

        return next == found.Count ? null : Say.Line($"within {reach:R}: {found.Count} pairs, but there are {next}");
    }

    public static string? Depths(ConcavePair pair)
    {
        if (pair.IsUnknown) return null;
        var found = new List<PairDistance>();
        ConcaveQuery.FindDepths(pair.A, pair.PoseA, pair.B, pair.PoseB, pair.Scratch, found);
        int[] overlaps = [.. Enumerable.Range(0, pair.PairCount).Where(i => pair.All[i].IsOverlapping)];
        if (!overlaps.SequenceEqual(found.Select(one => pair.IndexOf(one.PartA, one.PartB))))
            return Say.Line($"{found.Count} depths, but {overlaps.Length} pairs of parts overlap");
        for (int i = 0; i < overlaps.Length; i += 1 + overlaps.Length / 20)
        {
            DistanceResult depth = ConvexQuery.SignedDistance(
                pair.PartsA[overlaps[i] / pair.PartsB.Length], pair.PoseA,
                pair.PartsB[overlaps[i] % pair.PartsB.Length], pair.PoseB);
            if (depth.Distance != found[i].Distance) return Say.Line($"{found[i]}, but the parts say {depth}");
        }

        return null;
    }
}
