using System.Text.RegularExpressions;

namespace Gjk.Core.Tests.Support;

/// <summary>Counts the lines of a source that are code: not blank, no comment, no directive, no <c>using</c> or
/// <c>namespace</c>, and not brackets alone.</summary>
internal static class CodeLines
{
    public static int In(string source) =>
        source.Split('\n').Select(line => line.Trim()).Count(line => line.Length > 0 && !IsNoCode(line));

    private static bool IsNoCode(string line) =>
        line.StartsWith("//", StringComparison.Ordinal)
        || Regex.IsMatch(line, @"^([{}\[\]();,]+$|using [\w.=<> ]+;|namespace |#)");
}
