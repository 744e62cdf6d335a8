using System.Numerics;
using Gjk.Core;

namespace Gjk.Demo.Fuzz.Promises;

/// <summary>A warm start, whatever it remembers, changes the answer by no more than the accuracy: its own, that of a moved pair, and those of quite other shapes.</summary>
internal sealed class WarmStartsChangeNothing : IPromise
{
    private readonly WarmStart[] _foreign = RememberOthers();

    public string Name => "a warm start changes nothing";

    public string? Broken(FuzzPair pair)
    {
        var warm = default(WarmStart);
        return Problem(pair, ref warm, "first, empty")
            ?? Problem(pair, ref warm, "its own")
            ?? Problem(pair, ref warm, "its own again")
            ?? Stale(pair)
            ?? Foreign(pair);
    }

    /// <summary>Remembered when B was elsewhere: nearby, turned, through A's centre, and on the other side.</summary>
    private static string? Stale(FuzzPair pair)
    {
        Vector3 between = pair.PoseB.Position - pair.PoseA.Position, step = new((float)(0.01 * pair.Scale));
        foreach (Vector3 position in (System.ReadOnlySpan<Vector3>)[pair.PoseB.Position + step, pair.PoseA.Position, pair.PoseA.Position - between, pair.PoseB.Position + between])
        {
            if (!float.IsFinite(position.X + position.Y + position.Z)) continue;
            var warm = default(WarmStart);
            ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, new RigidPose(Quaternion.Conjugate(pair.PoseB.Rotation), position), ref warm);
            string? problem = Problem(pair, ref warm, Say.Line($"from when B was at {position}"));
            if (problem is not null) return problem;
        }

        return null;
    }

    private string? Foreign(FuzzPair pair)
    {
        for (int i = 0; i < _foreign.Length; i++)
        {
            WarmStart warm = _foreign[i];
            string? problem = Problem(pair, ref warm, Say.Line($"foreign {i}"));
            if (problem is not null) return problem;
        }

        return null;
    }

    private static string? Problem(FuzzPair pair, ref WarmStart warm, string name) =>
        Same.Problem(pair, ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, ref warm), name);

    private static WarmStart[] RememberOthers()
    {
        var random = new FuzzRandom(2);
        var cloud = new Vector3[40];
        for (int i = 0; i < cloud.Length; i++) cloud[i] = random.Vector(1);
        ConvexShape[] shapes =
        [
            ConvexShape.Mesh(cloud), ConvexShape.Box(new Vector3(1, 2, 3)), ConvexShape.Segment(new Vector3(-1, 0, 0), new Vector3(1, 0, 0)), ConvexShape.Cone(1, 1), ConvexShape.Sphere(1),
        ];
        var memories = new WarmStart[shapes.Length * 2];
        for (int i = 0; i < memories.Length; i++)
        {
            var pose = new RigidPose(Rotations.Even(random), i % 2 == 0 ? new Vector3(0.1f, 0.2f, -0.1f) : new Vector3(4, 1, -2));
            ConvexQuery.Distance(shapes[i / 2], RigidPose.Identity, shapes[(i / 2 + i % 2) % shapes.Length], pose, ref memories[i]);
        }

        return memories;
    }
}
