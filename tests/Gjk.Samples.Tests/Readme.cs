using System;
using System.IO;
using System.Linq;
using Xunit;

namespace Gjk.Samples.Tests;

/// <summary>The README of a sample, which shows what the sample prints.</summary>
internal static class Readme
{
    /// <summary>The lines of the last block of text.</summary>
    public static string[] OutputOf(string sample)
    {
        string folder = AppContext.BaseDirectory;
        while (!File.Exists(Path.Combine(folder, "Gjk.sln"))) folder = Path.GetDirectoryName(folder)!;
        string[] blocks = File.ReadAllText(Path.Combine(folder, "samples", sample, "README.md")).Split("```");
        Assert.True(blocks.Length >= 3, "There is no block.");
        return [.. blocks[^2].Split('\n')[1..].Where(l => l.Length > 0)];
    }

    /// <summary>Whether a line that was printed begins as one of the README does.</summary>
    public static void AssertShows(string sample, string[] printed, Func<string, string> withoutTimes)
    {
        string[] shown = OutputOf(sample);
        Assert.True(shown.Length > 3);
        string[] expected = [.. printed.Select(withoutTimes)];
        foreach (string line in shown)
            Assert.True(line == "..." || expected.Contains(withoutTimes(line)), $"This is not printed: {line}");
    }
}
