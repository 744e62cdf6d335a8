using System.Linq;

namespace Gjk.Import;

/// <summary>What was in a file. Immutable.</summary>
public sealed class ImportResult
{
    internal ImportResult(SceneBuilder scene, ImportLog log)
    {
        Objects = scene.Objects;
        Meshes = scene.Meshes;
        Problems = log.Problems;
    }

    /// <summary>The objects in the order of the file. No two have the same name. At most a million.</summary>
    public IReadOnlyList<ImportedObject> Objects { get; }

    /// <summary>The meshes that objects have; several may share one. No two have the same name.</summary>
    public IReadOnlyList<ImportedMesh> Meshes { get; }

    /// <summary>What could not be read, and what was read but may surprise, in the order of the file. Of several of one
    /// kind the first is listed, with their number.</summary>
    public IReadOnlyList<ImportProblem> Problems { get; }

    /// <summary>How many things could not be read and are missing from <see cref="Objects"/>.</summary>
    public int MissingCount => Problems.Where(p => p.IsMissing).Sum(p => p.Count);
}

/// <summary>Something in a file that the user should know of. Immutable.</summary>
public sealed class ImportProblem
{
    internal ImportProblem(string where, string what, bool isMissing, bool isOfHull, int count)
    {
        IsOfHull = isOfHull;
        Where = OneLine(where);
        What = OneLine(what);
        IsMissing = isMissing;
        Count = count;
    }

    /// <summary>The file, and the place of the first in it: a line, a node or an object.</summary>
    public string Where { get; }

    /// <summary>What is wrong, in a few words.</summary>
    public string What { get; }

    /// <summary>True if something could not be read, false if it was read but may surprise.</summary>
    public bool IsMissing { get; }

    /// <summary>How many things of the file have this problem, at least 1.</summary>
    public int Count { get; }

    /// <summary>True if a mesh differs from its hull. Only <see cref="ImportedObject.ToConvexShape"/> is concerned:
    /// <see cref="ImportedObject.ToAnyShape"/> keeps the triangles.</summary>
    public bool IsOfHull { get; }

    /// <summary>One line: the place, "warning" unless something is missing, what is wrong, and how many more there
    /// are.</summary>
    public override string ToString() =>
        $"{Where}: {(IsMissing ? "" : "warning: ")}{What}{(Count > 1 ? $"; and {Count - 1} more" : "")}";

    internal ImportProblem Again() => new(Where, What, IsMissing, IsOfHull, Count + 1);

    /// <summary>A name in a file may hold line breaks.</summary>
    internal static string OneLine(string text)
    {
        int first = 0;
        while (first < text.Length && !char.IsControl(text[first])) first++;
        return first == text.Length
            ? text
            : string.Create(text.Length, text, (line, given) =>
            {
                for (int i = 0; i < line.Length; i++) line[i] = char.IsControl(given[i]) ? ' ' : given[i];
            });
    }
}
