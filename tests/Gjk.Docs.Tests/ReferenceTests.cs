using System.Xml.Linq;
using Gjk.Core;
using Gjk.Pages;

namespace Gjk.Docs.Tests;

/// <summary>The reference of the API is what the documentation comments say now.</summary>
public class ReferenceTests
{
    [Fact]
    public void TheReferenceIsMadeFromTheComments()
    {
        IReadOnlyDictionary<string, string> pages = ReferencePages.Make(Page.PathOf("src/Gjk.Core"));
        string folder = Page.PathOf("docs/api");
        if (PageTests.UpdateOutputs)
        {
            foreach ((string name, string text) in pages) File.WriteAllText(Path.Combine(folder, name), text);
        }

        string[] written = [.. Directory.EnumerateFiles(folder).Select(f => Path.GetFileName(f)!)];
        Assert.Equal(pages.Keys.Order(StringComparer.Ordinal), written.Order(StringComparer.Ordinal));
        Assert.All(pages, page => Assert.Equal(page.Value, Page.Read($"docs/api/{page.Key}")));
    }

    /// <summary>A comment of one file of a partial type reaches every reader of the type, so only one file has
    /// one.</summary>
    [Fact]
    public void ATypeIsDescribedInOnePlace()
    {
        Dictionary<string, XElement> comments = ReferencePages.Comments();
        Assert.All(typeof(ConvexQuery).Assembly.GetExportedTypes(), type =>
        {
            foreach (string part in new[] { "summary", "remarks" })
            {
                int count = comments[$"T:{type.FullName}"].Elements(part).Count();
                Assert.True(count <= 1, $"{type} has more than one {part}");
            }
        });
    }

    [Fact]
    public void MembersAreHeadingsAndTypesAreLinks()
    {
        string queries = ReferencePages.Make(Page.PathOf("src/Gjk.Core"))["queries.md"];
        Assert.Single(queries.Split('\n'), "### SignedDistance");
        Assert.Contains("- `poseA` ([`RigidPose`](geometry.md#rigidpose)): ", queries);
        Assert.Contains("Returns ([`CastResult`](queries.md#castresult)): ", queries);
        Assert.DoesNotContain("Two balls", queries);
    }

    /// <summary>The second package is one page, without what the compiler makes of a record. A member whose comment
    /// names another one for the rest has that one's parameters.</summary>
    [Fact]
    public void TheReferenceHasTheSecondPackage()
    {
        string import = ReferencePages.Make(Page.PathOf("src/Gjk.Core"))["import.md"];
        Assert.Contains("### ReadObj", import);
        Assert.Contains("### ToAnyShape", import);
        string stl = import.Split("### ").Single(s => s.StartsWith("ReadStl", StringComparison.Ordinal));
        Assert.Contains("- `content`: The bytes of the file.", stl);
        Assert.Contains("- throws `ImportException`", stl);
        Assert.DoesNotContain("OBJ", stl);
        Assert.DoesNotContain("<Clone>", import);
    }

    /// <summary>A member without a comment would be an empty entry.</summary>
    [Fact]
    public void EveryTypeOfTheReferenceIsDescribed()
    {
        string index = ReferencePages.Make(Page.PathOf("src/Gjk.Core"))["index.md"];
        string[] rows = [.. index.Split('\n').Where(l => l.StartsWith("| [", StringComparison.Ordinal))];
        Assert.True(rows.Length > 60, $"{rows.Length} types");
        Assert.All(rows, row => Assert.DoesNotMatch(@"\|\s*\|$", row));
    }
}
