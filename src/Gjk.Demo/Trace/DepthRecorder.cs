namespace Gjk.Demo.Trace;

/// <summary>Keeps how the surface grows in the search for a depth. Of each surface only the difference to the one
/// before is kept, because a search may have more than a thousand steps.</summary>
internal readonly struct DepthRecorder : IPolytopeTrace
{
    private readonly DepthSearch _search;

    public DepthRecorder(DepthSearch search) => _search = search;

    public bool IsOn => true;

    public void OnStep(in PolytopeStep step)
    {
        // A search that begins anew numbers its points from 0 again.
        bool isNew = _search.Steps.Count == 0 || _search.Steps[^1].Outcome != PolytopeOutcome.Grows;
        if (isNew) _search.FirstVertex = _search.Vertices.Count;
        for (int i = _search.Vertices.Count - _search.FirstVertex; i < step.VertexCount; i++)
            _search.Vertices.Add(step.Vertex(i));
        var kept = new DepthStep(step, _search.FirstVertex);
        if (step.FaceCount > 0) Compare(step, kept);
        _search.Steps.Add(kept);
    }

    private void Compare(in PolytopeStep step, DepthStep kept)
    {
        Dictionary<int, (int, int, int)> faces = _search.Faces;
        var there = new HashSet<int>();
        for (int i = step.NextFace(-1); i >= 0; i = step.NextFace(i))
        {
            TracedFace face = step.Face(i);
            int first = _search.FirstVertex;
            (int A, int B, int C) corners = (face.A + first, face.B + first, face.C + first);
            there.Add(i);
            if (faces.TryGetValue(i, out (int, int, int) known) && known == corners) continue;
            faces[i] = corners;
            kept.Added.Add((i, corners.A, corners.B, corners.C));
        }

        foreach (int number in faces.Keys)
        {
            if (there.Contains(number)) continue;
            faces.Remove(number);
            kept.Removed.Add(number);
        }
    }
}

/// <summary>All steps of a search for a depth.</summary>
internal sealed class DepthSearch
{
    /// <summary>The points of A - B in the order in which they were found.</summary>
    public List<Double3> Vertices { get; } = [];

    public List<DepthStep> Steps { get; } = [];

    /// <summary>The index of the current search's first point.</summary>
    public int FirstVertex { get; set; }

    /// <summary>The current surface: the corners of each face by its number.</summary>
    public Dictionary<int, (int, int, int)> Faces { get; } = [];
}

/// <summary>One step of a search for a depth.</summary>
internal sealed class DepthStep
{
    public DepthStep(in PolytopeStep step, int firstVertex)
    {
        Outcome = step.Outcome;
        Faces = step.FaceCount;
        Lowest = step.LowestFace;
        Vertex = firstVertex + step.VertexCount - 1;
        Room = step.Room;
        Below = step.Below;
        Above = step.Above;
        Support = step.Support;
    }

    public PolytopeOutcome Outcome { get; }

    /// <summary>How many faces the surface has; 0 for a step without a surface, for which the page draws the last
    /// one.</summary>
    public int Faces { get; }

    /// <summary>The number of the lowest face, or -1.</summary>
    public int Lowest { get; }

    /// <summary>The index of the newest point.</summary>
    public int Vertex { get; }

    public int Room { get; }

    public double Below { get; }

    public double Above { get; }

    public TracedSupport Support { get; }

    /// <summary>The faces that are not those of the surface before: the number and the corners.</summary>
    public List<(int Number, int A, int B, int C)> Added { get; } = [];

    /// <summary>The numbers of the faces that are gone.</summary>
    public List<int> Removed { get; } = [];
}
