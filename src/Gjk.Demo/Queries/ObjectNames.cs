namespace Gjk.Demo.Queries;

/// <summary>The names of a scene's objects, in the form of the CSV. An object without a name has an empty
/// one.</summary>
internal static class ObjectNames
{
    public static string[] Of(Scene scene)
    {
        string[] fields = new string[scene.Objects.Length];
        for (int i = 0; i < fields.Length; i++) fields[i] = PlainText.CsvField(scene.Objects[i].Name ?? "");
        return fields;
    }

    /// <summary>Warns on standard error if a name does not tell which object is meant.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="name">The user's name for the scene.</param>
    public static void WarnOfRepeats(Scene scene, string name)
    {
        var first = new Dictionary<string, int>();
        int repeats = 0;
        string example = "";
        for (int i = 0; i < scene.Objects.Length; i++)
        {
            if (scene.Objects[i].Name is not { } own || first.TryAdd(own, i)) continue;
            if (repeats++ == 0) example = $"\"{own}\" for the objects {first[own]} and {i}";
        }

        if (repeats == 0) return;
        string many = repeats == 1 ? "a name appears" : $"{repeats} names appear";
        StandardError.Line($"{name}: warning: {many} again: {example}");
    }
}
