using System.Reflection;
using System.Text.RegularExpressions;

namespace Gjk.Core.Tests.Api;

/// <summary>Comments of the library and of the oracle say "Pinned by" and name the tests that hold a constant where it
/// is: as SomeTests, as SomeTests.SomeMethod, or as SomeMethod in SomeTests and OtherTests. The tests must
/// exist.</summary>
public partial class PinnedCommentTests
{
    private const BindingFlags OwnMethods =
        BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    [Fact]
    public void EveryTestThatACommentNamesExists()
    {
        Dictionary<string, Type> classes = TestClasses();
        var faults = new List<string>();
        int found = 0;
        foreach (string file in ProjectFolder.Sources("src/Gjk.Core", "tests/Gjk.Exact"))
        {
            foreach (Match pin in Pin().Matches(Comments(File.ReadAllText(file))))
            {
                found++;
                string said = pin.Groups["names"].Value;
                if (Fault(said, classes) is { } fault)
                    faults.Add($"{Path.GetRelativePath(ProjectFolder.Root, file)}: '{said}': {fault}");
            }
        }

        Assert.True(found > 30, $"only {found} comments name a test");
        Assert.True(faults.Count == 0, string.Join("\n", faults));
    }

    [Theory]
    [InlineData("PinnedCommentTests", true)]
    [InlineData("PinnedCommentTests, which reads this", true)]
    [InlineData("PinnedCommentTests and fuzz", true)]
    [InlineData("PinnedCommentTests.EveryTestThatACommentNamesExists", true)]
    [InlineData("EveryTestThatACommentNamesExists in PinnedCommentTests", true)]
    [InlineData("PinnedComment2Tests", false)]
    [InlineData("PinnedCommentTests.NoSuchTest", false)]
    [InlineData("EveryTestThatACommentNamesExists in PinnedCommentTests and BuildTests", false)]
    [InlineData("NoSuchTest", false)]
    [InlineData("the case families", false)]
    public void AWrongNameIsFound(string said, bool isRight) =>
        Assert.Equal(isRight, Fault(said, TestClasses()) is null);

    /// <summary>What is wrong with the names, or null.</summary>
    private static string? Fault(string said, Dictionary<string, Type> classes)
    {
        string[] names = [.. Name().Matches(said).Select(m => m.Value)];
        Type[] named = [.. names.Where(classes.ContainsKey).Select(n => classes[n])];
        if (names.Length == 0) return "it names no test";
        foreach (string name in names.Where(n => !classes.ContainsKey(n)))
        {
            int dot = name.IndexOf('.', StringComparison.Ordinal);
            Type[] owners = dot < 0 ? named : classes.TryGetValue(name[..dot], out Type? owner) ? [owner] : [];
            string method = name[(dot + 1)..];
            if (owners.Length == 0) return $"there is no test class for {name}";
            if (Array.Find(owners, o => !IsTest(o, method)) is { } lacking)
                return $"{lacking.Name} has no test {method}";
        }

        return null;
    }

    private static bool IsTest(Type type, string method) =>
        type.GetMethods(OwnMethods).Any(m => m.Name == method && m.IsDefined(typeof(FactAttribute)));

    private static Dictionary<string, Type> TestClasses() =>
        typeof(PinnedCommentTests).Assembly.GetTypes()
            .Where(t => t.IsPublic && t.GetMethods(OwnMethods).Any(m => m.IsDefined(typeof(FactAttribute))))
            .ToDictionary(t => t.Name);

    /// <summary>The text of all comments, without the marks of lines and the tags.</summary>
    private static string Comments(string source)
    {
        string text = string.Join(" ", CommentLine().Matches(source).Select(m => m.Groups["text"].Value.Trim()));
        return Tag().Replace(text, " ");
    }

    [GeneratedRegex(@"//+(?<text>[^\n]*)")]
    private static partial Regex CommentLine();

    [GeneratedRegex("<[^>]*>")]
    private static partial Regex Tag();

    /// <summary>To the end of the sentence: a full stop before a space, since names have stops within.</summary>
    [GeneratedRegex(@"[Pp]inned by (?<names>.+?)(?:\.(?=\s|$)|$)")]
    private static partial Regex Pin();

    [GeneratedRegex(@"\b[A-Z]\w+(?:\.[A-Z]\w+)?")]
    private static partial Regex Name();
}
