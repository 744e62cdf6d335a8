using System.Text.Json;

namespace Gjk.Demo.Scenes;

/// <summary>What is wrong with a text that is no JSON, for somebody who does not know the parser.</summary>
internal static class JsonFault
{
    /// <summary>How the parser's messages begin that speak of the parser, or of its options, and what they
    /// mean.</summary>
    private static readonly (string Start, string Meaning)[] Known =
    [
        ("The input does not contain any JSON tokens", "it is empty"),
        ("Expected depth to be zero", "it ends before an object or array is closed"),
        ("Expected end of string, but instead reached end of data", "it ends within a text"),
        ("Expected a value, but instead reached end of data", "it ends where a value must be"),
        ("The JSON object contains a trailing comma", "there is a comma behind the last field"),
        ("The JSON array contains a trailing comma", "there is a comma behind the last element"),
        ("The maximum configured depth", "too many objects and arrays lie within each other, more than 64"),
    ];

    /// <summary>The reason without the place, which a <see cref="JsonException"/> has as numbers, too.</summary>
    public static string Reason(JsonException fault)
    {
        foreach ((string start, string meaning) in Known)
        {
            if (fault.Message.StartsWith(start, StringComparison.Ordinal)) return meaning;
        }

        int tail = fault.Message.IndexOf(" LineNumber:", StringComparison.Ordinal);
        string reason = tail < 0 ? fault.Message : fault.Message[..tail];
        return reason.Contains("reached end of data") ? "it ends too early" : reason;
    }
}
