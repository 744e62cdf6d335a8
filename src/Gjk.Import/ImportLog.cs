namespace Gjk.Import;

/// <summary>What could not be read, and what was read but may surprise. Each is counted; of one kind the first is
/// listed, in the order in which they were found.</summary>
internal sealed class ImportLog
{
    private readonly List<ImportProblem> _problems = [];
    private readonly Dictionary<(string Kind, bool IsMissing), int> _known = [];

    public IReadOnlyList<ImportProblem> Problems => _problems;

    /// <summary>Something that the scene lacks now.</summary>
    /// <param name="where">File, line and fileID.</param>
    /// <param name="reason">Why it cannot be read.</param>
    /// <param name="kind">What else counts as the same; null for the same reason.</param>
    public void CannotRead(string where, string reason, string? kind = null) =>
        Add(new ImportProblem(where, reason, true, false, 1), kind);

    /// <summary>Something that is in the scene, but perhaps not as the user expects.</summary>
    public void Warn(string where, string what, string? kind = null) =>
        Add(new ImportProblem(where, what, false, false, 1), kind);

    /// <summary>Warns of a part that is not what its hull is.</summary>
    /// <param name="where">The file, and the place in it.</param>
    /// <param name="part">The part.</param>
    /// <param name="subject">What the warning calls the part, or null for its name.</param>
    public void WarnOf(string where, ImportedMesh part, string? subject = null)
    {
        if (Convexity.Warning(part) is not { } warning) return;
        string what = $"{subject ?? $"the part \"{part.Name}\""} {warning}";

        // Each mesh is worth a line of its own.
        Add(new ImportProblem(where, what, false, part.Triangles.Count > 0, 1), $"{where}: {what}");
    }

    /// <summary>Warns of a face whose triangles may not be what the file means.</summary>
    public void WarnOf(string where, PolygonFaults faults)
    {
        if ((faults & PolygonFaults.Thin) != 0) Warn(where, "a face of fewer than three corners is left out");
        if ((faults & PolygonFaults.NotSimple) != 0)
            Warn(where, "the outline of a face crosses or touches itself, so its triangles may overlap");
        if ((faults & PolygonFaults.NotFlat) != 0)
            Warn(where, "the corners of a face do not lie in one plane, so there are several ways to cut it");
    }

    public void Add(UnityProblem found) =>
        Add(new ImportProblem(found.Where, found.What, found.IsMissing, false, 1), found.Kind);

    private void Add(ImportProblem found, string? kind)
    {
        if (_known.TryGetValue((kind ?? found.What, found.IsMissing), out int first))
        {
            _problems[first] = _problems[first].Again();
            return;
        }

        _known.Add((kind ?? found.What, found.IsMissing), _problems.Count);
        _problems.Add(found);
    }
}
