using System.Diagnostics;
using System.Threading;
using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Exact.Fuzz.Shrinking;

/// <summary>Makes a pair that breaks a promise as small as it gets while it still breaks the same one.</summary>
internal static class Shrinker
{
    /// <summary>Large hulls have very many smaller ones; what is found by then is small enough to be looked
    /// at.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(20);

    public static FuzzPair Shrink(FuzzPair pair, Promise<FuzzPair> promise, CancellationToken cancel)
    {
        (ShapeWords a, ShapeWords b) = FuzzText.Split(pair.Text);
        long start = Stopwatch.GetTimestamp();
        bool Breaks(ShapeWords x, ShapeWords y) => IsBroken(FuzzText.Of(x, y), promise);
        for (bool found = true; found && !cancel.IsCancellationRequested && Stopwatch.GetElapsedTime(start) < Patience;)
        {
            found = false;
            if (First(SimplerShapes.Of(a), x => Breaks(x, b), start) is { } simplerA) (a, found) = (simplerA, true);
            if (First(SimplerShapes.Of(b), x => Breaks(a, x), start) is { } simplerB) (b, found) = (simplerB, true);
        }

        return FuzzPair.TryParse(FuzzText.Of(a, b), out FuzzPair? shrunk) ? shrunk : pair;
    }

    private static ShapeWords? First(IEnumerable<ShapeWords> candidates, Func<ShapeWords, bool> breaks, long start)
    {
        foreach (ShapeWords candidate in candidates)
        {
            if (Stopwatch.GetElapsedTime(start) > Patience) return null;
            if (breaks(candidate)) return candidate;
        }

        return null;
    }

    private static bool IsBroken(string text, Promise<FuzzPair> promise) =>
        FuzzPair.TryParse(text, out FuzzPair? pair) && promise.Broken(pair) is not null;
}
