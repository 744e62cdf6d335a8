using System.CommandLine;
using System.CommandLine.Parsing;

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

    /// <summary>The number, or NaN, which a check refuses.</summary>
    public static T Number<T>(ArgumentResult result)
        where T : struct, IFloatingPoint<T>
    {
        string text = result.Tokens.Count == 1 ? result.Tokens[0].Value : "";
        bool isNumber = T.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out T value);

        // The parser reads a number that is too large as infinity. Only the word for infinity may mean that.
        if (isNumber && (!T.IsInfinity(value) || !text.Any(char.IsAsciiDigit))) return value;
        return T.CreateChecked(0) / T.CreateChecked(0);
    }

    /// <summary>Adds an error that names the option, the text and the reason if the value is not good.</summary>
    public static void Check<T>(OptionResult result, Option<T> option, Func<T, bool> isGood, string reason)
    {
        if (result.Errors.Any()) return;
        if (isGood(result.GetValueOrDefault<T>()!)) return;
        string given = string.Join(" ", result.Tokens.Select(t => t.Value));
        result.AddError($"{option.Name} {given}: {reason}.");
    }
}
