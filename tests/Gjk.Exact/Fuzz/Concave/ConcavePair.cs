using Gjk.Exact.Fuzz.Blocks;

namespace Gjk.Exact.Fuzz.Concave;

/// <summary>Two posed shapes of which one is not convex, the library's cold answer, and what single queries say of all
/// parts that the raw numbers have.</summary>
internal sealed class ConcavePair
{
    private readonly ulong _seed;
    private DistanceResult[]? _all;
    private bool? _holdsPiece;

    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Its pose.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Its pose.</param>
    /// <param name="motion">How they move.</param>
    /// <param name="seed">Of what the promises draw: rays, points, limits.</param>
    /// <param name="builtA">What the library made of A, which may be wrong; null: its own.</param>
    public ConcavePair(
        RawShape a, in RigidPose poseA, RawShape b, in RigidPose poseB, PairMotion motion, ulong seed,
        AnyShape? builtA = null)
    {
        (RawA, PoseA, RawB, PoseB, Motion, _seed) = (a, poseA, b, poseB, motion, seed);
        (A, B) = (builtA ?? a.Build(), b.Build());
        (PartsA, PartsB) = (a.ListParts(), b.ListParts());
        Answer = ConcaveQuery.Distance(A, poseA, B, poseB, Scratch);
    }

    public RawShape RawA { get; }

    public RawShape RawB { get; }

    public RigidPose PoseA { get; }

    public RigidPose PoseB { get; }

    public PairMotion Motion { get; }

    public AnyShape A { get; }

    public AnyShape B { get; }

    public ConvexShape[] PartsA { get; }

    public ConvexShape[] PartsB { get; }

    /// <summary>What the cold query says, with a scratch that nothing has used.</summary>
    public PairDistance Answer { get; }

    /// <summary>Used by all promises, so that what one leaves in it may spoil the next.</summary>
    public ConcaveScratch Scratch { get; } = new();

    public int PairCount => PartsA.Length * PartsB.Length;

    /// <summary>The scene file of the pair.</summary>
    public string Text => RawJson.Of(this);

    /// <summary>The distances of all pairs of parts, those of the first part of A first.</summary>
    public DistanceResult[] All => _all ??= Ask(
        (in ConvexShape a, in ConvexShape b) => ConvexQuery.Distance(a, PoseA, b, PoseB));

    /// <summary>The least distance of two parts.</summary>
    public float Least => All.Min(one => one.Distance);

    /// <summary>Whether some query of the parts gave no answer: then nothing is known.</summary>
    public bool IsUnknown => All.Any(one => one.Status is not (GjkStatus.Separated or GjkStatus.Overlapping));

    /// <summary>Whether a piece of one lies in the inside of the other and their parts do not touch.</summary>
    public bool HoldsPiece => _holdsPiece ??= Least > 0
        && (Holds(RawA, PoseA, RawB, PartsB, PoseB) || Holds(RawB, PoseB, RawA, PartsA, PoseA));

    public bool IsOverlap => Least == 0 || HoldsPiece;

    public bool HasSolid => RawA.IsSolid || RawB.IsSolid;

    /// <summary>Length: the longest side of two parts' boxes in their frames.</summary>
    public double ScaleOf(int partA, int partB) =>
        Math.Max(LongestSide(PartsA[partA]), LongestSide(PartsB[partB]));

    /// <summary>Length: what the distance of two parts may be off as one of them is curved; 0 if none is.</summary>
    public double CurvedBandOf(in PairDistance of)
    {
        int index = IndexOf(of.PartA, of.PartB);
        if (index < 0) return 0;
        int a = index / PartsB.Length, b = index % PartsB.Length;
        return BlockJudge.IsCurved(PartsA[a]) || BlockJudge.IsCurved(PartsB[b])
            ? Accuracy.CurvedBand(of.Distance, ScaleOf(a, b))
            : 0;
    }

    /// <summary>What a promise draws.</summary>
    public Rng Random(ulong promise) => new(new Rng(_seed + promise).Next());

    public delegate T Question<T>(in ConvexShape a, in ConvexShape b);

    public T[] Ask<T>(Question<T> question)
    {
        var all = new T[PairCount];
        for (int i = 0; i < all.Length; i++)
            all[i] = question(PartsA[i / PartsB.Length], PartsB[i % PartsB.Length]);
        return all;
    }

    /// <summary>The place of two parts in <see cref="All"/>; -1 where there are none such.</summary>
    public int IndexOf(int partA, int partB)
    {
        if (RawA.IsConvex && partA == -1) partA = 0;
        else if (RawA.IsConvex) return -1;
        if (RawB.IsConvex && partB == -1) partB = 0;
        else if (RawB.IsConvex) return -1;
        return partA >= 0 && partA < PartsA.Length && partB >= 0 && partB < PartsB.Length
            ? partA * PartsB.Length + partB
            : -1;
    }

    public ConcavePair Of(RawShape a, RawShape b) => new(a, PoseA, b, PoseB, Motion, _seed);

    public ConcavePair At(in RigidPose poseA, in RigidPose poseB, PairMotion motion) =>
        new(RawA, poseA, RawB, poseB, motion, _seed);

    private bool Holds(
        RawShape outer, in RigidPose pose, RawShape inner, ConvexShape[] parts, in RigidPose innerPose)
    {
        if (!outer.IsSolid) return false;
        Double3[] corners = outer.AllCorners();
        foreach (int piece in inner.Pieces())
        {
            Double3 point = inner.CornersOf(piece) is { } exact ? exact[0] : Inner(parts[piece]);
            if (ExactWinding.About(corners, pose, point, innerPose, Random(0)) is not (0 or null)) return true;
        }

        return false;
    }

    private static double LongestSide(in ConvexShape part)
    {
        double longest = 0;
        foreach (Double3 axis in (Double3[])[new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)])
        {
            part.Support(axis, out Double3 high);
            part.Support(-axis, out Double3 low);
            longest = Math.Max(longest, Double3.Dot(axis, high - low));
        }

        return longest + 2 * part.Margin;
    }

    private static Double3 Inner(in ConvexShape part)
    {
        part.Support(new Double3(1, 0, 0), out Double3 point);
        return part.Center + point;
    }
}
