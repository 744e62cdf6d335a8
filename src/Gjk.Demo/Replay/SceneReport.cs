namespace Gjk.Demo.Replay;

/// <summary>The result of replaying one scene: the answers, which are the same in every frame, and the times.</summary>
internal sealed class SceneReport
{
    public SceneReport(
        ReplayScene scene, ReadOnlySpan<int> a, ReadOnlySpan<int> b, DistanceResult[] results)
    {
        Name = scene.Scene.Name;
        ObjectNames = [.. scene.Scene.Objects.Select((o, i) => o.Name ?? $"object {i}")];
        VerticesPerObject = scene.Vertices;
        HullVertices = scene.HullVertices;
        Published = scene.Published;
        A = a.ToArray();
        B = b.ToArray();
        Results = results;

        var hash = new ResultHash();
        long loops = 0;
        for (int i = 0; i < results.Length; i++)
        {
            hash.Add(A[i], B[i], results[i]);
            loops += results[i].Iterations;
            if (results[i].IsOverlapping) IntersectingPairs++;
            if (results[i].Status == GjkStatus.IterationLimit) IterationLimits++;
        }

        Hash = hash.ToString();
        LoopsPerCall = (double)loops / results.Length;
    }

    public string Name { get; }

    public string[] ObjectNames { get; }

    /// <summary>Vertices in each mesh as given, if that is known and the same for all.</summary>
    public int? VerticesPerObject { get; }

    /// <summary>Vertices after deduplication, if each object is a mesh with as many.</summary>
    public int? HullVertices { get; }

    /// <summary>What the report says of this scene, or null.</summary>
    public PublishedFigures? Published { get; }

    /// <summary>The first member of each pair.</summary>
    public int[] A { get; }

    /// <summary>The second member of each pair.</summary>
    public int[] B { get; }

    public DistanceResult[] Results { get; }

    public int IntersectingPairs { get; }

    public double LoopsPerCall { get; }

    public int IterationLimits { get; }

    public string Hash { get; }

    public int Frames { get; init; }

    public double MedianMs { get; init; }

    /// <summary>The 99th percentile of the frame times.</summary>
    public double P99Ms { get; init; }

    /// <summary>Which part of the queries is the search for support points: <see cref="Replay.SupportShare"/>. Null if
    /// not all shapes are meshes.</summary>
    public double? SupportShare { get; init; }

    public double BytesPerCall { get; init; }
}
