using YamlDotNet.Core;
using YamlDotNet.Core.Events;

namespace Gjk.Import;

/// <summary>A value in Unity's YAML: a text, a list, or fields. Where a file repeats a field, as old .meta files do,
/// the last one counts. YamlDotNet's own document refuses such files, so this is built of its parser's
/// events.</summary>
internal sealed class UnityNode
{
    private readonly List<UnityNode>? _items;
    private readonly Dictionary<string, UnityNode>? _fields;
    private readonly string? _text;

    private UnityNode(string? text, List<UnityNode>? items, Dictionary<string, UnityNode>? fields)
    {
        _text = text;
        _items = items;
        _fields = fields;
    }

    public static UnityNode OfText(string text) => new(text, null, null);

    /// <summary>The elements of a list. Unity writes an empty one as [] or leaves it out.</summary>
    public IReadOnlyList<UnityNode> Items => _items ?? [];

    /// <summary>The text, or nothing if it is a list or has fields.</summary>
    public string Text => _text ?? "";

    public IReadOnlyDictionary<string, UnityNode> Fields => _fields ?? [];

    /// <summary>A field, or null.</summary>
    public UnityNode? this[string field] => _fields?.GetValueOrDefault(field);

    /// <summary>Reads one document.</summary>
    /// <exception cref="YamlException">It is not YAML.</exception>
    /// <exception cref="UnreadableException">It is YAML that Unity does not write.</exception>
    public static UnityNode Parse(TextReader text)
    {
        try
        {
            return Document(text);
        }
        catch (InvalidOperationException)
        {
            // The scanner of YamlDotNet 16 throws this at a bracket after some broken plain texts.
            throw new UnreadableException("not valid YAML");
        }
    }

    /// <summary>A copy that can be changed on its own.</summary>
    public UnityNode Copy()
    {
        if (_fields is null) return _items is null ? this : new UnityNode(null, _items.ConvertAll(i => i.Copy()), null);
        var fields = new Dictionary<string, UnityNode>(_fields.Count, StringComparer.Ordinal);
        foreach ((string name, UnityNode value) in _fields) fields.Add(name, value.Copy());
        return new UnityNode(null, null, fields);
    }

    /// <summary>Sets the field that a path such as m_LocalPosition.x leads to. Returns false if there is
    /// none.</summary>
    public bool Set(string path, UnityNode value)
    {
        UnityNode node = this;
        string[] steps = path.Split('.');
        foreach (string step in steps.AsSpan(0, steps.Length - 1))
        {
            if (node[step] is not { } next) return false;
            node = next;
        }

        if (node._fields is null) return false;
        node._fields[steps[^1]] = value;
        return true;
    }

    /// <exception cref="UnreadableException">It is missing, or not a finite number.</exception>
    public double Number(string field)
    {
        if (this[field] is not { } value) throw new UnreadableException($"{field} is missing");
        bool isNumber = float.TryParse(value.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out float number);
        return isNumber && float.IsFinite(number)
            ? number
            : throw new UnreadableException($"{field}: \"{value.Text}\" is not a finite number");
    }

    public long Whole(string field, long otherwise)
    {
        if (this[field] is not { } value) return otherwise;
        return long.TryParse(value.Text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long number)
            ? number
            : throw new UnreadableException($"{field}: \"{value.Text}\" is not a whole number");
    }

    public Double3 Vector(string field)
    {
        UnityNode value = this[field] ?? throw new UnreadableException($"{field} is missing");
        try
        {
            return new Double3(value.Number("x"), value.Number("y"), value.Number("z"));
        }
        catch (UnreadableException e)
        {
            throw new UnreadableException($"{field}.{e.Message}");
        }
    }

    /// <summary>A reference to an object of this or, with a GUID, another file. None is 0.</summary>
    public UnityReference Reference(string field) =>
        this[field] is { } value ? new UnityReference(value.Whole("fileID", 0), value["guid"]?.Text ?? "") : default;

    private static UnityNode Document(TextReader text)
    {
        var parser = new Parser(text);
        parser.Consume<StreamStart>();
        if (parser.Accept<StreamEnd>(out _)) return OfText("");
        parser.Consume<DocumentStart>();
        UnityNode root = Value(parser);
        parser.Consume<DocumentEnd>();
        if (!parser.Accept<StreamEnd>(out _)) throw new UnreadableException("a second document begins in it");
        return root;
    }

    /// <summary>Reads a value without recursion, because the text decides how deep it goes. An unfinished value is kept
    /// on a stack, with the name of the field that is read next.</summary>
    private static UnityNode Value(Parser parser)
    {
        var open = new Stack<(UnityNode Node, string? Field)>();
        while (true)
        {
            if (open.Count > ImportLimits.YamlDepth) throw new UnreadableException("its fields nest too deeply");
            UnityNode done;
            if (parser.TryConsume<Scalar>(out Scalar? scalar))
            {
                if (open.TryPeek(out (UnityNode Node, string? Field) top) && top.Node._fields is not null
                    && top.Field is null)
                {
                    open.Pop();
                    open.Push((top.Node, scalar.Value));
                    continue;
                }

                done = OfText(scalar.Value);
            }
            else if (parser.TryConsume<SequenceStart>(out _))
            {
                open.Push((new UnityNode(null, [], null), null));
                continue;
            }
            else if (parser.TryConsume<MappingStart>(out _))
            {
                open.Push((new UnityNode(null, null, new(StringComparer.Ordinal)), null));
                continue;
            }
            else if (parser.TryConsume<SequenceEnd>(out _) || parser.TryConsume<MappingEnd>(out _))
            {
                done = open.Pop().Node;
            }
            else
            {
                throw new UnreadableException("it has an alias, which Unity does not write");
            }

            if (open.Count == 0) return done;
            (UnityNode parent, string? field) = open.Pop();
            if (parent._items is not null) parent._items.Add(done);
            else if (field is null) throw new UnreadableException("the name of a field is not a text");
            else parent._fields![field] = done;
            open.Push((parent, null));
        }
    }
}

/// <summary>What a reference names.</summary>
/// <param name="FileId">The object's number, or 0 for none.</param>
/// <param name="Guid">Of its file. Empty if it is the same file.</param>
internal readonly record struct UnityReference(long FileId, string? Guid)
{
    public bool IsNone => FileId == 0;

    public bool IsLocal => string.IsNullOrEmpty(Guid);
}
