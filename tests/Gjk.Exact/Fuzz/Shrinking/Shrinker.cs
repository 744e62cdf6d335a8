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

    public static FuzzPair Shrink(FuzzPair pair, Promise<FuzzPair> promise, CancellationToken cancel) =>
        Shrink(pair, pair.Text, text => FuzzPair.TryParse(text, out FuzzPair? read) ? read : null, promise, cancel);

    /// <summary>The same for any pair that is one line of text.</summary>
    /// <param name="pair">The pair.</param>
    /// <param name="text">It as a record.</param>
    /// <param name="read">Reads a record; null for what is no such pair.</param>
    /// <param name="promise">What it breaks.</param>
    /// <param name="cancel">Ends the search.</param>
    public static TPair Shrink<TPair>(
        TPair pair, string text, Func<string, TPair?> read, Promise<TPair> promise, CancellationToken cancel)
        where TPair : class
    {
        (ShapeWords a, ShapeWords b) = FuzzText.Split(text);
        long start = Stopwatch.GetTimestamp();
        bool Breaks(ShapeWords x, ShapeWords y) =>
            read(FuzzText.Of(x, y)) is { } simpler && promise.Broken(simpler) is not null;
        for (bool found = true; found && !cancel.IsCancellationRequested && Stopwatch.GetElapsedTime(start) < Patience;)
        {
            found = false;
            if (First(SimplerShapes.Of(a), x => Breaks(x, b), start) is { } simplerA) (a, found) = (simplerA, true);
            if (First(SimplerShapes.Of(b), x => Breaks(a, x), start) is { } simplerB) (b, found) = (simplerB, true);
        }

        return read(FuzzText.Of(a, b)) ?? pair;
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
}
