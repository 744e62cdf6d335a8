using System.Runtime.Intrinsics;

namespace Gjk.Core.Tests.Queries;

/// <summary>The test assembly as a program of its own: prints which vectors the machine has and some of the golden
/// hashes, so that a test can start it under other runtime switches.</summary>
internal static class HashProgram
{
    public const string Command = "hash";

    /// <summary>The one entry point of the assembly, also for <see cref="StackProgram"/>.</summary>
    public static int Main(string[] args)
    {
        if (args is [StackProgram.Command]) return StackProgram.Run();
        if (args is not [Command, .. string[] names]) return 2;
        GoldenRun run = Read();
        Console.WriteLine(
            $"{Vector256.IsHardwareAccelerated} {Vector128.IsHardwareAccelerated} "
            + string.Join(' ', names.Select(n => run.Parts.Single(p => p.Name == n).Hash())));
        return 0;
    }

    public static GoldenRun Read() => new(Path.Combine(ProjectFolder.Root, "tests", "Cases"));
}
