using System.Globalization;
using System.IO;
using System.Text;

namespace Gjk.Exact.Cases;

/// <summary>Reads JSON into dictionaries, lists, strings and the text of numbers. netstandard2.0 has no reader that
/// works without a further assembly. This reader is only for the project's own case files, which are well formed and
/// contain no escapes.</summary>
internal sealed class Json
{
    private readonly string _text;
    private int _next;

    private Json(string text) => _text = text;

    public static Dictionary<string, object> ReadObject(string text) =>
        (Dictionary<string, object>)new Json(text).Value();

    public static float Float(object number) =>
        float.Parse((string)number, NumberStyles.Float, CultureInfo.InvariantCulture);

    public static double Number(string text) => double.Parse(text, NumberStyles.Float, CultureInfo.InvariantCulture);

    public static Vector3 Vector(object list)
    {
        var v = (List<object>)list;
        return new Vector3(Float(v[0]), Float(v[1]), Float(v[2]));
    }

    private object Value() => Peek() switch
    {
        '{' => Object(),
        '[' => List(),
        '"' => String(),
        _ => Word(),
    };

    private Dictionary<string, object> Object()
    {
        var members = new Dictionary<string, object>();
        Expect('{');
        while (Peek() != '}')
        {
            string name = String();
            Expect(':');
            members.Add(name, Value());
            if (Peek() == ',') _next++;
        }

        _next++;
        return members;
    }

    private List<object> List()
    {
        var items = new List<object>();
        Expect('[');
        while (Peek() != ']')
        {
            items.Add(Value());
            if (Peek() == ',') _next++;
        }

        _next++;
        return items;
    }

    private string String()
    {
        Expect('"');
        int start = _next;
        _next = _text.IndexOf('"', start) + 1;
        return _text.Substring(start, _next - 1 - start);
    }

    private string Word()
    {
        var word = new StringBuilder();
        while (_next < _text.Length && ",]} \r\n\t".IndexOf(_text[_next]) < 0) word.Append(_text[_next++]);
        return word.Length > 0 ? word.ToString() : throw new InvalidDataException($"Unexpected character at {_next}.");
    }

    private char Peek()
    {
        while (char.IsWhiteSpace(_text[_next])) _next++;
        return _text[_next];
    }

    private void Expect(char c)
    {
        if (Peek() != c) throw new InvalidDataException($"'{c}' should be at {_next}.");
        _next++;
    }
}
