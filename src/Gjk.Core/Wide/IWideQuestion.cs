#if NET
namespace Gjk.Core;

/// <summary>What is asked about the pairs of a batch.</summary>
internal unsafe interface IWideQuestion
{
    /// <summary>How far apart shapes may be before the walk may end early.</summary>
    double Reach { get; }

    /// <summary>Answers a pair that needs no walk, or says how it is to be asked.</summary>
    WideRoute Route(in WideBatch batch, int pair);

    /// <summary>Answers four pairs of the same route, whose frames are composed.</summary>
    /// <param name="a">The first shapes.</param>
    /// <param name="b">The second shapes.</param>
    /// <param name="batch">Has the poses.</param>
    /// <param name="pairs">The frames.</param>
    /// <param name="index">The pairs' places in the part.</param>
    /// <param name="lanes">How many of the four are pairs of their own.</param>
    /// <returns>One bit for each that was answered.</returns>
    uint AskFour<TA, TB>(ref TA a, ref TB b, in WideBatch batch, ref WidePairs pairs, int* index, int lanes)
        where TA : struct, IWideSide
        where TB : struct, IWideSide;

    /// <summary>Answers one pair by its own query.</summary>
    void Alone(in WideBatch batch, int pair);
}

/// <summary>How a pair is asked.</summary>
internal enum WideRoute
{
    /// <summary>Not at all: it has its answer.</summary>
    Answered,

    /// <summary>By its own query.</summary>
    Alone,

    /// <summary>In a lane, if both shapes' kinds have lanes, from a direction.</summary>
    Cold,

    /// <summary>In a lane, if both shapes' kinds have lanes, from the feature that it ended with.</summary>
    Warm,

    /// <summary>In a lane, if both shapes' kinds have lanes, from the tetrahedron that it ended with.</summary>
    Inside,
}

/// <summary>How far apart each pair is.</summary>
internal readonly unsafe ref struct WideDistances(ref DistanceResult results, float maxDistance) : IWideQuestion
{
    private readonly ref DistanceResult _results = ref results;
    private readonly float _maxDistance = maxDistance;

    public double Reach => ProvedDistance.ShapeReach(_maxDistance);

    public WideRoute Route(in WideBatch batch, int pair) => WideRoute.Cold;

    public uint AskFour<TA, TB>(ref TA a, ref TB b, in WideBatch batch, ref WidePairs pairs, int* index, int lanes)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        Unsafe.SkipInit(out WideResults found);
        WideDistance.Solve(ref a, ref b, ref pairs);
        uint own = (1u << lanes) - 1;
        uint done = own & WideFinish.Finish(ref a, ref b, batch, index, ref pairs, _maxDistance, ref found);
        found.Write(done, index, ref _results);
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

    public double Reach => ProvedDistance.ShapeReach(0);

    /// <summary>Balls that are apart need no walk (<c>OverlapSolver.AreBallsApart</c>); hulls without margins are as
    /// fast alone.</summary>
    public WideRoute Route(in WideBatch batch, int pair)
    {
        ref ConvexShape a = ref batch.ShapeA(pair), b = ref batch.ShapeB(pair);
        if (OverlapSolver.AreBallsApart(ref a, batch.PoseA(pair), ref b, batch.PoseB(pair)))
        {
            Unsafe.Add(ref _results, pair) = GjkStatus.Separated;
            return WideRoute.Answered;
        }

        bool isWide = a.Margin + b.Margin > 0 || (((a.Core ^ CoreKind.Hull) & ~CoreKind.Moved) != 0
            && ((b.Core ^ CoreKind.Hull) & ~CoreKind.Moved) != 0);
        return isWide ? WideRoute.Cold : WideRoute.Alone;
    }

    public uint AskFour<TA, TB>(ref TA a, ref TB b, in WideBatch batch, ref WidePairs pairs, int* index, int lanes)
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
