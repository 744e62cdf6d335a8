using System.Text.Json;

namespace Gjk.Demo.Study.Data;

/// <summary>Reads the data of a study: files of CSV, or of JSON with the same fields, as the page saves them.</summary>
internal static class TrialFiles
{
    /// <exception cref="RefusedException">A file is not such data, or the files do not belong together.</exception>
    public static List<Trial> Load(IReadOnlyList<string> files, CancellationToken cancel)
    {
        var trials = new List<Trial>();
        foreach (string file in files)
        {
            int before = trials.Count;
            trials.AddRange(Parse(InputFile.NameOf(file), InputFile.Read(file, cancel)));
            if (trials.Count == before) throw new RefusedException($"{InputFile.NameOf(file)}: it has no trials");
        }

        CheckTogether(trials);
        return trials;
    }

    public static IEnumerable<Trial> Parse(string file, byte[] bytes)
    {
        string text = new UTF8Encoding().GetString(bytes).TrimStart('\uFEFF');
        if (text.Trim().Length == 0) throw new RefusedException($"{file}: it is empty");
        return text.TrimStart()[0] == '{' ? ParseJson(file, text) : ParseCsv(file, text);
    }

    private static IEnumerable<Trial> ParseCsv(string file, string text)
    {
        string[]? names = null;
        foreach ((int line, List<string> fields) in Rows(file, text))
        {
            if (names is null)
            {
                names = [.. fields];
                CheckColumns(file, names);
                continue;
            }

            string source = $"{file}: line {line}";
            if (fields.Count != names.Length)
                throw new RefusedException(
                    $"{source}: it has {fields.Count} fields, but there are {names.Length} columns");
            yield return new TrialReader(source, names.Zip(fields).ToDictionary(p => p.First, p => p.Second)).Read();
        }
    }

    private static void CheckColumns(string file, string[] names)
    {
        foreach (string column in Trial.RequiredColumns)
        {
            if (!names.Contains(column)) throw new RefusedException($"{file}: line 1: the column {column} is missing");
        }

        if (names.GroupBy(n => n).FirstOrDefault(g => g.Count() > 1) is { } twice)
            throw new RefusedException($"{file}: line 1: the column {PlainText.Of(twice.Key)} is there twice");
    }

    /// <summary>The rows with the lines on which they begin (RFC 4180). Empty lines are passed over.</summary>
    private static IEnumerable<(int Line, List<string> Fields)> Rows(string file, string text)
    {
        var fields = new List<string>();
        var field = new StringBuilder();
        int line = 1, first = 1;
        bool isQuoted = false;
        for (int i = 0; i <= text.Length; i++)
        {
            char c = i < text.Length ? text[i] : '\n';
            if (i == text.Length && isQuoted) throw new RefusedException(
                $"{file}: line {first}: a quote is not closed");
            if (c == '\n') line++;
            if (c == '"')
            {
                bool isPair = isQuoted && i + 1 < text.Length && text[i + 1] == '"';
                if (isPair) field.Append(text[i++]);
                else isQuoted = !isQuoted;
            }
            else if (isQuoted || (c is not (',' or '\n' or '\r')))
            {
                field.Append(c);
            }
            else if (c != '\r')
            {
                fields.Add(field.ToString());
                field.Clear();
                if (c == ',') continue;
                if (fields.Count > 1 || fields[0].Length > 0) yield return (first, fields);
                fields = [];
                first = line;
            }
        }
    }

    private static IEnumerable<Trial> ParseJson(string file, string text)
    {
        JsonDocument document;
        try
        {
            document = JsonDocument.Parse(text);
        }
        catch (JsonException e)
        {
            throw new RefusedException($"{file}: not valid JSON at line {e.LineNumber + 1}");
        }

        using (document)
        {
            bool hasTrials = document.RootElement.TryGetProperty("trials", out JsonElement trials)
                && trials.ValueKind == JsonValueKind.Array;
            if (!hasTrials) throw new RefusedException($"{file}: $.trials: must be an array of trials");
            int i = 0;
            foreach (JsonElement trial in trials.EnumerateArray())
            {
                string source = $"{file}: $.trials[{i++}]";
                if (trial.ValueKind != JsonValueKind.Object) throw new RefusedException($"{source}: must be an object");
                var fields = new Dictionary<string, string>();
                foreach (JsonProperty p in trial.EnumerateObject())
                    fields[p.Name] = p.Value.ValueKind == JsonValueKind.Null ? "" : p.Value.ToString();
                if (Trial.RequiredColumns.FirstOrDefault(c => !fields.ContainsKey(c)) is { } missing)
                    throw new RefusedException($"{source}.{missing}: missing");
                yield return new TrialReader(source, fields).Read();
            }
        }
    }

    private static void CheckTogether(List<Trial> trials)
    {
        var seen = new Dictionary<(string, int), Trial>();
        foreach (Trial trial in trials)
        {
            if (trial.Plan != trials[0].Plan)
            {
                throw new RefusedException(PlainText.Of(
                    $"{trial.Source}: its plan {trial.Plan} is not the plan {trials[0].Plan} of {trials[0].Source}; "
                    + "data of different plans cannot be fitted together"));
            }

            if (!seen.TryAdd((trial.Participant, trial.Number), trial))
            {
                Trial first = seen[(trial.Participant, trial.Number)];
                throw new RefusedException(PlainText.Of(
                    $"{trial.Source}: trial {trial.Number} of {trial.Participant} is there already: {first.Source}"));
            }
        }
    }
}
