using System;
using System.Linq;
using System.Runtime.Intrinsics;
using System.Threading.Tasks;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Queries;

/// <summary>
/// The test assembly as a program of its own: prints the hash of all hard cases and which vectors the machine has, so
/// that a test can start it under other runtime switches.
/// </summary>
internal static class HashProgram
{
    public const string Command = "hash";

    public static int Main(string[] args)
    {
        if (args is not [Command]) return 2;
        Console.WriteLine(
            $"{Vector256.IsHardwareAccelerated} {Vector128.IsHardwareAccelerated} {OfAllCases(parallel: false)}");
        return 0;
    }

    public static string OfAllCases(bool parallel)
    {
        HardCase[] cases = [.. CaseFamily.Names.SelectMany(f => CaseFamily.Load(f).Cases)];
        var results = new DistanceResult[cases.Length];
        if (parallel) Parallel.For(0, cases.Length, i => results[i] = cases[i].Pair.Distance());
        else for (int i = 0; i < cases.Length; i++) results[i] = cases[i].Pair.Distance();

        var hash = new ResultHash();
        for (int i = 0; i < cases.Length; i++) hash.Add(cases[i].IndexA, cases[i].IndexB, results[i]);
        return hash.ToString();
    }
}
