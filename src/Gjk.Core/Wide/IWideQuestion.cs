#if NET9_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Gjk.Core;

/// <summary>What is asked about the pairs of a batch.</summary>
internal unsafe interface IWideQuestion
{
    /// <summary>How far apart shapes may be before the walk may end early; see <c>ConvexQuery.ShapeReach</c>.</summary>
    double Reach { get; }

    /// <summary>Whether two shapes, of kinds that have lanes, are asked in them.</summary>
    bool IsWide(in ConvexShape a, in ConvexShape b);

    /// <summary>Answers a pair that needs no walk.</summary>
    bool TryAnswer(in WideBatch batch, int pair);

    /// <summary>Answers four pairs, whose frames are composed.</summary>
    /// <param name="a">The first shapes.</param>
    /// <param name="b">The second shapes.</param>
    /// <param name="pairs">The frames.</param>
    /// <param name="index">The pairs' places in the part.</param>
    /// <param name="lanes">How many of the four are pairs of their own.</param>
    /// <returns>One bit for each that was answered.</returns>
    uint AskFour<TA, TB>(ref TA a, ref TB b, ref WidePairs pairs, int* index, int lanes)
        where TA : struct, IWideSide
        where TB : struct, IWideSide;

    /// <summary>Answers one pair by its own query.</summary>
    void Alone(in WideBatch batch, int pair);
}

/// <summary>How far apart each pair is.</summary>
internal readonly unsafe ref struct WideDistances(ref DistanceResult results, float maxDistance) : IWideQuestion
{
    private readonly ref DistanceResult _results = ref results;
    private readonly float _maxDistance = maxDistance;

    public double Reach => ConvexQuery.ShapeReach(_maxDistance);

    public bool IsWide(in ConvexShape a, in ConvexShape b) => true;

    public bool TryAnswer(in WideBatch batch, int pair) => false;

    public uint AskFour<TA, TB>(ref TA a, ref TB b, ref WidePairs pairs, int* index, int lanes)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        Unsafe.SkipInit(out WideResults found);
        WideDistance.Solve(ref a, ref b, ref pairs);
        uint done = WideFinish.Finish(ref a, ref b, ref pairs, _maxDistance, ref found);
        for (int i = 0; i < lanes; i++)
            if ((done >> i & 1) != 0) found.Write(i, out Unsafe.Add(ref _results, index[i]));
        return done;
    }

    public void Alone(in WideBatch batch, int pair) =>
        Unsafe.Add(ref _results, pair) = ConvexQuery.Distance(
            batch.ShapeA(pair), batch.PoseA(pair), batch.ShapeB(pair), batch.PoseB(pair), _maxDistance);
}

/// <summary>Whether each pair overlaps.</summary>
internal readonly unsafe ref struct WideOverlaps(ref GjkStatus results) : IWideQuestion
{
    private readonly ref GjkStatus _results = ref results;

    public double Reach => ConvexQuery.ShapeReach(0);

    /// <summary>Meshes without margins are as fast alone.</summary>
    public bool IsWide(in ConvexShape a, in ConvexShape b) =>
        a.Margin + b.Margin > 0 || (a.Core == CoreKind.Box && b.Core == CoreKind.Box);

    /// <summary>Balls that are apart; see <c>ConvexQuery.AreBallsApart</c>.</summary>
    public bool TryAnswer(in WideBatch batch, int pair)
    {
        if (!ConvexQuery.AreBallsApart(
            ref batch.ShapeA(pair), batch.PoseA(pair), ref batch.ShapeB(pair), batch.PoseB(pair)))
        {
            return false;
        }

        Unsafe.Add(ref _results, pair) = GjkStatus.Separated;
        return true;
    }

    public uint AskFour<TA, TB>(ref TA a, ref TB b, ref WidePairs pairs, int* index, int lanes)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        uint apart, overlapping;
        if (pairs.MarginA + pairs.MarginB == Vector256<double>.Zero)
        {
            WideOverlap.Solve(ref a, ref b, ref pairs, out apart, out overlapping);
        }
        else
        {
            // Margins are for the distance.
            WideDistance.Solve(ref a, ref b, ref pairs);
            WideFinish.Statuses(ref pairs, out apart, out overlapping);
        }

        for (int i = 0; i < lanes; i++)
        {
            if (((apart | overlapping) >> i & 1) == 0) continue;
            Unsafe.Add(ref _results, index[i]) =
                (overlapping >> i & 1) != 0 ? GjkStatus.Overlapping : GjkStatus.Separated;
        }

        return apart | overlapping;
    }

    public void Alone(in WideBatch batch, int pair) =>
        ConvexQuery.Overlaps(
            batch.ShapeA(pair), batch.PoseA(pair), batch.ShapeB(pair), batch.PoseB(pair),
            out Unsafe.Add(ref _results, pair));
}
#endif
