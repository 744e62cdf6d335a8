using System.Threading;
using Gjk.Exact.Fuzz.Concave;
using Gjk.Exact.Fuzz.Families;
using Gjk.Exact.Fuzz.HalfSpaces;
using Gjk.Exact.Fuzz.Promises;
using Gjk.Exact.Fuzz.Shrinking;

namespace Gjk.Exact.Fuzz;

/// <summary>Draws pairs of one kind and holds each to the promises of that kind.</summary>
internal interface IPairSource
{
    /// <summary>What the pair of a seed and a number breaks, shrunk, or null.</summary>
    BrokenPromise? Try(ulong seed, long index, CancellationToken cancel);
}

/// <summary>The kinds of pairs.</summary>
internal static class PairSources
{
    public static IPairSource Convex(IReadOnlyList<Promise<FuzzPair>> promises) =>
        new Drawn<FuzzPair>(PairFamilies.Draw, promises, Shrinker.Shrink, pair => pair.Text);

    /// <summary>Pairs of which one is not convex at least.</summary>
    public static IPairSource Concave() => new Drawn<ConcavePair>(
        ConcaveFamilies.Draw, ConcavePromises.All, ConcaveShrinker.Shrink, pair => pair.Text);

    /// <summary>Pairs of which one is a half-space.</summary>
    public static IPairSource HalfSpaces() => new Drawn<HalfSpacePair>(
        HalfSpaceFamilies.Draw, HalfSpacePromises.All, HalfSpacePair.Shrink, pair => pair.Text);

    private delegate TPair Draw<TPair>(ulong seed, long index, out string family);

    private delegate TPair Shrink<TPair>(TPair pair, Promise<TPair> promise, CancellationToken cancel);

    private sealed class Drawn<TPair>(
        Draw<TPair> draw, IReadOnlyList<Promise<TPair>> promises, Shrink<TPair> shrink, Func<TPair, string> textOf)
        : IPairSource
    {
        public BrokenPromise? Try(ulong seed, long index, CancellationToken cancel)
        {
            TPair pair = draw(seed, index, out string family);
            foreach (Promise<TPair> promise in promises)
            {
                if (promise.Broken(pair) is not { } how) continue;
                TPair shrunk = shrink(pair, promise, cancel);
                return new BrokenPromise(index, family, promise.Name, promise.Broken(shrunk) ?? how, textOf(shrunk));
            }

            return null;
        }
    }
}

/// <summary>Both: in each eight pairs one of the second kind, which leaves the others as they are.</summary>
/// <param name="many">The first kind.</param>
/// <param name="few">The second kind.</param>
/// <param name="place">Which of the eight that is, from 0.</param>
internal sealed class MixedPairs(IPairSource many, IPairSource few, int place) : IPairSource
{
    private const int Period = 8;

    public BrokenPromise? Try(ulong seed, long index, CancellationToken cancel) =>
        (index % Period == place ? few : many).Try(seed, index, cancel);
}
