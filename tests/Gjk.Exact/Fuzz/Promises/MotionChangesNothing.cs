namespace Gjk.Exact.Fuzz.Promises;

/// <summary>Moving both shapes alike changes nothing: half turns about the axes, which are exact in floats, and shifts
/// where the sums are.</summary>
internal static class MotionChangesNothing
{
    public static string? Broken(FuzzPair pair) => Turned(pair) ?? Shifted(pair);

    private static string? Turned(FuzzPair pair)
    {
        for (int axis = 0; axis < 3; axis++)
        {
            DistanceResult r = ConvexQuery.Distance(
                pair.A, HalfTurn(pair.PoseA, axis), pair.B, HalfTurn(pair.PoseB, axis));
            string? problem = Same.Problem(pair, r, Say.Line($"half a turn about axis {axis}"));
            if (problem is not null) return problem;
        }

        return null;
    }

    private static string? Shifted(FuzzPair pair)
    {
        // B's place becomes A's neighbourhood: the sums are often exact, and never by accident only for small numbers.
        ReadOnlySpan<Vector3> shifts = [-pair.PoseA.Position, -pair.PoseB.Position, new(1024, -2048, 512)];
        foreach (Vector3 shift in shifts)
        {
            if (!TryShift(pair.PoseA, shift, out RigidPose a) || !TryShift(pair.PoseB, shift, out RigidPose b))
                continue;
            string? problem = Same.Problem(
                pair, ConvexQuery.Distance(pair.A, a, pair.B, b), Say.Line($"shifted by {shift}"));
            if (problem is not null) return problem;
        }

        return null;
    }

    /// <summary>The product of the axis's unit quaternion with the pose's: its components, exchanged, some
    /// negated.</summary>
    private static RigidPose HalfTurn(in RigidPose pose, int axis)
    {
        Quaternion q = pose.Rotation;
        Vector3 p = pose.Position;
        return axis switch
        {
            0 => new(new Quaternion(q.W, -q.Z, q.Y, -q.X), new Vector3(p.X, -p.Y, -p.Z)),
            1 => new(new Quaternion(q.Z, q.W, -q.X, -q.Y), new Vector3(-p.X, p.Y, -p.Z)),
            _ => new(new Quaternion(-q.Y, q.X, q.W, -q.Z), new Vector3(-p.X, -p.Y, p.Z)),
        };
    }

    private static bool TryShift(in RigidPose pose, Vector3 by, out RigidPose shifted)
    {
        bool exact = ExactSums.TryAdd(pose.Position, by, out Vector3 sum);
        shifted = exact ? new RigidPose(pose.Rotation, sum) : pose;
        return exact;
    }
}
