namespace Gjk.Core;

/// <summary>Replaces contacts that push into a solid of a compound, which pushes outward only. Where the shortest way
/// out of one of its triangles leads inward, the way along that triangle's face may replace it, if nothing else
/// pushes.</summary>
internal static class OutwardContact
{
    /// <summary>Replaces the contact of two parts if it pushes into a solid.</summary>
    /// <param name="scratch">Gets the contact that may replace it.</param>
    /// <param name="own">The contact.</param>
    /// <param name="normal">Its normal before rounding.</param>
    /// <param name="maxGap">In world units.</param>
    /// <returns>False where it pushes outward, or is of no solid's triangle.</returns>
    public static bool TryReplace(ConcaveScratch scratch, in PairContacts own, in Double3 normal, float maxGap)
    {
        bool isOfA = IsInward(scratch.A, own.PartA, normal, out Double3 outward);
        if (!isOfA && !IsInward(scratch.B, own.PartB, -normal, out outward)) return false;
        PairContacts held = own;

        // A part that is behind a triangle and apart from it touches nothing there.
        if (own.Result.Distance <= 0 && CoveredSides.TryReplaceAlong(scratch, isOfA, ref held, maxGap, outward))
            scratch.FaceContacts.Add(new FaceContact(held, own, isOfA));
        return true;
    }

    private static bool IsInward(PartSide side, int part, in Double3 normal, out Double3 outward)
    {
        outward = default;
        return side.Compound is not null && side.TryGetOutward(part, out outward, out _)
            && Double3.Dot(outward, normal) < -ContactCone.Slack;
    }
}
