using System.Runtime.InteropServices;
using System.Text;

namespace Gjk.Bench.Reporting;

/// <summary>Describes the machine on which the figures were measured.</summary>
public static class Machine
{
    private const string Unknown = "unknown-cpu";

    /// <summary>The CPU, the number of cores, the system and the runtime, in one line.</summary>
    public static string Description =>
        $"{CpuModel}, {Environment.ProcessorCount} logical cores, {RuntimeInformation.ProcessArchitecture}, "
        + $"{RuntimeInformation.OSDescription.Trim()}, {RuntimeInformation.FrameworkDescription}";

    public static string CpuModel =>
        FromProc() ?? Environment.GetEnvironmentVariable("PROCESSOR_IDENTIFIER") ?? Unknown;

    /// <summary>A name that every file system accepts. It has lower case letters, digits and single hyphens.</summary>
    public static string FileName(string name)
    {
        var text = new StringBuilder();
        foreach (char c in name)
        {
            if (char.IsAsciiLetterOrDigit(c)) text.Append(char.ToLowerInvariant(c));
            else if (text.Length > 0 && text[^1] != '-') text.Append('-');
        }

        string trimmed = text.ToString().Trim('-');
        return trimmed.Length == 0 ? Unknown : trimmed;
    }

    private static string? FromProc()
    {
        const string Path = "/proc/cpuinfo";
        if (!File.Exists(Path)) return null;
        foreach (string line in File.ReadLines(Path))
        {
            int colon = line.IndexOf(':', StringComparison.Ordinal);
            if (colon > 0 && line.StartsWith("model name", StringComparison.Ordinal)) return line[(colon + 1)..].Trim();
        }

        return null;
    }
}
