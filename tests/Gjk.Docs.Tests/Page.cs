using Gjk.Core.Tests.Support;

namespace Gjk.Docs.Tests;

/// <summary>The Markdown pages of the project that a reader finds from the README.</summary>
public static class Page
{
    private static readonly string[] Generated = ["node_modules", "bin", "obj", ".vitepress", "site"];

    /// <summary>Paths below the project's folder, for a theory.</summary>
    public static TheoryData<string> All => [.. Names()];

    public static TheoryData<string> WithBlocks(string language) =>
        [.. Names().Where(n => CodeBlock.Of(Read(n)).Any(b => b.Language == language))];

    public static string Read(string name) => File.ReadAllText(PathOf(name)).Replace("\r\n", "\n");

    public static string PathOf(string name) => Path.Combine(ProjectFolder.Root, name);

    public static IEnumerable<string> Names()
    {
        string root = ProjectFolder.Root;
        IEnumerable<string> below = new[] { "docs", "samples" }.Select(f => Path.Combine(root, f))
            .SelectMany(f => Directory.EnumerateFiles(f, "*.md", SearchOption.AllDirectories))
            .Select(f => Path.GetRelativePath(root, f).Replace('\\', '/'))
            .Where(f => !f.Split('/').Intersect(Generated).Any());
        return below.Order(StringComparer.Ordinal).Prepend("CONTRIBUTING.md").Prepend("README.md");
    }
}
