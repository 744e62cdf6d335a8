using System.Collections.Generic;
using System.Threading;
using Gjk.Exact.Fuzz.Concave;
using Gjk.Exact.Fuzz.Families;
using Gjk.Exact.Fuzz.Promises;
using Gjk.Exact.Fuzz.Shrinking;

namespace Gjk.Exact.Fuzz;

/// <summary>Draws pairs of one kind and holds each to the promises of that kind.</summary>
internal interface IPairSource
{
    /// <summary>What the pair of a seed and a number breaks, shrunk, or null.</summary>
    BrokenPromise? Try(ulong seed, long index, CancellationToken cancel);
}

/// <summary>Pairs of convex shapes.</summary>
internal sealed class ConvexPairs(IReadOnlyList<Promise> promises) : IPairSource
{
    public BrokenPromise? Try(ulong seed, long index, CancellationToken cancel)
    {
        FuzzPair pair = PairFamilies.Draw(seed, index, out string family);
        foreach (Promise promise in promises)
        {
            if (promise.Broken(pair) is not { } how) continue;
            FuzzPair shrunk = Shrinker.Shrink(pair, promise, cancel);
            return new BrokenPromise(index, family, promise.Name, promise.Broken(shrunk) ?? how, shrunk.Text);
        }

        return null;
    }
}

/// <summary>Pairs of which one is not convex at least.</summary>
internal sealed class ConcavePairs : IPairSource
{
    public BrokenPromise? Try(ulong seed, long index, CancellationToken cancel)
    {
        ConcavePair pair = ConcaveFamilies.Draw(seed, index, out string family);
        foreach (ConcavePromise promise in ConcavePromises.All)
        {
            if (promise.Broken(pair) is not { } how) continue;
            ConcavePair shrunk = ConcaveShrinker.Shrink(pair, promise, cancel);
            return new BrokenPromise(index, family, promise.Name, promise.Broken(shrunk) ?? how, shrunk.Text);
        }

        return null;
    }
}

/// <summary>Both: so many pairs of the first kind, and then one of the other.</summary>
internal sealed class MixedPairs(IPairSource many, IPairSource few) : IPairSource
{
    private const int Period = 8;

    public BrokenPromise? Try(ulong seed, long index, CancellationToken cancel) =>
        (index % Period == Period - 1 ? few : many).Try(seed, index, cancel);
}
