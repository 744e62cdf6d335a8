using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Gjk.Core;

namespace PartClearance;

/// <summary>Two parts by their places in the list, and their distance, or minus the depth of two convex ones.</summary>
internal readonly record struct Gap(ObjectPair Pair, DistanceResult Result);

/// <summary>Finds all pairs of parts that are within a distance of each other.</summary>
internal static class Clearance
{
    /// <summary>Pairs between two reports of the progress.</summary>
    private const int ChunkLength = 1024;

    public static List<Gap> Find(
        IReadOnlyList<Part> parts, float within, Action<int, int> progress, CancellationToken cancel)
    {
        AnyShape[] shapes = [.. parts.Select(p => p.Shape)];
        RigidPose[] poses = [.. parts.Select(p => p.Pose)];

        // The broad phase finds the pairs whose bounding boxes are near enough; few pairs are left of n (n - 1) / 2.
        var scene = new CollisionScene();
        foreach (Part part in parts) scene.Add(part.Shape, part.Pose);
        var candidates = new List<ObjectPair>();
        scene.CollectCandidates(candidates, within);

        var gaps = new List<Gap>();
        var results = new PairDistance[ChunkLength];
        var scratch = new ConcaveScratch();
        using var workers = new Workers();
        int done = 0;
        foreach (ObjectPair[] chunk in candidates.Chunk(ChunkLength))
        {
            PairBatch.Distance(
                shapes, poses, chunk, results, scratch, maxDistance: within, workers: workers, cancellation: cancel);
            for (int i = 0; i < chunk.Length; i++)
            {
                (int a, int b) = (chunk[i].A, chunk[i].B);
                if (results[i].Status == GjkStatus.BeyondMaxDistance) continue;
                gaps.Add(new Gap(chunk[i], results[i].IsOverlapping
                    ? ConcaveQuery.SignedDistance(shapes[a], poses[a], shapes[b], poses[b], scratch).Result
                    : results[i].Result));
            }

            done += chunk.Length;
            progress(done, candidates.Count);
        }

        return gaps;
    }
}
