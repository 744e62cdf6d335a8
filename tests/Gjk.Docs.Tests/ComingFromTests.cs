using System.Text.RegularExpressions;

namespace Gjk.Docs.Tests;

/// <summary>The names that the tables for newcomers give exist.</summary>
public class ComingFromTests
{
    [Fact]
    public void EveryMemberOfTheTablesExists()
    {
        string api = string.Concat(new[] { "Shipped", "Unshipped" }.Select(
            f => File.ReadAllText(Page.PathOf($"src/Gjk.Core/PublicAPI.{f}.txt"))));
        string unity = File.ReadAllText(Page.PathOf("unity/com.gjk.core/Runtime/GjkPhysics.cs"));
        MatchCollection names = Regex.Matches(
            Page.Read("docs/tasks/coming-from.md"),
            @"`((?:ConvexQuery|ConcaveQuery|CollisionScene|AnyShape|ConvexShape|GjkPhysics)\.)(\w+)`");
        Assert.True(names.Count > 25, $"{names.Count} names");
        Assert.All(names, n => Assert.True(
            n.Groups[1].Value == "GjkPhysics."
                ? unity.Contains($" {n.Groups[2].Value}(")
                : Regex.IsMatch(api, $@"Gjk\.Core\.{Regex.Escape(n.Groups[1].Value)}{n.Groups[2].Value}[(<]"),
            n.Value));
    }
}
