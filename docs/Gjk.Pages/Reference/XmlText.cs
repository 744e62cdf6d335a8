using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;

namespace Gjk.Pages;

/// <summary>Turns the text of a documentation comment into Markdown.</summary>
/// <param name="linkOf">Where a type of the library is described, by its name; null for all others.</param>
internal sealed partial class XmlText(Func<string, string?> linkOf)
{
    public string ToMarkdown(XElement? element) =>
        element is null ? "" : Spaces().Replace(Nodes(element), " ").Replace("\n ", "\n").Trim();

    private string Nodes(XElement element)
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

    private string Element(XElement element) => element.Name.LocalName switch
    {
        "see" or "seealso" => Reference(element),
        "paramref" or "typeparamref" => $"`{element.Attribute("name")!.Value}`",
        "c" => $"`{element.Value}`",
        "para" => $"\n\n{Nodes(element)}\n\n",
        "list" => "\n\n" + string.Concat(element.Elements("item").Select(i => $"- {Nodes(i).Trim()}\n")) + "\n",
        _ => Nodes(element),
    };

    /// <summary>The name of what is referred to, without namespace and parameters, with a link to its type.</summary>
    private string Reference(XElement element)
    {
        string? word = element.Attribute("langword")?.Value ?? element.Attribute("href")?.Value;
        if (word is not null) return word.StartsWith("http", StringComparison.Ordinal) ? $"<{word}>" : $"`{word}`";
        string id = element.Attribute("cref")!.Value;
        string path = id[2..].Split('(')[0];
        string[] names = path.Split('.');
        string name = id[0] == 'T' ? names[^1] : string.Join('.', names[^2..]);
        string type = Arity().Replace(id[0] == 'T' ? names[^1] : names[^2], "");
        return Linked(Arity().Replace(name.Replace("Gjk.Core.", "").Replace("Core.", ""), ""), type);
    }

    /// <summary>Code that leads to where a type is described, if that is in the reference.</summary>
    public string Linked(string code, string type) => linkOf(type) is { } link ? $"[`{code}`]({link})" : $"`{code}`";

    private static string Escape(string text) => text.Replace("<", "&lt;").Replace("*", "\\*").Replace("|", "\\|");

    [GeneratedRegex(@"\s*\n\s*")]
    private static partial Regex Lines();

    [GeneratedRegex(" {2,}")]
    private static partial Regex Spaces();

    [GeneratedRegex(@"`+\d+")]
    private static partial Regex Arity();
}
