using System.Runtime.InteropServices;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>A warm start, whatever it remembers, changes the answer by no more than the accuracy: its own, that of a
/// moved pair, and those of quite other shapes.</summary>
internal static class WarmStartsChangeNothing
{
    private static readonly WarmStart[] BytePatterns = MakeBytePatterns();

    private static readonly WarmStart[] Memories = RememberOthers();

    public static string? Broken(FuzzPair pair)
    {
        var warm = default(WarmStart);
        return Problem(pair, ref warm, "first, empty")
            ?? Problem(pair, ref warm, "its own")
            ?? Problem(pair, ref warm, "its own again")
            ?? Stale(pair)
            ?? Foreign(pair)
            ?? AnyBytes(pair);
    }

    /// <summary>Remembered when B was elsewhere: nearby, turned, through A's centre, and on the other side.</summary>
    private static string? Stale(FuzzPair pair)
    {
        Vector3 between = pair.PoseB.Position - pair.PoseA.Position, step = new((float)(0.01 * pair.Scale));
        Vector3 a = pair.PoseA.Position, b = pair.PoseB.Position;
        foreach (Vector3 position in (ReadOnlySpan<Vector3>)[b + step, a, a - between, b + between])
        {
            if (!float.IsFinite(position.X + position.Y + position.Z)) continue;
            var warm = default(WarmStart);
            ConvexQuery.Distance(
                pair.A, pair.PoseA, pair.B, new RigidPose(Quaternion.Conjugate(pair.PoseB.Rotation), position),
                ref warm);
            string? problem = Problem(pair, ref warm, Say.Line($"from when B was at {position}"));
            if (problem is not null) return problem;
        }

        return null;
    }

    private static string? Foreign(FuzzPair pair)
    {
        for (int i = 0; i < Memories.Length; i++)
        {
            WarmStart warm = Memories[i];
            string? problem = Problem(pair, ref warm, Say.Line($"foreign {i}"));
            if (problem is not null) return problem;
        }

        return null;
    }

    /// <summary>Memory that no query wrote: a guess like any other. What the query leaves in it must be one,
    /// too.</summary>
    private static string? AnyBytes(FuzzPair pair)
    {
        for (int i = 0; i < BytePatterns.Length; i++)
        {
            WarmStart warm = BytePatterns[i];
            string? problem = Problem(pair, ref warm, Say.Line($"bytes {i}"))
                ?? Problem(pair, ref warm, Say.Line($"left by bytes {i}"));
            if (problem is not null) return problem;
        }

        return null;
    }

    private static string? Problem(FuzzPair pair, ref WarmStart warm, string name) =>
        Same.Problem(pair, ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, ref warm), name);

    /// <summary>Words of one value each, small whole numbers, least floats, infinities and NaN among them, and words at
    /// random.</summary>
    private static WarmStart[] MakeBytePatterns()
    {
        int[] words = [-1, 1, 4, 0x00000007, 0x7F800000, 0x7FC00000, 0x7F7FFFFF];
        var random = new Rng(3);
        var patterns = new WarmStart[words.Length + 3];
        for (int i = 0; i < patterns.Length; i++)
        {
            Span<int> bytes = MemoryMarshal.Cast<WarmStart, int>(patterns.AsSpan(i, 1));
            for (int k = 0; k < bytes.Length; k++)
                bytes[k] = i < words.Length || random.OneIn(3) ? words[i % words.Length] : random.Below(12);

            // With a count that is taken, the ids after it are, too.
            if (i >= words.Length) bytes[0] = random.Below(6);
        }

        return patterns;
    }

    private static WarmStart[] RememberOthers()
    {
        var random = new Rng(2);
        var cloud = new Vector3[40];
        for (int i = 0; i < cloud.Length; i++) cloud[i] = random.Vector(1);
        ConvexShape[] shapes =
        [
            ConvexShape.Mesh(cloud), ConvexShape.Box(new Vector3(1, 2, 3)),
            ConvexShape.Segment(
                new Vector3(-1, 0, 0), new Vector3(1, 0, 0)), ConvexShape.Cone(1, 1), ConvexShape.Sphere(1),
        ];
        var memories = new WarmStart[shapes.Length * 2];
        for (int i = 0; i < memories.Length; i++)
        {
            var pose = new RigidPose(
                random.Rotation(), i % 2 == 0 ? new Vector3(0.1f, 0.2f, -0.1f) : new Vector3(4, 1, -2));
            ConvexQuery.Distance(
                shapes[i / 2], RigidPose.Identity, shapes[(i / 2 + i % 2) % shapes.Length], pose, ref memories[i]);
        }

        return memories;
    }
}
