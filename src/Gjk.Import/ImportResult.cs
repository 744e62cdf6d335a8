using System.Collections.Generic;
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

    /// <summary>What could not be read, and what was read but may surprise, in the order of the file.</summary>
    public IReadOnlyList<ImportProblem> Problems { get; }

    /// <summary>How many things could not be read and are missing from <see cref="Objects"/>.</summary>
    public int MissingCount => Problems.Count(p => p.IsMissing);
}

/// <summary>Something in a file that the user should know of. Immutable.</summary>
public sealed class ImportProblem
{
    internal ImportProblem(string where, string what, bool isMissing, bool isOfHull)
    {
        IsOfHull = isOfHull;
        Where = where;
        What = what;
        IsMissing = isMissing;
    }

    /// <summary>The file, and the place in it: a line, a node or an object.</summary>
    public string Where { get; }

    /// <summary>What is wrong, in a few words.</summary>
    public string What { get; }

    /// <summary>True if something could not be read, false if it was read but may surprise.</summary>
    public bool IsMissing { get; }

    /// <summary>True if a mesh differs from its hull, which is no problem for one whose triangles are kept.</summary>
    internal bool IsOfHull { get; }

    /// <summary>One line: the place, "warning" unless something is missing, and what is wrong.</summary>
    public override string ToString() => IsMissing ? $"{Where}: {What}" : $"{Where}: warning: {What}";
}
