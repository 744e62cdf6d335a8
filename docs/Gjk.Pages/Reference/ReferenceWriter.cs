using System.Reflection;
using System.Text;
using System.Xml.Linq;

namespace Gjk.Pages;

/// <summary>Writes what the reference says of a type: a heading for it, and one for each name of a member.</summary>
internal sealed class ReferenceWriter
{
    private const BindingFlags Declared =
        BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    private readonly Dictionary<string, XElement> _comments;
    private readonly Dictionary<string, string> _links;
    private readonly XmlText _text;

    /// <param name="comments">By the names of what they describe.</param>
    /// <param name="links">Where each type is described, by its name.</param>
    public ReferenceWriter(Dictionary<string, XElement> comments, Dictionary<string, string> links)
    {
        _comments = comments;
        _links = links;
        _text = new XmlText(name => _links.GetValueOrDefault(name));
    }

    public string FirstSentence(Type type)
    {
        string all = _text.ToMarkdown(Comment(MemberId.Of(type))?.Element("summary"));
        int end = all.IndexOf(". ", StringComparison.Ordinal);
        return (end < 0 ? all : all[..(end + 1)]).ReplaceLineEndings(" ");
    }

    public string Section(Type type)
    {
        var page = new StringBuilder($"\n## {ReferencePages.Plain(type)}\n\n`{Signature.Of(type)}`");
        page.Append(type.Namespace == "Gjk.Core" ? "\n" : $", namespace `{type.Namespace}`\n");
        Describe(page, Comment(MemberId.Of(type)), [], indent: "");
        IEnumerable<MemberInfo> members = type.GetMembers(Declared)
            .Where(m => m is not Type && Signature.IsWorthListing(m) && m.Name != "value__")
            .OrderBy(m => m is ConstructorInfo ? 0 : 1).ThenBy(m => m.MetadataToken);
        if (type.IsEnum)
        {
            page.Append('\n');
            foreach (MemberInfo member in members) Entry(page, member);
            return page.ToString();
        }

        // Overloads stand together, where the first of them is.
        foreach (var overloads in members.GroupBy(Name))
        {
            page.Append($"\n### {overloads.Key}\n\n");
            foreach (MemberInfo member in overloads) Entry(page, member);
        }

        return page.ToString();
    }

    private static string Name(MemberInfo member) => member switch
    {
        ConstructorInfo => $"new {ReferencePages.Plain(member.DeclaringType!)}",
        PropertyInfo property when property.GetIndexParameters().Length > 0 => "this",
        _ when Signature.IsOperator(member) => "operators",
        _ => member.Name,
    };

    private void Entry(StringBuilder page, MemberInfo member)
    {
        Type? value = (member as PropertyInfo)?.PropertyType ?? (member as FieldInfo)?.FieldType;
        string link = value is null || member.DeclaringType!.IsEnum ? "" : TypeLink(value);
        page.Append($"- `{Signature.Of(member)}`{link}\n");
        Describe(page, Comment(MemberId.Of(member)), (member as MethodBase)?.GetParameters() ?? [], indent: "  ",
            (member as MethodInfo)?.ReturnType);
    }

    private void Describe(
        StringBuilder page, XElement? comment, ParameterInfo[] parameters, string indent, Type? result = null)
    {
        if (comment is null) return;
        foreach (string part in new[] { "summary", "value", "returns", "remarks" })
        {
            string text = _text.ToMarkdown(comment.Element(part));
            string returns = part == "returns" ? $"Returns{(result is null ? "" : TypeLink(result))}: " : "";
            if (text.Length > 0) Paragraph(page, returns + text, indent);
        }

        var list = new StringBuilder();
        foreach (XElement parameter in comment.Elements("param"))
        {
            string name = parameter.Attribute("name")!.Value;
            Type? type = parameters.FirstOrDefault(p => p.Name == name)?.ParameterType;
            list.Append($"- `{name}`{(type is null ? "" : TypeLink(type))}: {_text.ToMarkdown(parameter)}\n");
        }

        foreach (XElement exception in comment.Elements("exception"))
        {
            string type = exception.Attribute("cref")!.Value.Split('.')[^1];
            list.Append($"- throws `{type}`: {_text.ToMarkdown(exception)}\n");
        }

        if (list.Length > 0) Paragraph(page, list.ToString().TrimEnd(), indent);
    }

    /// <summary>A type of the library in brackets, with a link; nothing for any other type.</summary>
    private string TypeLink(Type type)
    {
        while (type.HasElementType) type = type.GetElementType()!;
        bool isOther = !_links.ContainsKey(ReferencePages.Plain(type));
        if (isOther && type.IsGenericType && type.GetGenericArguments() is [var only]) type = only;
        string name = ReferencePages.Plain(type);
        return _links.ContainsKey(name) && !type.IsGenericParameter ? $" ({_text.Linked(name, name)})" : "";
    }

    private XElement? Comment(string id) => _comments.GetValueOrDefault(id);

    private static void Paragraph(StringBuilder page, string text, string indent)
    {
        page.Append('\n');
        foreach (string line in text.Split('\n')) page.Append(line.Length == 0 ? "\n" : $"{indent}{line}\n");
    }
}
