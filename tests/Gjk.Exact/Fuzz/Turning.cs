namespace Gjk.Exact.Fuzz;

/// <summary>How a pair turns while it moves. The rates follow from the pair's own numbers, so that a pair that is read
/// from a record turns as it did when it was found.</summary>
internal readonly struct Turning
{
    private const ulong Golden = 0x9E3779B97F4A7C15;

    /// <summary>The motions of the pair: its own velocities, and turns of up to ten times a full one.</summary>
    public static (RigidMotion A, RigidMotion B) Of(FuzzPair pair)
    {
        ulong state = Mix(Mix(Bits(pair.PoseA.Position), pair.PoseB.Position), pair.Motion.B - pair.Motion.A);
        float most = (Next(ref state) & 3) switch { 0 => 0.5f, 1 => 3, 2 => 12, _ => 63 };
        Vector3 rateA = Vector(ref state, most), rateB = Vector(ref state, most);
        if ((Next(ref state) & 1) == 0) rateA = default;
        return (
            new RigidMotion(pair.PoseA, pair.Motion.A, rateA), new RigidMotion(pair.PoseB, pair.Motion.B, rateB));
    }

    /// <summary>Where a body is at a fraction, rounded to float.</summary>
    public static RigidPose At(in RigidMotion motion, double fraction)
    {
        var rate = (Double3)motion.AngularVelocity;
        double speed = rate.Length, half = 0.5 * speed * fraction;
        Double3 v = speed > 0 ? rate * (Math.Sin(half) / speed) : default;
        double w = Math.Cos(half);
        Quaternion q = motion.Pose.Rotation;
        var turned = new Quaternion(
            (float)(w * q.X + v.X * q.W + v.Y * q.Z - v.Z * q.Y),
            (float)(w * q.Y + v.Y * q.W + v.Z * q.X - v.X * q.Z),
            (float)(w * q.Z + v.Z * q.W + v.X * q.Y - v.Y * q.X),
            (float)(w * q.W - v.X * q.X - v.Y * q.Y - v.Z * q.Z));
        return new RigidPose(
            turned, (Vector3)((Double3)motion.Pose.Position + (Double3)motion.Velocity * fraction));
    }

    private static ulong Bits(Vector3 v) => Mix(1, v);

    private static ulong Mix(ulong state, Vector3 v)
    {
        foreach (float x in new[] { v.X, v.Y, v.Z })
            state = (state ^ (uint)BitConverter.SingleToInt32Bits(x)) * Golden + 1;
        return state;
    }

    private static ulong Next(ref ulong state)
    {
        state += Golden;
        ulong x = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9;
        return (x ^ (x >> 27)) >> 16;
    }

    private static Vector3 Vector(ref ulong state, float most) =>
        new(Number(ref state, most), Number(ref state, most), Number(ref state, most));

    private static float Number(ref ulong state, float most) =>
        most * ((Next(ref state) & 0xFFFF) / 32768f - 1);
}
