namespace Gjk.Demo.Trace;

/// <summary>Finds the two objects that the user names, by their indices or their names. A name may contain a comma, so
/// every comma is tried. Where a text is a name and an index, it is the name, except in a pair of two
/// indices.</summary>
internal static class NamedPair
{
    /// <summary>Two indices, such as 0,1.</summary>
    public static bool TryParseIndices(string text, out int a, out int b)
    {
        string[] parts = text.Split(',');
        b = 0;
        return TryIndex(parts[0], out a) && parts.Length == 2 && TryIndex(parts[1], out b);
    }

    /// <summary>Finds the objects.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="file">The user's name for the scene.</param>
    /// <param name="text">What the user wrote.</param>
    /// <exception cref="RefusedException">They are not two objects of the scene, or the names fit several.</exception>
    public static (int A, int B) Find(Scene scene, string file, string text)
    {
        RefusedException Refuse(string reason) => new($"{file}: --pair {text}: {reason}");
        int count = scene.Objects.Length;
        if (TryParseIndices(text, out int first, out int second))
        {
            return first < count && second < count
                ? (first, second)
                : throw Refuse($"the scene has {count} object{(count == 1 ? "" : "s")}, counted from 0");
        }

        var found = new List<(List<int> A, List<int> B)>();
        var missing = new List<string>();
        for (int comma = text.IndexOf(','); comma >= 0; comma = text.IndexOf(',', comma + 1))
        {
            string nameA = text[..comma], nameB = text[(comma + 1)..];
            List<int> a = Named(scene, nameA), b = Named(scene, nameB);
            if (a.Count > 0 && b.Count > 0) found.Add((a, b));
            else missing.Add(a.Count == 0 ? nameA : nameB);
        }

        if (found.Count == 0) throw Refuse($"there is no object \"{missing[0]}\"");
        if (found.Count > 1) throw Refuse("the names fit several pairs; use the indices of the objects");
        foreach (List<int> named in (IEnumerable<List<int>>)[found[0].A, found[0].B])
        {
            if (named.Count == 1) continue;
            throw Refuse(
                $"{named.Count} objects have the name \"{scene.Objects[named[0]].Name}\", such as {named[0]} and "
                + $"{named[1]}; use their indices");
        }

        (int A, int B) pair = (found[0].A[0], found[0].B[0]);
        return pair.A != pair.B ? pair : throw Refuse("must be two different objects");
    }

    /// <summary>The objects of a name or, where none has it, the one of an index.</summary>
    private static List<int> Named(Scene scene, string name)
    {
        List<int> named = [.. Enumerable.Range(0, scene.Objects.Length).Where(i => scene.Objects[i].Name == name)];
        if (named.Count == 0 && TryIndex(name, out int index) && index < scene.Objects.Length) named.Add(index);
        return named;
    }

    private static bool TryIndex(string text, out int index) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out index);
}
