using System.Text.Json;

namespace Gjk.Demo.Scenes;

/// <summary>Reads JSON from front to back, without a document in memory. It knows its place in the file. Everything
/// unexpected is refused with file, path and reason.</summary>
internal ref struct StrictJsonReader
{
    private readonly string _file;
    private Utf8JsonReader _reader;

    public StrictJsonReader(string file, ReadOnlySpan<byte> utf8)
    {
        _file = file;
        _reader = new Utf8JsonReader(utf8);
        Path = new JsonPath();
    }

    public JsonPath Path { get; }

    public readonly RefusedException Refuse(string reason) => new($"{_file}: {Path}: {reason}");

    /// <summary>Moves to the first value.</summary>
    public void Start() => Next();

    /// <summary>Refuses anything after the last value.</summary>
    public void End()
    {
        try
        {
            _reader.Read();
        }
        catch (JsonException e)
        {
            throw Syntax(e);
        }
    }

    /// <summary>Enters the object under the cursor.</summary>
    public readonly void BeginObject(string what) => Expect(JsonTokenType.StartObject, what);

    /// <summary>Moves to the next field's value. Returns false at the end of the object. The path includes the field
    /// until <see cref="EndField"/>.</summary>
    /// <param name="seen">The fields of the object so far. A repeated field is refused.</param>
    /// <param name="field">The field's name.</param>
    public bool NextField(HashSet<string> seen, out string field)
    {
        Next();
        if (_reader.TokenType == JsonTokenType.EndObject)
        {
            field = "";
            return false;
        }

        field = Text();
        Path.Enter(field);
        if (!seen.Add(field)) throw Refuse("the field appears twice");
        return true;
    }

    /// <summary>Moves from the field's name to its value. This is a separate step, so that an unknown field is refused
    /// as unknown, whatever its value is.</summary>
    public void Value() => Next();

    public readonly void EndField() => Path.Leave();

    /// <summary>Enters the array under the cursor. <see cref="NextElement"/> then moves to its elements.</summary>
    public readonly void BeginArray(string what)
    {
        Expect(JsonTokenType.StartArray, what);
        Path.Enter(-1);
    }

    /// <summary>Moves to the element with the given index. Returns false at the end of the array.</summary>
    public bool NextElement(int index)
    {
        Path.MoveTo(index);
        Next();
        if (_reader.TokenType != JsonTokenType.EndArray) return true;
        Path.Leave();
        return false;
    }

    public readonly string String(string what)
    {
        Expect(JsonTokenType.String, what);
        return Text();
    }

    /// <summary>The number under the cursor. It is rounded once, from its decimal digits to float.</summary>
    public readonly float Float()
    {
        Expect(JsonTokenType.Number, "a number");
        if (!_reader.TryGetSingle(out float value) || !float.IsFinite(value))
            throw Refuse("the number is too large for a float");
        return value;
    }

    public readonly float NonNegative()
    {
        float value = Float();
        return value >= 0
            ? value
            : throw Refuse(FormattableString.Invariant($"must not be negative, but is {value:R}"));
    }

    public readonly float NotZero()
    {
        float value = Float();
        return value != 0 ? value : throw Refuse("must not be 0 as a float");
    }

    /// <summary>A whole number. 3.0 counts as one.</summary>
    public readonly int Whole(string what)
    {
        Expect(JsonTokenType.Number, what);
        if (_reader.TryGetInt32(out int value)) return value;
        bool isNumber = _reader.TryGetDouble(out double real);
        if (isNumber && real == Math.Floor(real) && Math.Abs(real) <= int.MaxValue) return (int)real;
        throw Refuse($"must be {what}");
    }

    public readonly bool Bool()
    {
        if (_reader.TokenType == JsonTokenType.False) return false;
        Expect(JsonTokenType.True, "true or false");
        return true;
    }

    public readonly bool IsArray => _reader.TokenType == JsonTokenType.StartArray;

    public Vector3 Vector(NumberRule rule = NumberRule.Any)
    {
        Span<float> v = stackalloc float[3];
        Floats(v, "three numbers [x, y, z]", rule);
        return new Vector3(v[0], v[1], v[2]);
    }

    public Quaternion Quaternion()
    {
        Span<float> q = stackalloc float[4];
        Floats(q, "four numbers [x, y, z, w]", NumberRule.Any);
        return new Quaternion(q[0], q[1], q[2], q[3]);
    }

    private void Floats(scoped Span<float> values, string what, NumberRule rule)
    {
        BeginArray(what);
        int count = 0;
        for (; NextElement(count); count++)
        {
            if (count == values.Length)
            {
                Path.Leave();
                throw Refuse($"must be {what}, but has more elements");
            }

            values[count] = rule switch
            {
                NumberRule.NonNegative => NonNegative(),
                NumberRule.NotZero => NotZero(),
                _ => Float(),
            };
        }

        if (count < values.Length) throw Refuse($"must be {what}, but has {count} element{(count == 1 ? "" : "s")}");
    }

    private readonly void Expect(JsonTokenType type, string what)
    {
        if (_reader.TokenType != type) throw Refuse($"must be {what}, but is {Describe(_reader.TokenType)}");
    }

    private readonly string Text()
    {
        try
        {
            return _reader.GetString()!;
        }
        catch (InvalidOperationException)
        {
            throw Refuse("the text is not valid Unicode");
        }
    }

    private void Next()
    {
        try
        {
            _reader.Read();
        }
        catch (JsonException e)
        {
            throw Syntax(e);
        }
    }

    /// <summary>Turns the parser's error into a refusal. The parser's message ends with the position in its own words.
    /// Here the position comes first and is counted from 1.</summary>
    private readonly RefusedException Syntax(JsonException e)
    {
        return Refuse(
            $"not valid JSON at line {e.LineNumber + 1}, byte {e.BytePositionInLine + 1}: {JsonFault.Reason(e)}");
    }

    private static string Describe(JsonTokenType type) => type switch
    {
        JsonTokenType.StartObject => "an object",
        JsonTokenType.StartArray => "an array",
        JsonTokenType.String => "a string",
        JsonTokenType.Number => "a number",
        JsonTokenType.True or JsonTokenType.False => "true or false",
        _ => "null",
    };
}

/// <summary>Which numbers are allowed, besides being finite.</summary>
internal enum NumberRule
{
    Any,
    NonNegative,
    NotZero,
}
