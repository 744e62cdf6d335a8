using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Gjk.Core;
using Gjk.Demo.Fuzz.Promises;

namespace Gjk.Demo.Fuzz.Shrinking;

/// <summary>Makes a pair that breaks a promise as small as it gets while it still breaks the same one.</summary>
internal static class Shrinker
{
    private const string Tag = "gjk1";

    /// <summary>Large hulls have very many smaller ones; what is found by then is small enough to be looked at.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(20);

    public static QueryRecord Shrink(in QueryRecord record, IPromise promise, CancellationToken cancel)
    {
        var words = new Queue<string>(record.ToString().Split(' ').Skip(1));
        ShapeWords a = ShapeWords.Read(words), b = ShapeWords.Read(words);
        long start = Stopwatch.GetTimestamp();
        bool Breaks(ShapeWords x, ShapeWords y) => IsBroken(Text(x, y), promise);
        for (bool found = true; found && !cancel.IsCancellationRequested && Stopwatch.GetElapsedTime(start) < Patience;)
        {
            found = false;
            if (First(SimplerShapes.Of(a), x => Breaks(x, b), start) is { } simplerA) (a, found) = (simplerA, true);
            if (First(SimplerShapes.Of(b), x => Breaks(a, x), start) is { } simplerB) (b, found) = (simplerB, true);
        }

        return QueryRecord.TryParse(Text(a, b), out QueryRecord shrunk, out _) ? shrunk : record;
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

    private static string Text(ShapeWords a, ShapeWords b) => $"{Tag} {a} {b}";

    private static bool IsBroken(string text, IPromise promise) =>
        QueryRecord.TryParse(text, out QueryRecord record, out _) && promise.Broken(new FuzzPair(record)) is not null;
}
