#if NET
namespace Gjk.Core;

/// <summary>How far apart each pair is, from where it ended the last time.</summary>
/// <param name="results">Where the answers go, one for each pair.</param>
/// <param name="starts">The warm starts, one for each pair.</param>
/// <param name="answered">Whether each pair has its answer; a null reference where none has.</param>
/// <param name="maxDistance">As in <see cref="ConvexQuery"/>.</param>
internal readonly unsafe ref struct WideWarmDistances(
    ref DistanceResult results, ref WarmStart starts, ref bool answered, float maxDistance) : IWideQuestion
{
    private readonly ref DistanceResult _results = ref results;
    private readonly ref WarmStart _starts = ref starts;
    private readonly float _maxDistance = maxDistance;
    private readonly ref bool _answered = ref answered;

    public double Reach => ProvedDistance.ShapeReach(_maxDistance);

    /// <summary>What no query has stored is for the query alone.</summary>
    public WideRoute Route(in WideBatch batch, int pair)
    {
        if (!Unsafe.IsNullRef(ref _answered) && Unsafe.Add(ref _answered, pair)) return WideRoute.Answered;
        int count = Unsafe.Add(ref _starts, pair).Count;
        if (count == 0) return WideRoute.Cold;
        if (count == WideWarmStart.MostVertices) return WideRoute.Inside;
        return (uint)count < WideWarmStart.MostVertices ? WideRoute.Warm : WideRoute.Alone;
    }

    public uint AskFour<TA, TB>(ref TA a, ref TB b, in WideBatch batch, ref WidePairs pairs, int* index, int lanes)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        Unsafe.SkipInit(out WideResults found);
        if (Unsafe.Add(ref _starts, index[0]).Count == 0)
        {
            WideWarmStart.Direct(ref _starts, index, ref pairs);
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
        WideWarmStart.Store(ref a, ref b, pairs, done, index, ref _starts);
        return done;
    }

    public void Alone(in WideBatch batch, int pair) =>
        Unsafe.Add(ref _results, pair) = ConvexQuery.Distance(
            batch.ShapeA(pair), batch.PoseA(pair), batch.ShapeB(pair), batch.PoseB(pair),
            ref Unsafe.Add(ref _starts, pair), _maxDistance);
}
#endif
