using Gjk.Bench.Scenes;
using Gjk.Core;

namespace Gjk.Bench.Worst;

/// <summary>Measures distances between two copies of a hull, and finds the slowest query.</summary>
internal static class QueryClock
{
    private const ulong Seed = 43;

    /// <summary>Samples per placement. The fastest one counts.</summary>
    private const int Samples = 5;

    private const int RandomPlacements = 30;

    /// <summary>Gaps between parallel hulls, in units of the hull's size along that axis.</summary>
    private static readonly float[] Gaps = [1e-6f, 1e-3f, 0.1f, 1];

    public static QueryCost Slowest(ConvexHull hull)
    {
        var mesh = new ConvexMesh(hull);
        var slowest = new QueryCost(0, "", 0);
        foreach ((string name, RigidPose a, RigidPose b) in Placements(hull))
        {
            double best = double.PositiveInfinity;
            DistanceResult result = default;
            for (int sample = 0; sample < Samples; sample++)
            {
                long start = Stopwatch.GetTimestamp();
                result = ConvexQuery.Distance(mesh, a, mesh, b);
                best = Math.Min(best, Stopwatch.GetElapsedTime(start).TotalMicroseconds);
            }

            if (best > slowest.Microseconds) slowest = new QueryCost(best, name, result.Iterations);
        }

        return slowest;
    }

    private static IEnumerable<(string Name, RigidPose A, RigidPose B)> Placements(ConvexHull hull)
    {
        Vector3 size = hull.Bounds.Max - hull.Bounds.Min;
        var prng = new Prng(Seed);
        Quaternion turn = prng.Rotation();
        foreach (Vector3 axis in new[] { Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ })
        {
            yield return ("touching", RigidPose.Identity, new RigidPose(axis * size));
            foreach (float gap in Gaps)
            {
                Vector3 offset = (1 + gap) * size * axis;
                yield return ("parallel", RigidPose.Identity, new RigidPose(offset));
                var turnedA = new RigidPose(turn, Vector3.Zero);
                yield return ("parallel, turned", turnedA, new RigidPose(turn, Vector3.Transform(offset, turn)));
                yield return ("opposite", RigidPose.Identity, new RigidPose(Half(axis), offset));
            }
        }

        for (int i = 0; i < RandomPlacements; i++)
        {
            float distance = (float)hull.BoundingRadius * prng.Range(0.5f, 3);
            var a = new RigidPose(prng.Rotation(), Vector3.Zero);
            yield return ("random", a, new RigidPose(prng.Rotation(), distance * prng.Direction()));
        }
    }

    /// <summary>A half turn about another axis, so that the same end of each hull faces the other hull.</summary>
    private static Quaternion Half(Vector3 axis) =>
        axis.Z == 0 ? new Quaternion(0, 0, 1, 0) : new Quaternion(1, 0, 0, 0);
}
