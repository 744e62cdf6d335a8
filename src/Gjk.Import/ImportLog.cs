using System.Collections.Generic;

namespace Gjk.Import;

/// <summary>
/// What could not be read, and what was read but may surprise, in the order in which they were found. Repeats count
/// once.
/// </summary>
internal sealed class ImportLog
{
    private readonly List<ImportProblem> _problems = [];
    private readonly HashSet<(string, string, bool)> _known = [];

    public IReadOnlyList<ImportProblem> Problems => _problems;

    /// <summary>Something that the scene lacks now.</summary>
    /// <param name="where">File, line and fileID.</param>
    /// <param name="reason">Why it cannot be read.</param>
    public void CannotRead(string where, string reason) => Add(where, reason, isMissing: true);

    /// <summary>Something that is in the scene, but perhaps not as the user expects.</summary>
    public void Warn(string where, string what) => Add(where, what, isMissing: false);

    /// <summary>Warns of a part that is not what its hull is.</summary>
    /// <param name="where">The file, and the place in it.</param>
    /// <param name="part">The part.</param>
    /// <param name="subject">What the warning calls the part, or null for its name.</param>
    public void WarnOf(string where, ImportedMesh part, string? subject = null)
    {
        if (Convexity.Warning(part) is not { } warning) return;
        Add(where, $"{subject ?? $"the part \"{part.Name}\""} {warning}", false, part.Triangles.Count > 0);
    }

    private void Add(string where, string what, bool isMissing, bool isOfHull = false)
    {
        if (_known.Add((where, what, isMissing))) _problems.Add(new ImportProblem(where, what, isMissing, isOfHull));
    }
}
