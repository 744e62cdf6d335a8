namespace Gjk.Core;

/// <summary>Which objects and parts a result is of, for people to read: what is not there, -1, is not named.</summary>
internal static class HitText
{
    public static string Name(ObjectPair pair, int partA, int partB) =>
        Name(pair.A < 0 ? "" : pair.ToString(), PartsOf(partA, partB));

    public static string Name(int id, int partA, int partB) => Name(NumberOf(id), PartsOf(partA, partB));

    public static string Name(int id, int part) => Name(NumberOf(id), part < 0 ? "" : "part " + NumberOf(part));

    private static string Name(string objects, string parts)
    {
        string both = objects + (objects == "" || parts == "" ? "" : ", ") + parts;
        return both == "" ? both : both + ": ";
    }

    private static string PartsOf(int a, int b) =>
        a < 0 && b < 0 ? "" : FormattableString.Invariant($"parts {a} and {b}");

    private static string NumberOf(int id) => id < 0 ? "" : FormattableString.Invariant($"{id}");
}
