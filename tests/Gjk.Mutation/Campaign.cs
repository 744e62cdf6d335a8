using System.Globalization;
using System.IO;

namespace Gjk.Mutation;

/// <summary>Runs mutants one after the other and writes what became of them.</summary>
internal sealed class Campaign(TestRecord record, string tests, string report, double budget)
{
    private readonly Dictionary<string, int> _kills = [];
    private readonly List<(Mutant Mutant, string Fate)> _fates = [];

    public void Run(IReadOnlyList<Mutant> mutants)
    {
        using var process = new TestProcess(tests);
        using var lines = new StreamWriter(report) { AutoFlush = true };
        lines.WriteLine("id\toperator\tplace\toriginal\tchanged\tfate\ttest\twhat");
        for (int i = 0; i < mutants.Count; i++)
        {
            Mutant m = mutants[i];
            (string fate, string test, string what) = Try(process, m);
            _fates.Add((m, fate));
            lines.WriteLine($"{m.Id}\t{m.Operator}\t{m.Place}\t{m.Original}\t{m.Changed}\t{fate}\t{test}\t{what}");
            if (fate is "survived" or "unreached")
                Console.WriteLine($"{m.Id} {fate}: {m.Place} [{m.Operator}] {m.Original}  =>  {m.Changed}");
        }
    }

    /// <summary>The scores by folder, and by operator.</summary>
    public void Summarize()
    {
        Table("folder", m => Path.GetDirectoryName(m.File)!.Replace('\\', '/'));
        Table("operator", m => m.Operator);
        Table("all", _ => "all");
    }

    private (string Fate, string Test, string What) Try(TestProcess process, Mutant mutant)
    {
        (string, double)[] plan = Plan(mutant, out int left);
        if (plan.Length == 0) return ("unreached", "", "");
        string? answer = process.Run(mutant.Id, plan);
        if (answer is null) return ("survived", "", $"{plan.Length} tests, {left} not run");
        string[] words = answer.Split('\t');
        string name = words[1].Split(':')[0];
        _kills[name] = _kills.GetValueOrDefault(name) + 1;
        bool isPin = mutant.Pins.Any(p => name.Contains(p, StringComparison.Ordinal));
        return (isPin ? "killed by its pin" : "killed", name, words[2]);
    }

    /// <summary>A constant's own tests first, then quick ones and those that have killed before, as long as the budget
    /// lasts.</summary>
    private (string Test, double Seconds)[] Plan(Mutant mutant, out int left)
    {
        var all = record.Reaching(mutant.Id)
            .OrderByDescending(t => mutant.Pins.Any(p => t.Name.Contains(p, StringComparison.Ordinal)))
            .ThenBy(t => (t.Seconds + 0.002) / (1 + 10 * _kills.GetValueOrDefault(t.Name))).ToList();
        double sum = 0;
        var plan = all.Where(t => t.Seconds <= budget).TakeWhile(t => (sum += t.Seconds) <= budget);
        (string, double)[] chosen = [.. plan.Select(t => ($"{t.Name}:{t.Row}", t.Seconds))];
        left = all.Count - chosen.Length;
        return chosen;
    }

    private void Table(string title, Func<Mutant, string> group)
    {
        Console.WriteLine();
        Console.WriteLine($"| {title} | run | killed | survived | unreached | score |");
        Console.WriteLine("|---|---:|---:|---:|---:|---:|");
        foreach (var part in _fates.GroupBy(f => group(f.Mutant)).OrderBy(g => g.Key, StringComparer.Ordinal))
        {
            int run = part.Count(), survived = part.Count(f => f.Fate == "survived");
            int unreached = part.Count(f => f.Fate == "unreached"), killed = run - survived - unreached;
            string score = (100.0 * killed / run).ToString("F1", CultureInfo.InvariantCulture);
            Console.WriteLine($"| {part.Key} | {run} | {killed} | {survived} | {unreached} | {score} % |");
        }
    }
}
