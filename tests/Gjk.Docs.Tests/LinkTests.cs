using System.Text.RegularExpressions;

namespace Gjk.Docs.Tests;

/// <summary>Links and pictures between the files of the project lead somewhere, headings included.</summary>
public partial class LinkTests
{
    public static TheoryData<string> All => Page.All;

    [Theory, MemberData(nameof(All))]
    public void LinksLeadSomewhere(string page)
    {
        string folder = Path.GetDirectoryName(Page.PathOf(page))!;
        var dead = new List<string>();
        foreach (Match link in Link().Matches(WithoutCode(Page.Read(page))))
        {
            string target = link.Groups["target"].Value;
            if (target.Contains("://", StringComparison.Ordinal)) continue;
            string[] parts = target.Split('#', 2);
            string file = parts[0].Length == 0 ? Page.PathOf(page) : Path.Combine(folder, parts[0]);
            bool exists = File.Exists(file) || Directory.Exists(file);
            bool hasAnchor = parts.Length < 2 || !File.Exists(file) || Anchors(file).Contains(parts[1]);
            if (!exists || !hasAnchor) dead.Add(target);
        }

        Assert.Empty(dead);
    }

    private static HashSet<string> Anchors(string file) => [.. File.ReadLines(file)
        .Where(l => l.StartsWith('#')).Select(l => Slug(l.TrimStart('#').Trim()))];

    private static string Slug(string heading) =>
        NotInSlug().Replace(heading.ToLowerInvariant(), "").Replace(' ', '-');

    private static string WithoutCode(string markdown)
    {
        bool isCode = false;
        return string.Join('\n', markdown.Split('\n').Where(l =>
        {
            bool isFence = l.StartsWith("```", StringComparison.Ordinal);
            if (isFence) isCode = !isCode;
            return !isFence && !isCode;
        }));
    }

    [GeneratedRegex(@"\]\((?<target>[^)\s]+)\)")]
    private static partial Regex Link();

    [GeneratedRegex(@"[^\w\- ]")]
    private static partial Regex NotInSlug();
}
