namespace Gjk.Pages;

/// <summary>Engines that took turns with the library on one machine.</summary>
internal static class PeerTables
{
    private static readonly string[] Engines = ["bullet", "libccd", "fcl", "ode"];

    private static readonly string[] Heads = ["Bullet 3.24", "libccd 2.1", "FCL 0.7", "ODE 0.16"];

    /// <summary>How many times the library's time an engine takes, and how many of its answers are wrong.</summary>
    public static string Ratios(ResultFile peers)
    {
        IEnumerable<(string Set, string Question)> asked = peers.Rows(("engine", "gjk"))
            .Select(row => (peers.Cell(row, "set"), peers.Cell(row, "question")))
            .Where(a => !IsSurface(a.Item1)).OrderBy(a => Array.IndexOf(["distance", "boolean", "depth"], a.Item2));
        return Shown.Table(["question", "set", .. Heads], 2, asked.Select(a => (IEnumerable<string>)
            [a.Question, a.Set, .. Engines.Select(engine => Ratio(peers, a.Set, a.Question, engine))]));
    }

    /// <summary>Microseconds on two surfaces of many triangles.</summary>
    public static string Surfaces(ResultFile peers)
    {
        IEnumerable<string> sets = peers.Rows(("engine", "gjk"), ("question", "distance"))
            .Select(row => peers.Cell(row, "set")).Where(IsSurface);
        return Shown.Table(
            ["two surfaces", "distance, **Gjk**", "FCL 0.7", "overlap, **Gjk**", "FCL 0.7"], 1,
            sets.Select(set => (IEnumerable<string>)[set,
                .. from question in new[] { "distance", "boolean" }
                   from engine in new[] { "gjk", "fcl" }
                   let other = engine == "gjk" ? "fcl" : "gjk"
                   let time = Time(peers, set, question, engine)
                   select Shown.Bold(Shown.TwoDigits(time / 1000), time < Time(peers, set, question, other))]));
    }

    public static string Ratio(ResultFile peers, string set, string question, string engine)
    {
        double ratio = Time(peers, set, question, engine) / Time(peers, set, question, "gjk");
        if (double.IsNaN(ratio)) return "-";
        double wrong = peers.Number("wrong", ("set", set), ("question", question), ("engine", engine));
        return Shown.Bold(Shown.TwoDigits(ratio), ratio < 1) + (wrong > 0 ? $" ({Shown.Whole(wrong)})" : "");
    }

    private static double Time(ResultFile peers, string set, string question, string engine) =>
        peers.Number("ns", ("set", set), ("question", question), ("engine", engine));

    private static bool IsSurface(string set) => set.Contains("100k") || set.Contains("10k");
}
