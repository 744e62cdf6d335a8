using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Gjk.Core;

namespace Gjk.Pages;

/// <summary>
/// The reference of the public API, made from the documentation comments: a page per folder of the library.
/// </summary>
internal static partial class ReferencePages
{
    private const BindingFlags Declared =
        BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    /// <summary>The pages by their file names.</summary>
    /// <param name="sources">The folder src/Gjk.Core, whose folders group the types.</param>
    public static IReadOnlyDictionary<string, string> Make(string sources)
    {
        Assembly library = typeof(ConvexQuery).Assembly;
        Dictionary<string, XElement> comments = XDocument.Load(Path.ChangeExtension(library.Location, ".xml"))
            .Descendants("member").ToDictionary(m => m.Attribute("name")!.Value);
        Dictionary<string, string> folders = Folders(sources);
        var groups = library.GetExportedTypes().Where(t => !t.IsNested).OrderBy(t => t.Name, StringComparer.Ordinal)
            .GroupBy(t => folders[t.Name.Split('`')[0]]).OrderBy(g => g.Key, StringComparer.Ordinal).ToList();

        var pages = new Dictionary<string, string>();
        var index = new StringBuilder("# API reference\n\nEvery public type of `Gjk.Core`, by folder. "
            + "Made from the documentation comments.\n");
        foreach (var group in groups)
        {
            string name = group.Key.ToLowerInvariant();
            index.Append($"\n## {group.Key}\n\n| type | |\n|---|---|\n");
            var page = new StringBuilder($"# {group.Key}\n");
            foreach (Type type in group)
            {
                string plain = type.Name.Split('`')[0];
                string link = $"{name}.md#{plain.ToLowerInvariant()}";
                index.Append($"| [{plain}]({link}) | {FirstSentence(comments, type)} |\n");
                Write(page, plain, type, comments);
            }

            pages[$"{name}.md"] = page.ToString();
        }

        pages["index.md"] = index.ToString();
        return pages;
    }

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

    private static string FirstSentence(Dictionary<string, XElement> comments, Type type)
    {
        string all = XmlText.ToMarkdown(comments.GetValueOrDefault(MemberId.Of(type))?.Element("summary"));
        int end = all.IndexOf(". ", StringComparison.Ordinal);
        return (end < 0 ? all : all[..(end + 1)]).ReplaceLineEndings(" ");
    }

    private static void Write(StringBuilder page, string title, Type type, Dictionary<string, XElement> comments)
    {
        page.Append($"\n## {title}\n\n`{Signature.Of(type)}`\n");
        Describe(page, comments.GetValueOrDefault(MemberId.Of(type)), indent: "");
        List<MemberInfo> members = type.GetMembers(Declared)
            .Where(m => m is not Type && Signature.IsWorthListing(m) && m.Name != "value__")
            .OrderBy(m => m is ConstructorInfo ? 0 : 1).ThenBy(m => m.MetadataToken).ToList();
        if (members.Count > 0) page.Append('\n');
        foreach (MemberInfo member in members)
        {
            page.Append($"- `{Signature.Of(member)}`\n");
            Describe(page, comments.GetValueOrDefault(MemberId.Of(member)), indent: "  ");
        }
    }

    private static void Describe(StringBuilder page, XElement? comment, string indent)
    {
        if (comment is null) return;
        foreach (string part in new[] { "summary", "value", "returns", "remarks" })
        {
            string text = XmlText.ToMarkdown(comment.Element(part));
            if (text.Length > 0) Paragraph(page, part == "returns" ? "Returns: " + text : text, indent);
        }

        var list = new StringBuilder();
        foreach (XElement parameter in comment.Elements("param"))
            list.Append($"- `{parameter.Attribute("name")!.Value}`: {XmlText.ToMarkdown(parameter)}\n");
        foreach (XElement exception in comment.Elements("exception"))
        {
            string type = exception.Attribute("cref")!.Value.Split('.')[^1];
            list.Append($"- throws `{type}`: {XmlText.ToMarkdown(exception)}\n");
        }

        if (list.Length > 0) Paragraph(page, list.ToString().TrimEnd(), indent);
    }

    private static void Paragraph(StringBuilder page, string text, string indent)
    {
        page.Append('\n');
        foreach (string line in text.Split('\n')) page.Append(line.Length == 0 ? "\n" : $"{indent}{line}\n");
    }
}
