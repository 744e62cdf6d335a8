namespace Gjk.Bench.Peers;

/// <summary>An engine's program, or why there is none.</summary>
/// <param name="Name">The engine.</param>
/// <param name="Detail">Its version, or why it is missing.</param>
/// <param name="Program">The program's file; null where it is missing.</param>
internal sealed record PeerProgram(string Name, string Detail, string? Program);

/// <summary>Builds the programs of the other engines with <c>peers/build.sh</c>.</summary>
internal static class PeerBuild
{
    /// <exception cref="FactorCheckException">The script cannot be run.</exception>
    public static List<PeerProgram> Run(string project, string folder)
    {
        var start = new ProcessStartInfo("bash") { RedirectStandardOutput = true };
        start.ArgumentList.Add(Path.Combine(project, "peers", "build.sh"));
        start.ArgumentList.Add(folder);
        var programs = new List<PeerProgram>();
        try
        {
            using Process process = Process.Start(start)!;
            while (process.StandardOutput.ReadLine() is string line) programs.Add(Parse(line, folder));
            process.WaitForExit();
        }
        catch (System.ComponentModel.Win32Exception e)
        {
            throw new FactorCheckException($"--peers: bash cannot be run: {e.Message}");
        }

        return programs;
    }

    private static PeerProgram Parse(string line, string folder)
    {
        string[] words = line.Split(' ', 3);
        string name = words[1].TrimEnd(':');
        return words[0] == "built"
            ? new PeerProgram(name, words[2], Path.Combine(folder, name))
            : new PeerProgram(name, words.Length > 2 ? words[2] : "missing", null);
    }
}
