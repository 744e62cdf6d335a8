using Gjk.Bench.Table;

namespace Gjk.Bench.Peers;

/// <summary>What the other engines are asked.</summary>
internal enum PeerVerb
{
    Distance,
    Boolean,
    Depth,
}

/// <summary>One of the other engines: a program that answers and times pairs in a process of its own.</summary>
internal sealed class PeerProcess : IDisposable
{
    private readonly Process _process;

    /// <param name="name">The engine's.</param>
    /// <param name="program">The program's file.</param>
    public PeerProcess(string name, string program)
    {
        Name = name;
        var start = new ProcessStartInfo(program) { RedirectStandardInput = true, RedirectStandardOutput = true };
        _process = Process.Start(start) ?? throw new InvalidOperationException($"{program} does not start");
    }

    public string Name { get; }

    public void Load(string pairFile) => Ask($"load {pairFile}");

    /// <summary>Whether it answers this of the pairs that were loaded.</summary>
    public bool Can(PeerVerb verb) => Ask($"can {WordOf(verb)}") == "yes";

    /// <summary>Takes a few samples; gives nanoseconds per pair of the fastest.</summary>
    public double Turn(PeerVerb verb) => double.Parse(Ask($"turn {WordOf(verb)}"), CultureInfo.InvariantCulture);

    /// <summary>Its answers: whether the pair overlaps, and distance or depth; NaN where it has none.</summary>
    public (bool Overlap, double Value)[] Answers(PeerVerb verb, int pairs)
    {
        var answers = new (bool, double)[pairs];
        string line = Ask($"answers {WordOf(verb)}");
        for (int i = 0; i < pairs; i++)
        {
            string[] words = (i == 0 ? line : Read()).Split(' ');
            bool hasValue = double.TryParse(words[1], CultureInfo.InvariantCulture, out double value);
            answers[i] = (words[0] == "1", hasValue ? value : double.NaN);
        }

        return answers;
    }

    public void Dispose()
    {
        try
        {
            _process.StandardInput.WriteLine("quit x");
            _process.StandardInput.Close();
        }
        catch (IOException)
        {
            // The process is gone already.
        }

        if (!_process.WaitForExit(TimeSpan.FromSeconds(2))) _process.Kill();
        _process.Dispose();
    }

    private static string WordOf(PeerVerb verb) => verb.ToString().ToLowerInvariant();

    private string Ask(string line)
    {
        _process.StandardInput.WriteLine(line);
        _process.StandardInput.Flush();
        return Read();
    }

    private string Read() => _process.StandardOutput.ReadLine()
        ?? throw new FactorCheckException($"{Name} ended before it had answered");
}

/// <summary>An engine's loop over the pairs that it has loaded, measured in turns with others.</summary>
internal sealed class PeerLoop(PeerProcess process, PeerVerb verb) : ITurn
{
    /// <inheritdoc/>
    public double Nanoseconds { get; private set; } = double.PositiveInfinity;

    public string Engine => process.Name;

    /// <inheritdoc/>
    public bool Turn(double share)
    {
        double before = Nanoseconds;
        Nanoseconds = Math.Min(before, process.Turn(verb));
        return Nanoseconds < before * (1 - share);
    }

    /// <inheritdoc/>
    public void Reset() => Nanoseconds = double.PositiveInfinity;
}
