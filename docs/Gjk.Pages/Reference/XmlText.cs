using System;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;

namespace Gjk.Pages;

/// <summary>Turns the text of a documentation comment into Markdown.</summary>
internal static partial class XmlText
{
    public static string ToMarkdown(XElement? element) =>
        element is null ? "" : Spaces().Replace(Nodes(element), " ").Replace("\n ", "\n").Trim();

    private static string Nodes(XElement element)
    {
        var text = new StringBuilder();
        foreach (XNode node in element.Nodes())
        {
            text.Append(node switch
            {
                XText plain => Escape(Lines().Replace(plain.Value, " ")),
                XElement inner => Element(inner),
                _ => "",
            });
        }

        return text.ToString();
    }

    private static string Element(XElement element) => element.Name.LocalName switch
    {
        "see" or "seealso" => Reference(element),
        "paramref" or "typeparamref" => $"`{element.Attribute("name")!.Value}`",
        "c" => $"`{element.Value}`",
        "para" => $"\n\n{Nodes(element)}\n\n",
        "list" => "\n\n" + string.Concat(element.Elements("item").Select(i => $"- {Nodes(i).Trim()}\n")) + "\n",
        _ => Nodes(element),
    };

    /// <summary>The name of what is referred to, without its namespace and parameters.</summary>
    private static string Reference(XElement element)
    {
        string? word = element.Attribute("langword")?.Value ?? element.Attribute("href")?.Value;
        if (word is not null) return word.StartsWith("http", StringComparison.Ordinal) ? $"<{word}>" : $"`{word}`";
        string id = element.Attribute("cref")!.Value;
        string path = id[2..].Split('(')[0];
        string[] names = path.Split('.');
        string name = id[0] == 'T' ? names[^1] : string.Join('.', names[^2..]);
        return $"`{Arity().Replace(name.Replace("Gjk.Core.", "").Replace("Core.", ""), "")}`";
    }

    private static string Escape(string text) => text.Replace("<", "&lt;").Replace("*", "\\*").Replace("|", "\\|");

    [GeneratedRegex(@"\s*\n\s*")]
    private static partial Regex Lines();

    [GeneratedRegex(" {2,}")]
    private static partial Regex Spaces();

    [GeneratedRegex(@"`+\d+")]
    private static partial Regex Arity();
}
