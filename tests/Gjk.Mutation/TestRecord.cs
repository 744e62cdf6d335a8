using System.Globalization;
using System.IO;
using System.Security.Cryptography;

namespace Gjk.Mutation;

/// <summary>Which tests reach which mutants, and how long they take; kept in a file while neither changes.</summary>
internal sealed class TestRecord
{
    private readonly List<(string Name, int Row, double Seconds, Dictionary<int, int> Reached)> _tests = [];

    private TestRecord()
    {
    }

    /// <summary>Tests that fail without a mutant, and so cannot tell.</summary>
    public List<string> Failing { get; } = [];

    public int Count => _tests.Count;

    /// <param name="tests">The recording build of the tests.</param>
    /// <param name="file">What was recorded before.</param>
    /// <param name="isKept">Whether tests of the same name are taken to be the same, though others were added.</param>
    public static TestRecord Of(string tests, string file, bool isKept)
    {
        string folder = Path.GetDirectoryName(tests)!;
        string library = Hash(Path.Combine(folder, "Gjk.Core.dll")), key = $"{library} {Hash(tests)}";
        string[] known = File.Exists(file) ? File.ReadAllLines(file) : [""];
        if (known[0] != key)
        {
            known = isKept && known[0].StartsWith(library, StringComparison.Ordinal) ? known[1..] : [];
            using var process = new TestProcess(tests);
            known = [key, .. known, .. process.Record(known.Select(l => l.Split('\t')[0]).Distinct())];
            File.WriteAllLines(file, known);
        }

        var record = new TestRecord();
        foreach (string[] words in known.Skip(1).Select(l => l.Split('\t')))
        {
            if (words[3] != "ok") record.Failing.Add($"{words[0]}: {words[3]}");
            else if (words[4].Length > 0) record.Add(words);
        }

        return record;
    }

    private static string Hash(string file) => Convert.ToHexString(SHA256.HashData(File.ReadAllBytes(file)));

    /// <summary>The tests that reach a mutant.</summary>
    public IEnumerable<(string Name, int Row, double Seconds)> Reaching(int mutant) =>
        _tests.Where(t => t.Reached.ContainsKey(mutant)).Select(t => (t.Name, t.Row, t.Seconds));

    /// <summary>Which ways a branch was taken by any test: 1 where it was true, 2 where false, 3 both.</summary>
    public int WaysOf(int branch) =>
        _tests.Aggregate(0, (ways, t) => ways | t.Reached.GetValueOrDefault(branch));

    private void Add(string[] words) => _tests.Add((
        words[0],
        Number(words[1]),
        double.Parse(words[2], CultureInfo.InvariantCulture),
        words[4].Split(',').Select(n => n.Split('=')).ToDictionary(
            n => Number(n[0]), n => n.Length > 1 ? Number(n[1]) : 1)));

    private static int Number(string text) => int.Parse(text, CultureInfo.InvariantCulture);
}
