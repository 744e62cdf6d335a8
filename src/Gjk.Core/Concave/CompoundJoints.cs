namespace Gjk.Core;

/// <summary>Where convex parts are flush or in each other, a contact with one of them may be at a face that another one
/// covers: their union does not end there.</summary>
internal static class CompoundJoints
{
    /// <summary>Ratio to lengths: 2^-18, some roundings of the places of two parts. Less makes a kerb of a seam between
    /// parts whose places are rounded.</summary>
    public const double Room = 4 * ContactCone.Slack;

    /// <summary>Whether another part of a compound covers the witness of a pair. Such a part is among the pairs, as it
    /// is as near.</summary>
    /// <param name="scratch">With the pairs.</param>
    /// <param name="isA">Whether the compound is A.</param>
    /// <param name="pair">The two parts.</param>
    /// <param name="result">What was found of them.</param>
    /// <param name="outward">From the compound to the other shape, in the world.</param>
    public static bool Covers(
        ConcaveScratch scratch, bool isA, in PartDistance pair, in DistanceResult result, in Double3 outward)
    {
        PartSide side = isA ? scratch.A : scratch.B;
        if (side.Compound is null) return false;
        Double3 direction = new RotationD(side.Pose.Rotation).InverseRotate(outward);
        Double3 witness = isA ? result.LocalPointA : result.LocalPointB;
        int own = isA ? pair.PartA : pair.PartB, other = isA ? pair.PartB : pair.PartA;
        foreach (PartDistance near in scratch.Pairs)
        {
            int part = isA ? near.PartA : near.PartB;
            if (part == own || (isA ? near.PartB : near.PartA) != other) continue;
            if (GoesOn(side.Compound.Parts[part], witness, direction)) return true;
        }

        return false;
    }

    /// <summary>Whether a shape holds a point and reaches beyond it.</summary>
    public static bool GoesOn(in ConvexShape shape, in Double3 point, in Double3 direction)
    {
        shape.Support(direction, out Double3 most);
        Double3 to = shape.Center + most + direction * shape.Margin - point;
        double length = to.Length;
        if (!(Double3.Dot(to, direction) > 2 * Room * length)) return false;
        float near = ConvexQuery.Distance(shape, RigidPose.Identity, (Vector3)point, (float)length).Distance;
        return near <= Room * (length + point.Length);
    }
}
