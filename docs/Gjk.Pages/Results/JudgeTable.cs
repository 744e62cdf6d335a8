namespace Gjk.Pages;

/// <summary>How many of the hard pairs each engine gets wrong.</summary>
internal static class JudgeTable
{
    private static readonly (string Key, string Name)[] Engines =
    [
        ("gjk", "**Gjk**"), ("fcl", "FCL 0.7"), ("bullet", "Bullet 3.24"), ("libccd", "libccd 2.1"),
        ("ode", "ODE 0.16"),
    ];

    public static string Make(ResultFile judge) => Shown.Table(
        ["engine", "distances", "wrong", "beyond 1e-5", "depths", "wrong", "beyond 1e-5"], 1,
        Engines.Select(e => (IEnumerable<string>)[e.Name,
            .. from question in new[] { "distance", "depth" }
               from column in new[] { "pairs", "wrong", "wrong_1e-5" }
               let number = judge.Number(column, ("engine", e.Key), ("question", question))
               select Shown.Bold(Shown.Whole(number), e.Key == "gjk" && column != "pairs")]));

    /// <summary>Wrong answers beyond 1e-5, and times as parts of the library's, in one table.</summary>
    public static string Summary(ResultFile judge, ResultFile peers)
    {
        string[] sets = ["cubes", "hull32", "hull2048"];
        return Shown.Table(
            ["engine", "wrong distances", "wrong depths", "time, cubes", "hull of 32", "hull of 2,048"], 1,
            Engines.Select(e => (IEnumerable<string>)[e.Name,
                Wrong(judge, e.Key, "distance"), Wrong(judge, e.Key, "depth"),
                .. sets.Select(set => e.Key == "gjk"
                    ? "1" : WithoutCount(PeerTables.Ratio(peers, set, "distance", e.Key)))]));
    }

    private static string Wrong(ResultFile judge, string engine, string question)
    {
        double pairs = judge.Number("pairs", ("engine", engine), ("question", question));
        if (double.IsNaN(pairs)) return "-";
        double wrong = judge.Number("wrong_1e-5", ("engine", engine), ("question", question));
        return $"{Shown.Bold(Shown.Whole(wrong), wrong == 0)} of {Shown.Whole(pairs)}";
    }

    /// <summary>The README has its wrong answers from the hard pairs alone.</summary>
    private static string WithoutCount(string ratio) => ratio.Split(' ')[0];
}
