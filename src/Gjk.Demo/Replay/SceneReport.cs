using System;
using Gjk.Core;

namespace Gjk.Demo.Replay;

/// <summary>The result of replaying one scene: the answers, which are the same in every frame, and the times.</summary>
internal sealed class SceneReport
{
    public SceneReport(
        BuiltInScene scene, int hullVertices, ReadOnlySpan<int> a, ReadOnlySpan<int> b, DistanceResult[] results)
    {
        Name = scene.Name;
        ObjectNames = [.. scene.ObjectNames];
        VerticesPerObject = scene.Vertices.Count;
        HullVertices = hullVertices;
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

    /// <summary>Vertices in the mesh as given.</summary>
    public int VerticesPerObject { get; }

    /// <summary>Vertices after deduplication.</summary>
    public int HullVertices { get; }

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

    /// <summary>Which part of the queries is the search for support points: <see cref="SupportReplay"/>.</summary>
    public double SupportShare { get; init; }

    public double BytesPerCall { get; init; }
}
