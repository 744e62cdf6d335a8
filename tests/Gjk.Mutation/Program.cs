using System.Globalization;
using System.IO;
using System.Numerics;
using System.Text.RegularExpressions;

namespace Gjk.Mutation;

/// <summary>Makes the mutants, records which tests reach them, and runs those that are asked for.</summary>
/// <remarks>Options: --folders and --files (patterns of paths: where mutants are made, and which are run), --operators
/// (a pattern of their names; "^constant" for those of named constants, which are left out else), --ids (numbers, with
/// commas), --sample and --seed, --budget (seconds of tests that a mutant may survive), --keep (records only tests with
/// new names), --work (a folder; the fates are in mutants.tsv there). --branches makes no mutants: it names the
/// conditions that no test finds true, or none false.</remarks>
internal static class Program
{
    private const string Folders = "^(Solvers|Simplex|Contacts|Minkowski)/";

    private static int Main(string[] args)
    {
        if (args is ["serve", var tests]) return TestServer.Run(tests);
        string repository = Option(args, "--repository", ".");
        string work = Option(args, "--work", Path.Combine(Path.GetTempPath(), "gjk-mutation"));
        if (args.Contains("--branches")) work = Path.Combine(work, "coverage");
        var build = new MutatedBuild(
            Path.Combine(repository, "src", "Gjk.Core"), new Regex(Option(args, "--folders", Folders)), work);
        string built = Path.Combine(repository, "tests", "Gjk.Core.Tests", "bin", "Release", "net10.0");
        if (args.Contains("--branches")) return Cover(build, built, work, args);
        string recording = Prepared(build, built, Path.Combine(work, "record"), isRecording: true);
        string running = Prepared(build, built, Path.Combine(work, "run"), isRecording: false);
        Console.WriteLine($"{build.Mutants.Count} mutants compile, {build.Refused} do not");

        TestRecord record = TestRecord.Of(recording, Path.Combine(work, "record.txt"), args.Contains("--keep"));
        Console.WriteLine($"{record.Count} tests reach one");
        foreach (string failing in record.Failing) Console.WriteLine($"fails without a mutant: {failing}");

        List<Mutant> chosen = Chosen(build.Mutants, args);
        double budget = double.Parse(Option(args, "--budget", "60"), CultureInfo.InvariantCulture);
        var campaign = new Campaign(record, running, Path.Combine(work, "mutants.tsv"), budget);
        campaign.Run(chosen);
        campaign.Summarize();
        return 0;
    }

    /// <summary>Names the conditions that all tests find true, or all find false.</summary>
    private static int Cover(MutatedBuild build, string built, string work, string[] args)
    {
        string tests = Prepared(build, built, Path.Combine(work, "branches"), isRecording: true, onlyBranches: true);
        TestRecord record = TestRecord.Of(tests, Path.Combine(work, "branches.txt"), args.Contains("--keep"));
        int ways = 0, taken = 0;
        foreach (Mutant branch in build.Mutants)
        {
            int all = branch.Operator == "arm" ? 1 : 3, seen = record.WaysOf(branch.Id) & all;
            ways += BitOperations.PopCount((uint)all);
            taken += BitOperations.PopCount((uint)seen);
            if (seen == all) continue;
            string way = all == 1 || seen == 0 ? "never reached" : seen == 1 ? "never false" : "never true";
            Console.WriteLine($"{way}: {branch.Place} {branch.Original}");
        }

        Console.WriteLine($"{taken} of {ways} branches are taken, {build.Refused} conditions cannot tell");
        return 0;
    }

    /// <summary>All that the options ask for, or a random sample of them in a fixed order.</summary>
    private static List<Mutant> Chosen(List<Mutant> mutants, string[] args)
    {
        var operators = new Regex(Option(args, "--operators", "^(?!constant)"));
        var files = new Regex(Option(args, "--files", "."));
        string ids = Option(args, "--ids", "");
        int sample = int.Parse(Option(args, "--sample", "1000000"), CultureInfo.InvariantCulture);
        int seed = int.Parse(Option(args, "--seed", "1"), CultureInfo.InvariantCulture);
        if (ids.Length > 0)
        {
            HashSet<int> asked = [.. ids.Split(',').Select(n => int.Parse(n, CultureInfo.InvariantCulture))];
            return mutants.Where(m => asked.Contains(m.Id)).ToList();
        }

        Mutant[] all = mutants.Where(m => operators.IsMatch(m.Operator) && files.IsMatch(m.File)).ToArray();
        Console.WriteLine($"{Math.Min(sample, all.Length)} of {all.Length} are run, seed {seed}");
        new Random(seed).Shuffle(all);
        return all.Take(sample).ToList();
    }

    /// <summary>A copy of the built tests with the changed library in it.</summary>
    private static string Prepared(
        MutatedBuild build, string built, string folder, bool isRecording, bool onlyBranches = false)
    {
        foreach (string file in Directory.EnumerateFiles(built, "*", SearchOption.AllDirectories))
        {
            string copy = Path.Combine(folder, Path.GetRelativePath(built, file));
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy, overwrite: true);
        }

        build.Write(Path.Combine(folder, "Gjk.Core.dll"), isRecording, onlyBranches);
        return Path.Combine(folder, "Gjk.Core.Tests.dll");
    }

    private static string Option(string[] args, string name, string usual)
    {
        int at = Array.IndexOf(args, name);
        return at >= 0 && at + 1 < args.Length ? args[at + 1] : usual;
    }
}
