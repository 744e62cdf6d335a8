using System.Text.RegularExpressions;

namespace Gjk.Core.Tests.Api;

/// <summary>What the format check cannot hold: lines of at most 120 columns (.editorconfig only tells editors), files
/// of at most 300 lines, functions of at most 60.</summary>
public class StyleTests
{
    private const int LineColumns = 120, FileLines = 300, FunctionLines = 60;

    [Fact]
    public void LinesFilesAndFunctionsAreShort()
    {
        var faults = new List<string>();
        int files = 0;
        foreach (string file in ProjectFolder.Sources("src", "samples", "tests", "bench", "unity", "docs"))
        {
            files++;
            string[] lines = File.ReadAllLines(file);
            string name = Path.GetRelativePath(ProjectFolder.Root, file);
            if (lines.Length > FileLines) faults.Add($"{name} has {lines.Length} lines");
            for (int i = 0; i < lines.Length; i++)
            {
                if (lines[i].Length > LineColumns) faults.Add($"{name}:{i + 1} has {lines[i].Length} columns");
            }

            faults.AddRange(LongFunctions(lines).Select(f => $"{name}:{f.Line} is a function of {f.Length} lines"));
        }

        Assert.True(files > 300, $"only {files} sources were found");
        Assert.Empty(faults);
    }

    /// <summary>Tables and links cannot be broken.</summary>
    [Theory]
    [InlineData("README.md")]
    [InlineData("CHANGELOG.md")]
    [InlineData("src/Gjk.Core/Package/README.md")]
    [InlineData("src/Gjk.Import/Package/README.md")]
    [InlineData("samples/EnterExit/README.md")]
    [InlineData("samples/NearestObstacle/README.md")]
    [InlineData("samples/PartClearance/README.md")]
    public void TextIsWrapped(string file)
    {
        string[] lines = File.ReadAllLines(Path.Combine(ProjectFolder.Root, file));
        Assert.DoesNotContain(lines, l => l.Length > LineColumns && !l.StartsWith('|') && !l.Contains("]("));
    }

    /// <summary>A function's body begins with a brace of its own in the column of a type's members, behind a line that
    /// ends its signature, and ends with the brace of the same column.</summary>
    private static IEnumerable<(int Line, int Length)> LongFunctions(string[] lines)
    {
        for (int i = 1; i < lines.Length; i++)
        {
            if (lines[i] != "    {" || !IsSignature(lines[i - 1])) continue;
            int end = Array.IndexOf(lines, "    }", i);
            if (end - i - 1 > FunctionLines) yield return (i, end - i - 1);
        }
    }

    private static bool IsSignature(string line) =>
        Regex.IsMatch(line, @"\)$|^\s+where ") && !Regex.IsMatch(line, @"\b(class|struct|record)\b| = ");
}
