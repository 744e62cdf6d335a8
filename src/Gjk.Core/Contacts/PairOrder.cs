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
        where TB : struct, ISupportMap
    {
        double sizeA = a.BoundingRadius, sizeB = b.BoundingRadius;
        if (sizeA != sizeB) return sizeA < sizeB;
        double marginA = a.Margin, marginB = b.Margin;
        return marginA != marginB ? marginA < marginB : IsBehind(poseB, poseA);
    }

    /// <inheritdoc cref="IsExchanged{TA, TB}"/>
    public static bool IsExchanged(in AnyShape a, in RigidPose poseA, in AnyShape b, in RigidPose poseB)
    {
        double sizeA = SizeOf(a), sizeB = SizeOf(b);
        if (sizeA != sizeB) return sizeA < sizeB;
        double rankA = RankOf(a), rankB = RankOf(b);
        return rankA != rankB ? rankA < rankB : IsBehind(poseB, poseA);
    }

    private static double SizeOf(in AnyShape shape) =>
        shape.Mesh?.Tree.Radius ?? shape.Compound?.Tree.Radius ?? AnyShape.ConvexOf(shape).BoundingRadius;

    private static double RankOf(in AnyShape shape) => shape.Kind == AnyShapeKind.Convex
        ? AnyShape.ConvexOf(shape).Margin
        : (double)shape.PartCount * (int)shape.Kind;

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
