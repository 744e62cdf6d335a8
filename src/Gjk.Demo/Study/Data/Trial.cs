namespace Gjk.Demo.Study.Data;

/// <summary>One answered trial: a row of the data.</summary>
internal sealed record Trial
{
    public const string Adjustment = "adjustment", Constant = "constant", Mismatch = "mismatch";

    public const string Real = "trial", Practice = "practice", Catch = "catch";

    /// <summary>The columns, in order.</summary>
    public static readonly string[] Columns =
    [
        "plan", "participant", "trial", "task", "kind", "pair", "view", "collider", "start", "gap", "distance",
            "answer",
        "seconds", "pixels", "arcminutes", "record",
    ];

    public static readonly string[] RequiredColumns =
        ["plan", "participant", "trial", "task", "kind", "pair", "start", "gap", "distance", "answer"];

    public string Plan { get; init; } = "";

    public string Participant { get; init; } = "";

    public int Number { get; init; }

    /// <summary>One of the tasks above.</summary>
    public string Task { get; init; } = "";

    /// <summary>One of the kinds above.</summary>
    public string Kind { get; init; } = Real;

    public string Pair { get; init; } = "";

    public string View { get; init; } = "";

    public string Collider { get; init; } = "";

    /// <summary>The gap at which an adjustment began; NaN in other tasks.</summary>
    public float Start { get; init; } = float.NaN;

    /// <summary>The gap that was asked for; NaN for an adjustment.</summary>
    public float Gap { get; init; } = float.NaN;

    /// <summary>The library's signed distance of the two shapes as they were drawn.</summary>
    public float Distance { get; init; }

    /// <summary>1 for "touching" or "looks right", 0 for the other one, -1 for an adjustment.</summary>
    public int Answer { get; init; } = -1;

    public double Seconds { get; init; } = double.NaN;

    public double Pixels { get; init; } = double.NaN;

    public double Arcminutes { get; init; } = double.NaN;

    /// <summary>Both bodies as a record of the library, or empty.</summary>
    public string Record { get; init; } = "";

    /// <summary>Where the trial came from, such as "file.csv: line 3".</summary>
    public string Source { get; init; } = "";

    public static string Header => string.Join(',', Columns);

    public string ToCsv() => string.Join(',', ((string[])
    [
        Plan, Participant, Number.ToString(CultureInfo.InvariantCulture), Task, Kind, Pair, View, Collider, Text(Start),
        Text(Gap), Text(Distance), Answer < 0 ? "" : Answer == 0 ? "0" : "1", Text(Seconds), Text(Pixels),
        Text(Arcminutes), Record,
    ]).Select(PlainText.CsvField));

    private static string Text<T>(T value)
        where T : IFormattable =>
        double.IsNaN(Convert.ToDouble(value, CultureInfo.InvariantCulture))
            ? ""
            : value.ToString("R", CultureInfo.InvariantCulture);
}
