namespace Gjk.Core;

/// <summary>The checks that constructors share; each throws with the name of the argument it refuses.</summary>
internal static class Guard
{
    public static bool IsFinite(float x) => x - x == 0;

    public static bool IsFinite(double x) => x - x == 0;

    public static bool IsFinite(in Vector3 v) => v.X - v.X + (v.Y - v.Y) + (v.Z - v.Z) == 0;

    public static Vector3 Finite(Vector3 v, string name) =>
        IsFinite(v) ? v : throw new ArgumentOutOfRangeException(name, v, "Every component must be finite.");

    public static float Finite(float x, string name) =>
        IsFinite(x) ? x : throw new ArgumentOutOfRangeException(name, x, "Must be finite.");

    public static float NonNegative(float x, string name) =>
        IsFinite(x) && x >= 0 ? x : throw new ArgumentOutOfRangeException(name, x, "Must be finite and not negative.");

    public static float NonNegativeOrInfinite(float x, string name) =>
        x >= 0 ? x : throw new ArgumentOutOfRangeException(name, x, "Must not be negative or NaN.");

    public static float NotNaN(float x, string name) =>
        !float.IsNaN(x) ? x : throw new ArgumentOutOfRangeException(name, x, "Must not be NaN.");

    public static Vector3 NonNegative(Vector3 v, string name) =>
        IsFinite(v) && v.X >= 0 && v.Y >= 0 && v.Z >= 0
            ? v
            : throw new ArgumentOutOfRangeException(name, v, "Every component must be finite and not negative.");

    public static Vector3 Scale(Vector3 v, string name) =>
        IsFinite(v) && v.X != 0 && v.Y != 0 && v.Z != 0
            ? v
            : throw new ArgumentOutOfRangeException(name, v, "Every component must be finite and not zero.");

    public static RigidPose Pose(in RigidPose pose, string name) =>
        pose.IsValid
            ? pose
            : throw new ArgumentOutOfRangeException(
                name, pose, "A default RigidPose has no rotation; use RigidPose.Identity.");

    /// <summary>An index from 0 to the count - 1.</summary>
    /// <param name="index">The caller's index.</param>
    /// <param name="count">How many there are.</param>
    /// <param name="name">The caller's parameter.</param>
    /// <param name="what">What is counted, for the message.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Index(int index, int count, string name, string what) =>
        (uint)index < (uint)count ? index : throw NoSuch(index, name, what);

    private static ArgumentOutOfRangeException NoSuch(int index, string name, string what) =>
        new(name, index, $"There is no such {what}.");

    public static T NotNull<T>(T? value, string name) where T : class =>
        value ?? throw new ArgumentNullException(name);
}
