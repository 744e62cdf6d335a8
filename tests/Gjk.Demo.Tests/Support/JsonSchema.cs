using System.Text.Json.Nodes;

namespace Gjk.Demo.Tests.Support;

/// <summary>Checks JSON against the part of JSON schema (draft 2020-12) that the scene's schema uses. Any other keyword
/// is an error, so that none is skipped in silence.</summary>
public sealed class JsonSchema
{
    private static readonly HashSet<string> Descriptive = ["$schema", "$defs", "title", "description"];

    public JsonSchema(string text) => Root = JsonNode.Parse(text)!.AsObject();

    public JsonObject Root { get; }

    /// <summary>True if the whole text fits the schema.</summary>
    public bool Accepts(string json) => Fits(Root, JsonNode.Parse(json));

    /// <summary>The schema of a name in "$defs".</summary>
    public JsonObject Definition(string name) => Root["$defs"]![name]!.AsObject();

    private bool Fits(JsonObject schema, JsonNode? value) =>
        schema.All(rule => Descriptive.Contains(rule.Key) || Fits(schema, rule.Key, rule.Value!, value));

    private bool Fits(JsonObject schema, string keyword, JsonNode rule, JsonNode? value) => keyword switch
    {
        "$ref" => Fits(Definition(rule.GetValue<string>().Replace("#/$defs/", "")), value),
        "type" => IsOfType(rule.GetValue<string>(), value),
        "const" => JsonNode.DeepEquals(rule, value),
        "not" => !Fits(rule.AsObject(), value),
        "anyOf" => rule.AsArray().Any(one => Fits(one!.AsObject(), value)),
        "oneOf" => rule.AsArray().Count(one => Fits(one!.AsObject(), value)) == 1,
        "minimum" => Number(value) is not { } n || n >= rule.GetValue<double>(),
        "maximum" => Number(value) is not { } n || n <= rule.GetValue<double>(),
        "items" => value is not JsonArray array || array.All(item => Fits(rule.AsObject(), item)),
        "minItems" => value is not JsonArray array || array.Count >= rule.GetValue<int>(),
        "maxItems" => value is not JsonArray array || array.Count <= rule.GetValue<int>(),
        "required" => value is not JsonObject o || rule.AsArray().All(name => o.ContainsKey(name!.GetValue<string>())),
        "properties" => value is not JsonObject o || rule.AsObject().All(
            field => !o.ContainsKey(field.Key) || Fits(field.Value!.AsObject(), o[field.Key])),
        "additionalProperties" => value is not JsonObject o || o.All(
            field => schema["properties"]?.AsObject().ContainsKey(field.Key) == true || IsExtra(rule, field.Value)),
        _ => throw new NotSupportedException($"The keyword {keyword} is not checked."),
    };

    private bool IsExtra(JsonNode rule, JsonNode? value) =>
        rule is JsonObject schema ? Fits(schema, value) : rule.GetValue<bool>();

    private static bool IsOfType(string type, JsonNode? value) => type switch
    {
        "object" => value is JsonObject,
        "array" => value is JsonArray,
        "string" => value?.GetValueKind() == System.Text.Json.JsonValueKind.String,
        "number" => Number(value) is not null,
        "integer" => Number(value) is { } n && Math.Floor(n) == n,
        _ => throw new NotSupportedException($"The type {type} is not checked."),
    };

    private static double? Number(JsonNode? value) =>
        value?.GetValueKind() == System.Text.Json.JsonValueKind.Number ? value.GetValue<double>() : null;
}
