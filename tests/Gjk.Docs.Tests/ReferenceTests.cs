using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
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
