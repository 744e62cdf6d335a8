using System.Text.Json;

namespace Gjk.Demo.Trace;

/// <summary>How the page of a trace writes numbers.</summary>
internal static class TraceJson
{
    /// <summary>Writes a number. JSON has no infinities, and the page takes null for "none".</summary>
    public static void Number(Utf8JsonWriter json, string name, double value)
    {
        if (double.IsFinite(value)) json.WriteNumber(name, value);
        else json.WriteNull(name);
    }

    public static void Vector(Utf8JsonWriter json, string name, in Double3 v) => Numbers(json, name, [v.X, v.Y, v.Z]);

    public static void Numbers(Utf8JsonWriter json, string name, ReadOnlySpan<double> values)
    {
        json.WritePropertyName(name);
        NumbersOf(json, values);
    }

    public static void NumbersOf(Utf8JsonWriter json, ReadOnlySpan<double> values)
    {
        json.WriteStartArray();
        foreach (double value in values)
        {
            if (double.IsFinite(value)) json.WriteNumberValue(value);
            else json.WriteNullValue();
        }

        json.WriteEndArray();
    }

    public static void Indices(Utf8JsonWriter json, string name, IEnumerable<int> values)
    {
        json.WriteStartArray(name);
        foreach (int value in values) json.WriteNumberValue(value);
        json.WriteEndArray();
    }
}
