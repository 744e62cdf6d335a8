using Gjk.Bench.Table;

namespace Gjk.Bench.Peers;

/// <summary>The figures of one set.</summary>
/// <param name="Set">The set's name.</param>
/// <param name="Verb">The question.</param>
/// <param name="Library">The library's nanoseconds per pair.</param>
/// <param name="Engines">By engine's name; one that does not answer such pairs is not there.</param>
internal sealed record PeerRow(string Set, PeerVerb Verb, double Library, Dictionary<string, PeerFigure> Engines)
{
    /// <summary>The library's time over that of the fastest engine; null where none answers.</summary>
    public double? RatioToBest => Library / Engines.Values.Min(f => (double?)f.Nanoseconds);
}

/// <summary>The library and the other engines on the same pairs, in turns, in one run on one machine.</summary>
internal static class PeersRun
{
    /// <summary>Seconds for each set, shared by all programs.</summary>
    public const double DefaultSeconds = 2;

    /// <summary>The most seconds in which a set's loops are warmed up.</summary>
    private const double WarmUpSeconds = 2;

    /// <exception cref="FactorCheckException">No engine can be had, or one ends early.</exception>
    public static List<PeerRow> Run(TextWriter progress, string project, double seconds, out List<PeerProgram> programs)
    {
        var rows = new List<PeerRow>();
        programs = WithEngines(progress, project, (processes, folder) =>
        {
            string file = Path.Combine(folder, "pairs.bin");
            foreach (Func<PeerSet[]> make in PeerSet.All())
            {
                PeerSet[] sets = make();
                sets[0].Write(file);
                foreach (PeerProcess process in processes) process.Load(file);
                foreach (PeerSet set in sets)
                {
                    progress.WriteLine($"{set.Name}, {set.Verb.ToString().ToLowerInvariant()}");
                    rows.Add(Measure(set, processes, seconds));
                }
            }
        });
        return rows;
    }

    /// <summary>Builds and starts the engines' programs, in a folder that is there as long as the work.</summary>
    /// <exception cref="FactorCheckException">No engine can be had, or one ends early.</exception>
    public static List<PeerProgram> WithEngines(
        TextWriter progress, string project, Action<List<PeerProcess>, string> work)
    {
        string folder = Directory.CreateTempSubdirectory("gjk-peers").FullName;
        var processes = new List<PeerProcess>();
        try
        {
            progress.WriteLine("building the other engines' programs");
            List<PeerProgram> programs = PeerBuild.Run(project, folder);
            foreach (PeerProgram p in programs)
            {
                progress.WriteLine($"{p.Name}: {p.Detail}");
                if (p.Program is not null) processes.Add(new PeerProcess(p.Name, p.Program));
            }

            if (processes.Count == 0) throw new FactorCheckException("--peers: no other engine can be had here");
            work(processes, folder);
            return programs;
        }
        finally
        {
            foreach (PeerProcess process in processes) process.Dispose();
            Directory.Delete(folder, recursive: true);
        }
    }

    private static PeerRow Measure(PeerSet set, List<PeerProcess> processes, double seconds)
    {
        PeerProcess[] able = [.. processes.Where(p => p.Can(set.Verb))];
        TimedLoop library = set.Library();
        PeerLoop[] loops = [.. able.Select(p => new PeerLoop(p, set.Verb))];
        ITurn[] all = [library, .. loops];
        TurnTaking.WarmUp(all, WarmUpSeconds);
        TurnTaking.Measure(all, seconds);
        var engines = new Dictionary<string, PeerFigure>();
        for (int i = 0; i < able.Length; i++)
        {
            int wrong = set.Wrong(able[i].Answers(set.Verb, set.PairCount));
            engines.Add(able[i].Name, new PeerFigure(loops[i].Nanoseconds, wrong));
        }

        return new PeerRow(set.Name, set.Verb, library.Nanoseconds, engines);
    }
}
