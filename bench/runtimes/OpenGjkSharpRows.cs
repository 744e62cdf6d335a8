using Gjk.Bench.Table;
using OpenGJKSharp;
using OpenGJKSharp.Models;

namespace Gjk.Bench.Runtimes;

/// <summary>OpenGJKSharp on the same pairs: the algorithm of openGJK in C#. It gets corners that are in the world
/// already, in its own structure, so nothing is turned, copied or checked but by its query.</summary>
internal static class OpenGjkSharpRows
{
    /// <summary>Ratio to the objects' size: an answer that is off by more is wrong.</summary>
    private const double Wrong = 1e-5;

    public static (string Name, TimedLoop Loop) Row(string name, BenchScene scene, Vector3[] corners)
    {
        GkPolytope[] bodies = [.. scene.Poses.Select(pose => Body(pose, corners))];
        double size = corners.Max(c => (double)c.Length());
        int wrong = scene.Pairs.Count(p => !(Math.Abs(
            OpenGjk.ComputeMinimumDistance(bodies[p.A], bodies[p.B]) - Right(scene, p)) <= Wrong * size));
        return ($"{name} OpenGJKSharp ({wrong} of {scene.Pairs.Length} wrong)", new TimedLoop(scene.Pairs.Length, () =>
        {
            double sum = 0;
            foreach (BenchScene.Pair p in scene.Pairs)
                sum += OpenGjk.ComputeMinimumDistance(bodies[p.A], bodies[p.B]);
            return (float)sum;
        }));
    }

    private static double Right(BenchScene scene, BenchScene.Pair p) =>
        ConvexQuery.Distance(scene.Shapes[p.A], scene.Poses[p.A], scene.Shapes[p.B], scene.Poses[p.B]).Distance;

    private static GkPolytope Body(RigidPose pose, Vector3[] corners)
    {
        Vector3[] placed = [.. corners.Distinct().Select(pose.TransformPoint)];
        double[][] coordinates = [.. placed.Select(c => new double[] { c.X, c.Y, c.Z })];
        return new GkPolytope { NumPoints = placed.Length, Coord = coordinates };
    }
}
