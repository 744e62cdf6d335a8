namespace Gjk.Core;

public static partial class ConcaveQuery
{
    /// <summary>Where two shapes touch: up to four points for each pair of parts in reach, without those at seams that
    /// a surface does not have.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="maxGap">Points and parts further apart are left out, in world units; below 0 counts as 0, and NaN
    /// is invalid.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="contacts">Cleared, then the contacts by the numbers of the parts: what
    /// <c>ConvexQuery.Contacts</c> says of two parts no further apart, if both bodies end there; of a compound's part
    /// the points where the compound ends. Where a surface, solid or compound goes on, as at flat and concave edges,
    /// under doubled triangles and between flush parts, the contact is along a face that is there instead, with all
    /// points that are over it, if no other contact pushes the two parts apart. A pair of parts has one contact. At a
    /// convex edge each triangle has the contact; an edge of three triangles or more counts as all of them show it. An
    /// open surface has two sides; a solid pushes outward only. Of parts that overlap each pair has a contact, or the
    /// push of another one takes it apart, but for a few of a solid that is in the other shape at several places. A
    /// manifold's first point is its deepest. On a half-space each part in reach has its contact. The pair (B, A)
    /// has the contacts of (A, B), exchanged, to the last bit, but where the two are of one size in the very same
    /// pose.</param>
    /// <returns>False when the input is invalid.</returns>
    public static bool FindContacts(
        in AnyShape a, in RigidPose poseA, in AnyShape b, in RigidPose poseB, float maxGap, ConcaveScratch scratch,
        List<PairContacts> contacts)
    {
        if (contacts is null) return false;
        contacts.Clear();
        if (scratch is null) return false;
        if (!PairOrder.IsExchanged(SizeOf(a), RankOf(a), poseA, SizeOf(b), RankOf(b), poseB))
            return FindInOrder(a, poseA, b, poseB, maxGap, scratch, contacts);
        bool isValid = FindInOrder(b, poseB, a, poseA, maxGap, scratch, contacts);
        for (int i = 0; i < contacts.Count; i++) contacts[i] = contacts[i].Swapped;
        InPlaceSort.Sort(contacts);
        return isValid;
    }

    private static double SizeOf(in AnyShape shape) =>
        shape.Mesh?.Tree.Radius ?? shape.Compound?.Tree.Radius ?? AnyShape.ConvexOf(shape).BoundingRadius;

    private static double RankOf(in AnyShape shape) => shape.Kind == AnyShapeKind.Convex
        ? AnyShape.ConvexOf(shape).Margin
        : (double)shape.PartCount * (int)shape.Kind;

    private static bool FindInOrder(
        in AnyShape a, in RigidPose poseA, in AnyShape b, in RigidPose poseB, float maxGap, ConcaveScratch scratch,
        List<PairContacts> contacts)
    {
        List<PairDistance> pairs = scratch.Pairs;
        if (!FindPairsWithin(a, poseA, b, poseB, maxGap, scratch, pairs)) return false;
        if (scratch.A.IsEndless || scratch.B.IsEndless)
        {
            foreach (PairDistance pair in pairs) AddHalfSpaceContact(scratch, pair, maxGap, contacts);
            return true;
        }

        FindPairContacts(scratch, maxGap, maxGap, contacts);
        float deepest = DeepFaces.FindGap(scratch, contacts, maxGap);
        if (!(deepest > maxGap)) return true;
        FindPairsWithin(a, poseA, b, poseB, deepest, scratch, pairs);
        FindPairContacts(scratch, deepest, maxGap, contacts);
        DeepFaces.RemoveBeyond(contacts, maxGap);
        return true;
    }

    /// <summary>Finds the contacts of the scratch's pairs: those of two shapes, or of a body and the static objects
    /// that it touches, which count as one.</summary>
    /// <param name="scratch">With both sides and the pairs.</param>
    /// <param name="gap">World units: how far apart the parts of the pairs are at most.</param>
    /// <param name="near">Pairs that are further apart than this count only with their faces on each other.</param>
    /// <param name="contacts">Cleared, then the contacts.</param>
    internal static void FindPairContacts(
        ConcaveScratch scratch, float gap, float near, List<PairContacts> contacts)
    {
        List<PairDistance> pairs = scratch.Pairs;
        contacts.Clear();
        scratch.FaceContacts.Clear();
        scratch.Orphans.Clear();
        scratch.Searched = 0;
        scratch.AtPoint.Clear();
        scratch.AreAnyTouching = false;
        foreach (PairDistance pair in pairs) scratch.AreAnyTouching |= !(pair.Result.Distance > 0);
        for (int i = 0; i < pairs.Count; i++)
        {
            if (pairs[i].Result.Distance > near && !DeepFaces.AreLevel(scratch, pairs[i])) continue;
            SeamContacts.Find(scratch, pairs[i], gap, contacts);
        }

        SeamContacts.RemoveCovered(scratch, gap, contacts);
        if (scratch.A.MayHoldParts || scratch.B.MayHoldParts) ContactPush.RemoveNeedless(scratch, contacts);
        ContactPush.AddNeeded(scratch, contacts);
        TouchLine.RemoveBeside(scratch, contacts);
    }

    /// <summary>Adds a pair's contact with a half-space. That pushes every part along its normal, so no seam
    /// shows.</summary>
    private static void AddHalfSpaceContact(
        ConcaveScratch scratch, in PairDistance pair, float maxGap, List<PairContacts> contacts)
    {
        ConvexShape roomA = default, roomB = default;
        DistanceResult found = ConvexQuery.Contacts(
            scratch.A.ShapeOf(pair.PartA, ref roomA), scratch.A.Pose, scratch.B.ShapeOf(pair.PartB, ref roomB),
            scratch.B.Pose, maxGap, out ContactManifold manifold);
        if (manifold.Count == 0) return;
        DeepestPoint.MoveToFront(ref manifold);
        contacts.Add(new PairContacts(pair.PartA, pair.PartB, found, manifold));
    }
}
