using System.CommandLine.Parsing;
using System.Numerics;

namespace Gjk.Demo;

/// <summary>Reads the numbers that options have.</summary>
internal static class OptionValue
{
    /// <summary>The number, or null with an error that names the option, the text and the rule.</summary>
    /// <param name="result">The option's text.</param>
    /// <param name="styles">What a number may look like.</param>
    /// <param name="isGood">Whether the number may be taken.</param>
    /// <param name="rule">What it must be, such as "must be a whole number, at least 1".</param>
    public static T? Parse<T>(ArgumentResult result, NumberStyles styles, Func<T, bool> isGood, string rule)
        where T : struct, INumberBase<T>
    {
        string text = result.Tokens.Count == 1 ? result.Tokens[0].Value : "";
        if (T.TryParse(text, styles, CultureInfo.InvariantCulture, out T value) && isGood(value)) return value;
        Refuse(result, rule);
        return null;
    }

    /// <summary>Adds the error.</summary>
    public static void Refuse(ArgumentResult result, string rule)
    {
        string name = result.Parent is OptionResult option ? option.IdentifierToken?.Value ?? option.Option.Name : "";
        string text = result.Tokens.Count == 1 ? result.Tokens[0].Value : "";
        result.AddError($"{name} {text}: {rule}.");
    }
}
