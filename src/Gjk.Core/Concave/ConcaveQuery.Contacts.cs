namespace Gjk.Core;

public static partial class ConcaveQuery
{
    /// <summary>Where two shapes touch: up to four points for each pair of parts in reach, without those at seams that
    /// a surface does not have.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="maxGap">Points and parts further apart are left out, in world units; at least 0, and less counts as
    /// 0.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="contacts">Cleared, then the contacts by the numbers of the parts: what
    /// <c>ConvexQuery.Contacts</c> says of two parts no further apart, if both bodies end there. Where a surface, solid
    /// or compound goes on, as at flat and concave edges, under doubled triangles and between flush parts, a triangle's
    /// face takes the contact's place, if the body's furthest point lies behind it and no other contact pushes the two
    /// parts apart. At a convex edge each triangle has the contact; an edge of three triangles or more counts as all of
    /// them show it. An open surface has two sides; a solid pushes outward only. Of parts that overlap each pair has a
    /// contact, or the push of another one takes it apart. A manifold's first point is its deepest.</param>
    /// <returns>False when the input is invalid.</returns>
    public static bool FindContacts(
        in AnyShape a, in RigidPose poseA, in AnyShape b, in RigidPose poseB, float maxGap, ConcaveScratch scratch,
        List<PartContacts> contacts)
    {
        if (contacts is null) return false;
        contacts.Clear();
        if (scratch is null) return false;
        List<PartDistance> pairs = scratch.Pairs;
        if (!FindPairsWithin(a, poseA, b, poseB, maxGap, scratch, pairs)) return false;
        scratch.FaceContacts.Clear();
        scratch.Orphans.Clear();
        for (int i = 0; i < pairs.Count; i++) SeamContacts.Find(scratch, pairs[i], maxGap, contacts);
        if (scratch.A.MayHoldParts || scratch.B.MayHoldParts) ContactPush.RemoveNeedless(scratch, contacts);
        int own = contacts.Count;
        AddFaces(scratch, contacts);
        AddOrphans(scratch, contacts);
        if (contacts.Count > own) InPlaceSort.Sort(contacts);
        return true;
    }

    /// <summary>Adds the contacts of faces that are needed beside those that are there: the shallowest first, as only
    /// what is less deep makes one needless.</summary>
    private static void AddFaces(ConcaveScratch scratch, List<PartContacts> contacts)
    {
        List<FaceContact> faces = scratch.FaceContacts;
        InPlaceSort.Sort(faces);
        for (int i = faces.Count - 1; i >= 0; i--)
        {
            if (!IsThere(faces[i], contacts) && ContactPush.IsNeeded(scratch, faces[i], contacts))
                contacts.Add(faces[i].Contact);
        }
    }

    /// <summary>Adds what holds the pairs that no contact takes apart: the deepest first, as its push takes most others
    /// apart.</summary>
    private static void AddOrphans(ConcaveScratch scratch, List<PartContacts> contacts)
    {
        List<FaceContact> orphans = scratch.Orphans;
        if (orphans.Count == 0) return;
        InPlaceSort.Sort(orphans);
        ContactPush.Collect(contacts, scratch.Pushes);
        foreach (FaceContact orphan in orphans)
        {
            if (IsThere(orphan, contacts) || ContactPush.IsHeld(scratch, orphan)) continue;
            ContactPush.Collect(orphan.Contact, scratch.Pushes);
            contacts.Add(orphan.Contact);
        }
    }

    private static bool IsThere(in FaceContact face, List<PartContacts> contacts)
    {
        foreach (PartContacts one in contacts)
            if (one.PartA == face.Contact.PartA && one.PartB == face.Contact.PartB) return true;
        return false;
    }
}
