namespace Gjk.Demo.Study.Data;

/// <summary>Makes a trial of a row's fields, by name, and refuses what is not exactly right.</summary>
internal sealed class TrialReader
{
    private readonly string _source;
    private readonly IReadOnlyDictionary<string, string> _fields;

    /// <param name="source">The file and the place in it, for messages.</param>
    /// <param name="fields">Columns with their texts.</param>
    public TrialReader(string source, IReadOnlyDictionary<string, string> fields)
    {
        (_source, _fields) = (source, fields);
    }

    public Trial Read()
    {
        string task = OneOf("task", Trial.Adjustment, Trial.Constant, Trial.Mismatch);
        bool isAdjustment = task == Trial.Adjustment;
        var trial = new Trial
        {
            Plan = Name("plan"),
            Participant = Name("participant"),
            Number = (int)Number("trial"),
            Task = task,
            Kind = OneOf("kind", Trial.Real, Trial.Practice, Trial.Catch),
            Pair = Name("pair"),
            View = Text("view"),
            Collider = task == Trial.Mismatch ? Name("collider") : "",
            Start = isAdjustment ? (float)Number("start") : float.NaN,
            Gap = task == Trial.Constant ? (float)Number("gap") : float.NaN,
            Distance = (float)Number("distance"),
            Answer = isAdjustment ? -1 : OneOf("answer", "0", "1") == "1" ? 1 : 0,
            Seconds = Optional("seconds"),
            Pixels = Optional("pixels"),
            Arcminutes = Optional("arcminutes"),
            Record = Text("record"),
            Source = _source,
        };
        CheckRecord(trial);
        return trial;
    }

    /// <summary>Asks the library again. A distance that is not its answer, to the last bit, is no datum.</summary>
    private void CheckRecord(Trial trial)
    {
        if (trial.Record.Length == 0) return;
        if (!QueryRecord.TryParse(trial.Record, out QueryRecord record, out string? reason))
            throw Refuse("record", $"is not a record: {reason}");
        float answer = ConvexQuery.SignedDistance(record.A, record.PoseA, record.B, record.PoseB).Distance;
        if (answer != trial.Distance)
        {
            throw Refuse("distance", FormattableString.Invariant(
                $"{trial.Distance:R} is not the library's answer to the record, which is {answer:R}"));
        }
    }

    private RefusedException Refuse(string column, string reason) =>
        new($"{_source}: column {column}: {PlainText.Of(reason)}");

    private string Text(string column) => _fields.GetValueOrDefault(column, "");

    private string Name(string column)
    {
        string text = Text(column);
        return text.Length > 0 ? text : throw Refuse(column, "is empty");
    }

    private string OneOf(string column, params string[] words)
    {
        string text = Text(column);
        return words.Contains(text) ? text : throw Refuse(column, $"\"{text}\" must be {string.Join(" or ", words)}");
    }

    private double Number(string column)
    {
        string text = Text(column);
        bool isNumber = double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value);
        return isNumber && float.IsFinite((float)value) ? value
            : throw Refuse(column, $"\"{text}\" is not a finite number");
    }

    private double Optional(string column) => Text(column).Length == 0 ? double.NaN : Number(column);
}
