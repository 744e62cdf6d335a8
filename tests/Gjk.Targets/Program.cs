using System;
using System.Diagnostics;
#if NETFRAMEWORK
using System.Linq;
#endif
using System.Reflection;
using System.Runtime.InteropServices;
using System.Runtime.Versioning;
using Gjk.Core;
using Gjk.Exact.Answers;
using Gjk.Exact.Cases;
using Gjk.Exact.Scenes;

namespace Gjk.Targets;

/// <summary>Runs the hard pairs and the golden hashes on the runtime that started this program, and counts what queries
/// allocate; asked to, the time per pair of the built-in scenes too.</summary>
internal static class Program
{
    private const int FailuresShown = 5;

    private static int Main(string[] args)
    {
        var clock = Stopwatch.StartNew();
        string target = typeof(ConvexQuery).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName;
        Console.WriteLine($"{target} on {Runtime()}");
        var run = new GoldenRun(args[0]);
        int passed = 0, failed = 0;
        foreach (CaseFile family in run.Families)
        {
            int wrong = Check(family);
            failed += wrong;
            passed += family.Pairs.Count - wrong;
        }

        Console.WriteLine($"{passed + failed} hard pairs, {failed} wrong");
        CheckHashes(run, ref passed, ref failed);
        long bytes = Allocation.OfQueries();
        Console.WriteLine($"queries allocated {bytes} bytes");
        if (bytes == 0) passed++;
        else failed++;

#if NETFRAMEWORK
        if (Array.IndexOf(args, "--native-thread") > 0)
        {
            Console.WriteLine("on a thread of native code, in the precision that Mono gives it:");
            NativeThread.Run(
                () => CheckHashes(run, ref passed, ref failed),
                () =>
                {
                    int wrong = run.Families.Sum(Check);
                    failed += wrong;
                    passed += run.Families.Sum(f => f.Pairs.Count) - wrong;
                    int moved = run.Parts.Count(p => p.Hash().ToString() != GoldenHashes.All[p.Name]);
                    Console.WriteLine(
                        $"its x87 unit in extended precision again: {wrong} hard pairs wrong, {moved} hashes moved");
                });
        }
#endif
        Console.WriteLine(FormattableString.Invariant($"took {clock.Elapsed.TotalSeconds:F1} s"));
        if (Array.IndexOf(args, "--time") > 0)
        {
            foreach (BuiltInScene scene in new[] { BuiltInScenes.Cubes(), BuiltInScenes.Spheres() })
            {
                double time = SceneClock.NanosecondsPerPair(scene);
                Console.WriteLine(FormattableString.Invariant($"{scene.Name}: {time:F0} ns per pair"));
            }
        }

        Console.WriteLine($"{passed} passed, {failed} failed");
        return failed == 0 ? 0 : 1;
    }

    private static void CheckHashes(GoldenRun run, ref int passed, ref int failed)
    {
        foreach ((string name, Func<BitHash> make) in run.Parts)
        {
            string hash = make().ToString(), golden = GoldenHashes.All[name];
            bool isSame = hash == golden;
            if (isSame) passed++;
            else failed++;
            Console.WriteLine($"hash of {name}: {hash}" + (isSame ? "" : $", not the golden {golden}"));
        }
    }

    private static int Check(CaseFile family)
    {
        int wrong = 0;
        foreach (CasePair c in family.Pairs)
        {
            if (Verdict.Problem(family.Kind, c) is not { } problem) continue;
            if (++wrong <= FailuresShown) Console.WriteLine($"{c.Name}: {problem}");
        }

        return wrong;
    }

    /// <summary>The name of the runtime. Mono names itself in a type that no other runtime has.</summary>
    private static string Runtime()
    {
        const BindingFlags hidden = BindingFlags.NonPublic | BindingFlags.Static;
        MethodInfo? name = Type.GetType("Mono.Runtime")?.GetMethod("GetDisplayName", hidden);
        return name is null
            ? $"{RuntimeInformation.FrameworkDescription}, {RuntimeInformation.ProcessArchitecture}{Vectors()}"
            : $"Mono {name.Invoke(null, null)}";
    }

    /// <summary>Which vectors the processor computes by itself; the library asks for both widths.</summary>
    private static string Vectors() =>
#if NET
        $", vectors of 128 bits: {System.Runtime.Intrinsics.Vector128.IsHardwareAccelerated}, "
        + $"256: {System.Runtime.Intrinsics.Vector256.IsHardwareAccelerated}, "
        + $"NEON: {System.Runtime.Intrinsics.Arm.AdvSimd.Arm64.IsSupported}";
#else
        "";
#endif
}
