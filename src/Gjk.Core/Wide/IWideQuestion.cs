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
    uint SolveFour<TA, TB>(ref TA a, ref TB b, in WideBatch batch, ref WidePairs pairs, int* index, int lanes)
        where TA : struct, IWideSide
        where TB : struct, IWideSide;

    /// <summary>Answers one pair by its own query.</summary>
    void SolveAlone(in WideBatch batch, int pair);
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

/// <summary>How far apart each pair is, from where it ended the last time.</summary>
/// <param name="results">Where the answers go, one for each pair.</param>
/// <param name="starts">The warm starts, one for each pair; a null reference where all begin cold.</param>
/// <param name="maxDistance">As in <see cref="ConvexQuery"/>.</param>
internal readonly unsafe ref struct WideDistances(
    ref DistanceResult results, ref WarmStart starts, float maxDistance) : IWideQuestion
{
    private readonly ref DistanceResult _results = ref results;
    private readonly ref WarmStart _starts = ref starts;
    private readonly float _maxDistance = maxDistance;

    public double Reach => GjkDistance.ShapeReach(_maxDistance);

    private bool IsCold => Unsafe.IsNullRef(ref _starts);

    /// <summary>What no query has stored is for the query alone.</summary>
    public WideRoute Route(in WideBatch batch, int pair)
    {
        int count = IsCold ? 0 : Unsafe.Add(ref _starts, pair).Count;
        if (count == 0) return WideRoute.Cold;
        if (count == WideWarmStart.MostVertices) return WideRoute.Inside;
        return (uint)count < WideWarmStart.MostVertices ? WideRoute.Warm : WideRoute.Alone;
    }

    public uint SolveFour<TA, TB>(ref TA a, ref TB b, in WideBatch batch, ref WidePairs pairs, int* index, int lanes)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        Unsafe.SkipInit(out WideResults found);
        if (IsCold || Unsafe.Add(ref _starts, index[0]).Count == 0)
        {
            if (!IsCold) WideWarmStart.Direct(ref _starts, index, ref pairs);
            WideDistance.Solve(ref a, ref b, ref pairs);
        }
        else
        {
            WideWarmStart.Restore(ref a, ref b, ref _starts, index, ref pairs);
            WideDistance.Walk(ref a, ref b, ref pairs, 0);
        }

        uint own = (1u << lanes) - 1;
        uint done = own & WideFinish.Finish(ref a, ref b, batch, index, ref pairs, _maxDistance, ref found);
        found.Write(done, index, ref _results);
        if (!IsCold) WideWarmStart.Store(ref a, ref b, pairs, done, index, ref _starts);
        return done;
    }

    public void SolveAlone(in WideBatch batch, int pair)
    {
        ref ConvexShape a = ref batch.ShapeA(pair), b = ref batch.ShapeB(pair);
        ref RigidPose poseA = ref batch.PoseA(pair), poseB = ref batch.PoseB(pair);
        Unsafe.Add(ref _results, pair) = IsCold
            ? ConvexQuery.Distance(a, poseA, b, poseB, _maxDistance)
            : ConvexQuery.Distance(a, poseA, b, poseB, ref Unsafe.Add(ref _starts, pair), _maxDistance);
    }
}

/// <summary>Whether each pair overlaps.</summary>
/// <param name="results">Where the answers go, one for each pair.</param>
internal readonly unsafe ref struct WideOverlaps(ref GjkStatus results) : IWideQuestion
{
    private readonly ref GjkStatus _results = ref results;

    public double Reach => GjkDistance.ShapeReach(0);

    /// <summary>Boxes and shapes with margins gain from lanes; all others are as fast alone. Balls that are apart need
    /// no walk (<c>OverlapSolver.AreBallsApart</c>).</summary>
    public WideRoute Route(in WideBatch batch, int pair)
    {
        ref ConvexShape a = ref batch.ShapeA(pair), b = ref batch.ShapeB(pair);
        bool isWide = a.Margin + b.Margin > 0 || ((a.Core | b.Core) & ~FormKind.Moved) == FormKind.Box;
        if (!isWide) return WideRoute.Alone;
        if (!OverlapSolver.AreBallsApart(ref a, batch.PoseA(pair), ref b, batch.PoseB(pair))) return WideRoute.Cold;
        Unsafe.Add(ref _results, pair) = GjkStatus.Separated;
        return WideRoute.Answered;
    }

    public uint SolveFour<TA, TB>(ref TA a, ref TB b, in WideBatch batch, ref WidePairs pairs, int* index, int lanes)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        WideDistance.Solve(ref a, ref b, ref pairs);
        WideFinish.Statuses(ref pairs, out uint apart, out uint overlapping);
        for (int i = 0; i < lanes; i++)
        {
            if (((apart | overlapping) >> i & 1) == 0) continue;
            Unsafe.Add(ref _results, index[i]) =
                (overlapping >> i & 1) != 0 ? GjkStatus.Overlapping : GjkStatus.Separated;
        }

        return apart | overlapping;
    }

    public void SolveAlone(in WideBatch batch, int pair) =>
        ConvexQuery.Overlaps(
            batch.ShapeA(pair), batch.PoseA(pair), batch.ShapeB(pair), batch.PoseB(pair),
            out Unsafe.Add(ref _results, pair));
}
#endif
