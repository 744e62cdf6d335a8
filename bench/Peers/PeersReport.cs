using System.Text;

namespace Gjk.Bench.Peers;

/// <summary>The rows as text.</summary>
internal static class PeersReport
{
    public static string Markdown(IReadOnlyList<PeerRow> rows, IReadOnlyList<PeerProgram> programs)
    {
        string[] names = [.. programs.Where(p => p.Program is not null).Select(p => p.Name)];
        var text = new StringBuilder();
        text.Append("| set | question | Gjk |");
        foreach (string name in names) text.Append(CultureInfo.InvariantCulture, $" {name} |");
        text.Append(" Gjk / best |\n|---|---|--:|").Insert(text.Length, "--:|", names.Length + 1).Append('\n');
        foreach (PeerRow row in rows)
        {
            text.Append(
                CultureInfo.InvariantCulture,
                $"| {row.Set} | {row.Verb.ToString().ToLowerInvariant()} | {row.Library:0} |");
            foreach (string name in names) text.Append(CultureInfo.InvariantCulture, $" {Figure(row, name)} |");
            text.Append(CultureInfo.InvariantCulture, $" {row.RatioToBest:0.00} |\n");
        }

        text.Append(
            """

            Nanoseconds per pair, nothing kept between the calls, in the fastest pass over the whole list. Library and
            engines took turns in one run on one machine, each engine in a process of its own. In brackets: how many
            answers are wrong by more than 1e-5 of the size, of 1,000 (190 in the report's scenes). Gjk's own answers
            are the exact ones rounded to float.

            """);
        foreach (PeerProgram p in programs)
        {
            string leftOut = p.Program is null ? " (left out)" : "";
            text.Append(CultureInfo.InvariantCulture, $"- {p.Name}: {p.Detail}{leftOut}\n");
        }

        return text.ToString();
    }

    /// <summary>One line per figure. The first line describes the machine.</summary>
    public static string Csv(IEnumerable<PeerRow> rows, string machine)
    {
        var text = new StringBuilder();
        text.Append("# ").Append(machine).Append("\nset,question,engine,ns,wrong\n");
        foreach (PeerRow row in rows)
        {
            string start = $"{row.Set},{row.Verb.ToString().ToLowerInvariant()}";
            text.Append(CultureInfo.InvariantCulture, $"{start},gjk,{row.Library:0.##},0\n");
            foreach ((string name, PeerFigure figure) in row.Engines)
                text.Append(CultureInfo.InvariantCulture, $"{start},{name},{figure.Nanoseconds:0.##},{figure.Wrong}\n");
        }

        return text.ToString();
    }

    private static string Figure(PeerRow row, string name)
    {
        if (!row.Engines.TryGetValue(name, out PeerFigure figure)) return "";
        string time = figure.Nanoseconds.ToString("0", CultureInfo.InvariantCulture);
        return figure.Wrong == 0 ? time : $"{time} ({figure.Wrong})";
    }
}
