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
    /// <param name="contacts">Cleared, then what <c>ConvexQuery.Contacts</c> says of each pair of parts that is no
    /// further apart, by the numbers of the parts. Of a triangle only what the surface or solid shows as a whole: a
    /// contact at an edge or corner is left out where the triangles around it reach further along its normal, as at all
    /// flat and concave edges. The triangle's normal and the points along that take its place if it is tilted by some
    /// 25 degrees at most, or if the other shape's furthest point lies over the triangle, as a corner that digs in
    /// beside an edge. Borders, and edges of more than two triangles, stay. At a convex edge each of its triangles has
    /// the contact. An open surface has two sides, and a solid's inside adds no contacts to those of its
    /// triangles.</param>
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
        List<FaceContact> faces = scratch.FaceContacts, orphans = scratch.Orphans;
        faces.Clear();
        orphans.Clear();
        for (int i = 0; i < pairs.Count; i++) SeamContacts.Find(scratch, pairs[i], maxGap, contacts);
        bool hasInside = scratch.A.IsSolid || scratch.B.IsSolid || scratch.A.Compound is not null || scratch.B.Compound is not null;
        if (contacts.Count > 1 && hasInside) SeamContacts.RemoveNeedless(scratch, contacts);
        int own = contacts.Count;
        for (int i = 0; i < faces.Count; i++) AddFace(scratch, faces[i], contacts, own, false);
        while (orphans.Count > 0)
        {
            // The one that is deepest first: its push takes most others apart.
            int deepest = 0;
            for (int i = 1; i < orphans.Count; i++)
                if (orphans[i].Contact.Result.Distance < orphans[deepest].Contact.Result.Distance) deepest = i;
            AddFace(scratch, orphans[deepest], contacts, contacts.Count, true);
            orphans.RemoveAt(deepest);
        }

        if (contacts.Count > own) SortByParts(contacts);
        return true;
    }

    private static void AddFace(
        ConcaveScratch scratch, in FaceContact face, List<PartContacts> contacts, int own, bool isLast)
    {
        for (int i = 0; i < contacts.Count; i++)
            if (contacts[i].PartA == face.Contact.PartA && contacts[i].PartB == face.Contact.PartB) return;
        if (SeamContacts.IsNeeded(scratch, face, contacts, own, isLast)) contacts.Add(face.Contact);
    }

    private static void SortByParts(List<PartContacts> contacts)
    {
        for (int i = 1; i < contacts.Count; i++)
        {
            PartContacts moved = contacts[i];
            int to = i;
            for (; to > 0 && IsAfter(contacts[to - 1], moved); to--) contacts[to] = contacts[to - 1];
            contacts[to] = moved;
        }
    }

    private static bool IsAfter(in PartContacts one, in PartContacts other) =>
        one.PartA != other.PartA ? one.PartA > other.PartA : one.PartB > other.PartB;
}
