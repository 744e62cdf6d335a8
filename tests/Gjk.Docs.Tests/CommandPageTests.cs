using System.Text.RegularExpressions;

namespace Gjk.Docs.Tests;

/// <summary>A reader who meets the command can find how to run it.</summary>
public partial class CommandPageTests
{
    [Theory, MemberData(nameof(Page.All), MemberType = typeof(Page))]
    public void PagesWithTheCommandSayHowToGetIt(string page)
    {
        string text = Page.Read(page);
        bool shows = Command().IsMatch(text);
        bool says = text.Contains("command.md)", StringComparison.Ordinal)
            || page == "docs/command.md" || page == "CONTRIBUTING.md";
        Assert.True(says || !shows, $"{page} has gjk-demo and no link to docs/command.md");
    }

    [GeneratedRegex(@"gjk-demo [a-z]+ ?", RegexOptions.CultureInvariant)]
    private static partial Regex Command();
}
