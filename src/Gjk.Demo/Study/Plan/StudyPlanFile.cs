using System.Security.Cryptography;
using System.Text.RegularExpressions;

namespace Gjk.Demo.Study.Plan;

/// <summary>Reads a plan. It refuses everything that is not exactly right, with the file, the JSON path and the reason.
/// Fields whose names begin with // are remarks.</summary>
internal sealed partial class StudyPlanFile
{
    public static readonly string[] Cameras = ["fixed", "random", "turning"];

    private const int Version = 1;

    /// <summary>More trials than anybody does, in all tasks together.</summary>
    private const int MostTrials = 10_000;

    private static readonly string[] Fields =
    [
        "version", "name", "seed", "consent", "instructions", "questions", "viewingDistance", "meshes", "pairs",
            "views",
        "adjustment", "constant", "mismatch", "practice", "catch", "breakEvery",
    ];

    private static readonly string[] Required = ["version", "name", "consent", "instructions", "pairs", "views"];

    private readonly SceneMeshes _meshes = new();

    private StudyPlan _plan = new();

    private delegate void ReadField(ref StrictJsonReader json, string field);

    public static StudyPlan Load(string file, CancellationToken cancel) =>
        Parse(InputFile.NameOf(file), InputFile.Read(file, cancel));

    public static StudyPlan Parse(string file, ReadOnlySpan<byte> utf8)
    {
        string id = Convert.ToHexStringLower(SHA256.HashData(utf8))[..12];
        if (utf8.StartsWith("\uFEFF"u8)) utf8 = utf8["\uFEFF"u8.Length..];
        var json = new StrictJsonReader(file, utf8);
        var reader = new StudyPlanFile();
        json.Start();
        ReadObject(ref json, "an object: a plan", Fields, Required, reader.Read);
        json.End();
        reader.CheckWhole(json);
        return reader._plan with { Id = id };
    }

    /// <summary>How many trials a person does, without practice.</summary>
    public static int TrialsOf(StudyPlan plan)
    {
        long conditions = (long)plan.Pairs.Count * plan.Views.Count;
        long each = (plan.Adjustment is { } a ? (long)a.Repeats * a.Starts.Length : 0)
            + (plan.Constant is { } c ? (long)c.Repeats * c.Gaps.Length : 0)
            + (plan.Mismatch is { } m ? (long)m.Repeats * m.Colliders.Length : 0);
        return (int)Math.Min(int.MaxValue, conditions * each + plan.CatchTrials);
    }

    private static void ReadObject(
        ref StrictJsonReader json, string what, string[] fields, string[] required, ReadField read)
    {
        var seen = new HashSet<string>();
        json.BeginObject(what);
        while (json.NextField(seen, out string field))
        {
            bool isRemark = field.StartsWith("//", StringComparison.Ordinal);
            if (!isRemark && Array.IndexOf(fields, field) < 0)
                throw json.Refuse($"unknown field; must be one of {string.Join(", ", fields)}");
            json.Value();
            if (isRemark) json.String("a remark: a string");
            else read(ref json, field);
            json.EndField();
        }

        foreach (string name in required.Where(name => !seen.Contains(name)))
        {
            json.Path.Enter(name);
            throw json.Refuse("missing");
        }
    }

    private void CheckWhole(in StrictJsonReader json)
    {
        if (_plan.Adjustment is null && _plan.Constant is null && _plan.Mismatch is null)
            throw json.Refuse("has no task; must have adjustment, constant or mismatch");
        if (TrialsOf(_plan) > MostTrials)
            throw json.Refuse($"{TrialsOf(_plan)} trials for each person are more than {MostTrials}");
        if (_plan.CatchTrials > 0 && _plan.Constant is null)
            throw json.Refuse("catch trials are of the task constant, which is missing");
    }

    private void Read(ref StrictJsonReader json, string field)
    {
        switch (field)
        {
            case "version":
                int version = json.Whole("the number 1");
                if (version != Version) throw json.Refuse($"version {version} is not known; must be {Version}");
                break;
            case "name": _plan = _plan with { Name = Text(json) }; break;
            case "seed": _plan = _plan with { Seed = Count(json, 0, int.MaxValue) }; break;
            case "consent": _plan = _plan with { Consent = Text(json) }; break;
            case "instructions": _plan = _plan with { Instructions = Text(json) }; break;
            case "questions": _plan = _plan with { HasQuestions = json.Bool() }; break;
            case "viewingDistance": _plan = _plan with { ViewingDistance = Positive(json) }; break;
            case "meshes": _meshes.Read(ref json); break;
            case "pairs": _plan = _plan with { Pairs = List(ref json, "pair", ReadPair, p => p.Name) }; break;
            case "views": _plan = _plan with { Views = List(ref json, "view", ReadView, v => v.Name) }; break;
            case "adjustment": _plan = _plan with { Adjustment = ReadAdjustment(ref json) }; break;
            case "constant": _plan = _plan with { Constant = ReadConstant(ref json) }; break;
            case "mismatch": _plan = _plan with { Mismatch = ReadMismatch(ref json) }; break;
            case "practice": _plan = _plan with { PracticeTrials = Count(json, 0, 100) }; break;
            case "catch": ReadCatch(ref json); break;
            case "breakEvery": _plan = _plan with { BreakEvery = Count(json, 0, MostTrials) }; break;
        }
    }

    private delegate T ReadItem<T>(ref StrictJsonReader json);

    private static List<T> List<T>(ref StrictJsonReader json, string what, ReadItem<T> read, Func<T, string> name)
    {
        var items = new List<T>();
        json.BeginArray($"an array of {what}s");
        while (json.NextElement(items.Count))
        {
            T item = read(ref json);
            if (items.Any(i => name(i) == name(item)))
                throw json.Refuse($"there is a {what} \"{name(item)}\" already");
            items.Add(item);
        }

        return items.Count > 0 ? items : throw json.Refuse($"must have at least one {what}");
    }

    private static string Text(in StrictJsonReader json)
    {
        string text = json.String("a text");
        return text.Trim().Length > 0 ? text : throw json.Refuse("must not be empty");
    }

    private static int Count(in StrictJsonReader json, int least, int most)
    {
        int count = json.Whole($"a whole number, {least} to {most}");
        return count >= least && count <= most ? count
            : throw json.Refuse($"must be {least} to {most}, but is {count}");
    }

    private static float Positive(in StrictJsonReader json)
    {
        float value = json.NonNegative();
        return value > 0 ? value : throw json.Refuse("must be above 0");
    }

    [GeneratedRegex("^#[0-9a-fA-F]{6}$")]
    private static partial Regex Colour();
}
