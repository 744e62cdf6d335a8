namespace Gjk.Core;

/// <summary>The order in which the contacts of two bodies are found, whichever of them is A: so the exchanged pair has
/// the same contacts, exchanged, to the last bit.</summary>
/// <remarks>The larger body is first, and of equals the one that is behind along a fixed direction: what rests, or
/// moves a little, keeps its order. Only shapes of one size and margin in the same pose have none.</remarks>
internal static class PairOrder
{
    /// <summary>Along which equals are ordered: 1.2 degrees or more from across any direction of whole numbers up to 3,
    /// so that stacks, rows and grids whose bodies shiver are not near an exchange.</summary>
    private const double AlongX = 0.47, AlongY = 0.61, AlongZ = 0.64;

    /// <summary>Whether B is first.</summary>
    public static bool IsExchanged<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        IsExchanged(a.BoundingRadius, a.Margin, poseA, b.BoundingRadius, b.Margin, poseB);

    /// <summary>The same of bodies of any kind, by two numbers that tell shapes apart.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsExchanged(
        double sizeA, double marginA, in RigidPose poseA, double sizeB, double marginB, in RigidPose poseB) =>
        sizeA != sizeB ? sizeA < sizeB
        : marginA != marginB ? marginA < marginB
        : IsBehind(poseB, poseA);

    private static bool IsBehind(in RigidPose one, in RigidPose other)
    {
        double ahead = AlongX * ((double)other.Position.X - one.Position.X)
            + AlongY * ((double)other.Position.Y - one.Position.Y)
            + AlongZ * ((double)other.Position.Z - one.Position.Z);
        return ahead != 0 ? ahead > 0 : IsLess(one.Rotation, other.Rotation);
    }

    private static bool IsLess(Quaternion one, Quaternion other) => one.X != other.X ? one.X < other.X
        : one.Y != other.Y ? one.Y < other.Y
        : one.Z != other.Z ? one.Z < other.Z
        : one.W < other.W;
}
