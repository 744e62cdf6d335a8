using System;
using System.Collections.Generic;
using System.Reflection;
using System.Runtime.Versioning;
using Gjk.Core;
using Gjk.Exact.Answers;
using Gjk.Exact.Scenes;

namespace Gjk.Mono;

/// <summary>
/// Runs the hard cases, the golden hash and the time per pair on the runtime that started this program.
/// </summary>
internal static class Program
{
    private const int FailuresShown = 5;

    private static int Main(string[] args)
    {
        string target = typeof(ConvexQuery).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName;
        Console.WriteLine($"{target} on {Runtime()}");
        int passed = 0, failed = 0;
        var all = new ResultHash();
        foreach (string family in CaseFile.Families)
        {
            List<HardCase> cases = CaseFile.Read(args[0], family);
            int wrong = Check(cases, ref all);
            failed += wrong;
            passed += cases.Count - wrong;
            Console.WriteLine($"{family}: {cases.Count} pairs, {wrong} wrong");
        }

        string golden = GoldenHashes.Of(target)["allCases"];
        bool same = all.ToString() == golden;
        Console.WriteLine($"hash of the cases: {all}, {(same ? "the same as" : "not that of")} .NET ({golden})");
        foreach (BuiltInScene scene in new[] { BuiltInScenes.Cubes(), BuiltInScenes.Spheres() })
            Console.WriteLine(
                FormattableString.Invariant($"{scene.Name}: {SceneClock.NanosecondsPerPair(scene):F0} ns per pair"));
        Console.WriteLine($"{passed} passed, {failed} failed");
        return failed == 0 ? 0 : 1;
    }

    private static int Check(List<HardCase> cases, ref ResultHash hash)
    {
        int wrong = 0;
        foreach (HardCase c in cases)
        {
            DistanceResult r = ConvexQuery.Distance(c.A.Shape, c.A.Pose, c.B.Shape, c.B.Pose);
            hash.Add(c.IndexA, c.IndexB, r);
            if (Verdict.Problem(c, r) is not { } problem) continue;
            if (++wrong <= FailuresShown) Console.WriteLine($"{c.Name}: {problem}");
        }

        return wrong;
    }

    /// <summary>The name of the runtime. Mono names itself in a type that no other runtime has.</summary>
    private static string Runtime()
    {
        const BindingFlags hidden = BindingFlags.NonPublic | BindingFlags.Static;
        MethodInfo? name = Type.GetType("Mono.Runtime")?.GetMethod("GetDisplayName", hidden);
        return name is null ? Environment.Version.ToString() : $"Mono {name.Invoke(null, null)}";
    }
}
