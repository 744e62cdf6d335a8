using System.CommandLine;

namespace Gjk.Demo.Queries;

/// <summary>The part of a scene's pairs that one of several machines answers.</summary>
/// <param name="Number">From 1.</param>
/// <param name="Of">How many parts there are.</param>
internal readonly record struct Shard(int Number, int Of)
{
    private const int Most = 1_000_000;

    public static Shard Whole => new(1, 1);

    /// <summary>The same scene with the pairs of this part.</summary>
    public Scene Cut(Scene scene) =>
        Of == 1 ? scene : new Scene(scene.Name, scene.Objects, scene.Pairs.Shard(Number, Of), scene.Frames);

    public static Option<Shard> Option() => new("--shard")
    {
        Description = "Answer only the K-th of N equal parts of the pairs, for work on many machines. Only the first "
            + "has the heading, so all parts in order are the bytes of one run.",
        HelpName = "K/N",
        DefaultValueFactory = _ => Whole,
        CustomParser = result =>
        {
            string[] words = result.Tokens[0].Value.Split('/');
            if (words.Length == 2 && TryParse(words[0], out int number) && TryParse(words[1], out int of))
                if (number <= of) return new Shard(number, of);
            OptionValue.Refuse(result, $"must be K/N with K from 1 to N, and N at most {Most}");
            return Whole;
        },
    };

    private static bool TryParse(string word, out int number) =>
        int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out number) && number is >= 1 and <= Most;

    public override string ToString() => $"{Number}/{Of}";
}
