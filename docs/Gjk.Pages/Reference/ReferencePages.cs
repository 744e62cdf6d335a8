using System.IO;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Gjk.Core;
using Gjk.Import;

namespace Gjk.Pages;

/// <summary>The reference of the public API, made from the documentation comments: a page per folder of Gjk.Core, and
/// one for Gjk.Import.</summary>
internal static partial class ReferencePages
{
    /// <summary>The group of the second package, which is one page.</summary>
    private const string ImportGroup = "Import";

    private static readonly Type[] Roots = [typeof(ConvexQuery), typeof(Importer)];

    /// <summary>The pages by their file names.</summary>
    /// <param name="sources">The folder src/Gjk.Core, whose folders group its types.</param>
    public static IReadOnlyDictionary<string, string> Make(string sources)
    {
        Dictionary<string, string> folders = Folders(sources);
        Type[] types = [.. Roots.SelectMany(r => r.Assembly.GetExportedTypes())
            .Where(t => !t.IsNested).OrderBy(t => t.Name, StringComparer.Ordinal)];
        foreach (Type type in types.Where(t => t.Assembly == typeof(Importer).Assembly))
            folders[Plain(type)] = ImportGroup;
        Dictionary<string, string> links = types.Select(Plain).Distinct()
            .ToDictionary(name => name, name => $"{PageOf(folders[name])}#{name.ToLowerInvariant()}");
        var writer = new ReferenceWriter(Comments(), links);
        var pages = new Dictionary<string, string>();
        var index = new StringBuilder("# API reference\n\nEvery public type of `Gjk.Core`, by folder, and of "
            + "`Gjk.Import`. Made from the documentation comments.\n");
        foreach (var group in types.GroupBy(t => folders[Plain(t)]).OrderBy(g => g.Key, StringComparer.Ordinal))
        {
            string title = group.Key == ImportGroup ? "Gjk.Import" : group.Key;
            index.Append($"\n## {title}\n\n| type | |\n|---|---|\n");
            foreach (Type type in group)
                index.Append($"| [{Plain(type)}]({links[Plain(type)]}) | {writer.FirstSentence(type)} |\n");
            pages[PageOf(group.Key)] = $"# {title}\n{string.Concat(group.Select(writer.Section))}";
        }

        pages["index.md"] = index.ToString();
        return pages;
    }

    /// <summary>The documentation comments of the packages, by the names that the compiler gives members. What a
    /// comment leaves out it has from the one that it names.</summary>
    public static Dictionary<string, XElement> Comments()
    {
        var comments = Roots
            .SelectMany(r => XDocument.Load(Path.ChangeExtension(r.Assembly.Location, ".xml")).Descendants("member"))
            .DistinctBy(m => m.Attribute("name")!.Value).ToDictionary(m => m.Attribute("name")!.Value);
        foreach (XElement comment in comments.Values)
        {
            string? named = comment.Element("inheritdoc")?.Attribute("cref")?.Value;
            if (named is null || !comments.TryGetValue(named, out XElement? other)) continue;
            comment.Add(other.Elements().Where(e => comment.Element(e.Name) is null).ToArray());
        }

        return comments;
    }

    /// <summary>A type's name without the number of its parameters.</summary>
    internal static string Plain(Type type) => type.Name.Split('`')[0];

    private static string PageOf(string folder) => folder.ToLowerInvariant() + ".md";

    /// <summary>The folder in which each public type is declared.</summary>
    private static Dictionary<string, string> Folders(string sources)
    {
        var folders = new Dictionary<string, string>();
        foreach (string folder in Directory.EnumerateDirectories(sources).Where(f => Path.GetFileName(f)
            is not ("bin" or "obj")))
        {
            foreach (string file in Directory.EnumerateFiles(folder, "*.cs", SearchOption.AllDirectories))
            {
                foreach (Match type in Declaration().Matches(File.ReadAllText(file)))
                    folders[type.Groups[1].Value] = Path.GetFileName(folder);
            }
        }

        return folders;
    }

    [GeneratedRegex(@"^public .*\b(?:struct|class|interface|enum) (\w+)", RegexOptions.Multiline)]
    private static partial Regex Declaration();
}
