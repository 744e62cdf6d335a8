using Gjk.Bench.Baseline;

namespace Gjk.Bench.Benchmarks;

/// <summary>Has each measured loop once, so that BenchmarkDotNet and the factor check time the same code. Every loop
/// runs over the whole list of pairs. It returns a sum, because the compiler might remove the work otherwise.</summary>
public static class SceneQueries
{
    public static float Distance(BenchScene scene)
    {
        ConvexShape[] shapes = scene.Shapes;
        RigidPose[] poses = scene.Poses;
        float sum = 0;
        foreach (BenchScene.Pair pair in scene.Pairs)
            sum += ConvexQuery.Distance(shapes[pair.A], poses[pair.A], shapes[pair.B], poses[pair.B]).Distance;
        return sum;
    }

    /// <summary>Distance with the warm start that each pair kept from its last call. The poses may have changed since
    /// then.</summary>
    public static float WarmDistance(BenchScene scene, RigidPose[] poses, WarmStart[] warmStarts)
    {
        ConvexShape[] shapes = scene.Shapes;
        BenchScene.Pair[] pairs = scene.Pairs;
        float sum = 0;
        for (int i = 0; i < pairs.Length; i++)
        {
            (int a, int b) = (pairs[i].A, pairs[i].B);
            sum += ConvexQuery.Distance(shapes[a], poses[a], shapes[b], poses[b], ref warmStarts[i]).Distance;
        }

        return sum;
    }

    /// <summary>How deep the pairs overlap.</summary>
    public static float Depth(BenchScene scene)
    {
        ConvexShape[] shapes = scene.Shapes;
        RigidPose[] poses = scene.Poses;
        float sum = 0;
        foreach (BenchScene.Pair pair in scene.Pairs)
            sum += ConvexQuery.SignedDistance(shapes[pair.A], poses[pair.A], shapes[pair.B], poses[pair.B]).Distance;
        return sum;
    }

    /// <summary>How deep the pairs overlap, and where they touch.</summary>
    /// <param name="scene">The pairs.</param>
    /// <param name="mostGaps">The most gap of a point, for every pair.</param>
    public static float Contacts(BenchScene scene, float[] mostGaps)
    {
        ConvexShape[] shapes = scene.Shapes;
        RigidPose[] poses = scene.Poses;
        BenchScene.Pair[] pairs = scene.Pairs;
        ContactManifold manifold = default;
        float sum = 0;
        for (int i = 0; i < pairs.Length; i++)
        {
            (int a, int b) = (pairs[i].A, pairs[i].B);
            sum += ConvexQuery.Contacts(shapes[a], poses[a], shapes[b], poses[b], mostGaps[i], out manifold).Distance;
            sum += manifold.Count;
        }

        return sum;
    }

    /// <summary>How deep the pairs overlap, with the warm start that each kept from its last call.</summary>
    public static float WarmDepth(BenchScene scene, RigidPose[] poses, WarmStart[] warmStarts)
    {
        ConvexShape[] shapes = scene.Shapes;
        BenchScene.Pair[] pairs = scene.Pairs;
        float sum = 0;
        for (int i = 0; i < pairs.Length; i++)
        {
            (int a, int b) = (pairs[i].A, pairs[i].B);
            sum += ConvexQuery.SignedDistance(shapes[a], poses[a], shapes[b], poses[b], ref warmStarts[i]).Distance;
        }

        return sum;
    }

    public static int Overlaps(BenchScene scene)
    {
        ConvexShape[] shapes = scene.Shapes;
        RigidPose[] poses = scene.Poses;
        int count = 0;
        foreach (BenchScene.Pair pair in scene.Pairs)
            if (ConvexQuery.Overlaps(shapes[pair.A], poses[pair.A], shapes[pair.B], poses[pair.B])) count++;
        return count;
    }

    /// <summary>All pairs in one call.</summary>
    public static float BatchDistance(BenchScene scene, ObjectPair[] pairs, DistanceResult[] results)
    {
        PairBatch.Distance(scene.Shapes, scene.Poses, pairs, results);
        return results[0].Distance;
    }

    /// <inheritdoc cref="BatchDistance"/>
    public static float BatchWarm(
        BenchScene scene, ObjectPair[] pairs, DistanceResult[] results, WarmStart[] warmStarts)
    {
        PairBatch.Distance(scene.Shapes, scene.Poses, pairs, results, warmStarts);
        return results[0].Distance;
    }

    /// <inheritdoc cref="BatchDistance"/>
    public static float BatchOverlaps(BenchScene scene, ObjectPair[] pairs, GjkStatus[] results)
    {
        PairBatch.Overlaps(scene.Shapes, scene.Poses, pairs, results);
        return (float)results[0];
    }

    public static float BaselineDistance(BenchScene scene)
    {
        SupportCollider[] colliders = scene.Colliders;
        float sum = 0;
        foreach (BenchScene.Pair pair in scene.Pairs)
            sum += ReportGjk.Distance(colliders[pair.A], colliders[pair.B]).Distance;
        return sum;
    }

    public static int BaselineOverlaps(BenchScene scene)
    {
        SupportCollider[] colliders = scene.Colliders;
        int count = 0;
        foreach (BenchScene.Pair pair in scene.Pairs)
            if (ReportGjk.Intersects(colliders[pair.A], colliders[pair.B])) count++;
        return count;
    }
}
