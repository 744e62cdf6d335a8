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
        List<PartContacts> faces = scratch.Faces;
        faces.Clear();
        for (int i = 0; i < pairs.Count; i++)
        {
            PartDistance pair = pairs[i];
            if (SeamContacts.TryFind(
                scratch.A, pair.PartA, scratch.B, pair.PartB, maxGap, out PartContacts found, out bool isGhost))
            {
                (isGhost ? faces : contacts).Add(found);
            }
        }

        AddFaces(faces, contacts);
        return true;
    }

    /// <summary>Adds the contacts of faces that are needed, each in its place.</summary>
    private static void AddFaces(List<PartContacts> faces, List<PartContacts> contacts)
    {
        int needed = 0;
        for (int i = 0; i < faces.Count; i++)
            if (SeamContacts.IsNeeded(faces[i], contacts)) faces[needed++] = faces[i];
        int from = contacts.Count - 1;
        for (int i = 0; i < needed; i++) contacts.Add(faces[i]);
        for (int to = contacts.Count - 1; needed > 0; to--)
        {
            PartContacts face = faces[needed - 1];
            bool isLast = from < 0 || contacts[from].PartA < face.PartA
                || (contacts[from].PartA == face.PartA && contacts[from].PartB < face.PartB);
            contacts[to] = isLast ? face : contacts[from];
            if (isLast) needed--;
            else from--;
        }
    }
}
