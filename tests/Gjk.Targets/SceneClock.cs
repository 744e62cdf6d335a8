using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Numerics;
using Gjk.Core;
using Gjk.Exact.Scenes;

namespace Gjk.Targets;

/// <summary>Measures nanoseconds per pair of one of the report's scenes, without warm starts. Each pass goes through
/// the whole list of pairs, and the fastest of many passes counts.</summary>
internal static class SceneClock
{
    private static readonly TimeSpan Duration = TimeSpan.FromSeconds(2);

    public static double NanosecondsPerPair(BuiltInScene scene)
    {
        ConvexShape shape = ConvexShape.Mesh((IReadOnlyList<Vector3>)scene.Vertices);
        var poses = new RigidPose[scene.Poses.Count];
        for (int i = 0; i < poses.Length; i++) poses[i] = scene.Poses[i];

        int pairs = poses.Length * (poses.Length - 1) / 2, overlapping = 0;
        long least = long.MaxValue;
        var total = Stopwatch.StartNew();
        while (total.Elapsed < Duration)
        {
            long start = Stopwatch.GetTimestamp();
            overlapping = Frame(shape, poses);
            least = Math.Min(least, Stopwatch.GetTimestamp() - start);
        }

        if (overlapping != BuiltInScenes.OverlappingPairs)
            throw new InvalidOperationException($"{scene.Name}: {overlapping} pairs overlap.");
        return least * 1e9 / Stopwatch.Frequency / pairs;
    }

    private static int Frame(in ConvexShape shape, RigidPose[] poses)
    {
        int overlapping = 0;
        for (int i = 0; i < poses.Length; i++)
        {
            for (int j = i + 1; j < poses.Length; j++)
            {
                if (ConvexQuery.Distance(shape, poses[i], shape, poses[j]).IsOverlapping) overlapping++;
            }
        }

        return overlapping;
    }
}
