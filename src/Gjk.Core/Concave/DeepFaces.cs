namespace Gjk.Core;

/// <summary>The faces of a solid that is deeper in a surface than the gap. What of it is wholly behind the surface is
/// in no pair of parts that touch, and shows there all the same where it lies level, such as the bottom of a die, once
/// the floor is above the bevel.</summary>
internal static class DeepFaces
{
    /// <summary>How far apart the parts of a solid and of what it is in may be that hold it.</summary>
    /// <param name="scratch">With both sides.</param>
    /// <param name="contacts">Those of the parts within the gap.</param>
    /// <param name="maxGap">The gap, in world units.</param>
    /// <returns>The gap, if no level faces are deeper.</returns>
    public static float FindGap(ConcaveScratch scratch, List<PairContacts> contacts, float maxGap)
    {
        PartSide b = scratch.B;
        float deepest = maxGap;
        if (b.IsConvex) return deepest;
        foreach (PairContacts one in contacts)
        {
            PartSide a = scratch.SideOf(one.Pair.A, true);
            float length = ContactPush.LengthOf(one.Result);
            if (!(-one.Result.Distance > maxGap && length > deepest)) continue;
            if (a.IsConvex || !(a.HasInside || b.HasInside)) continue;
            Double3 way = one.Manifold.Normal;
            if (HasLevelFace(a, one.PartA, way) && HasLevelFace(b, one.PartB, way)) deepest = length;
        }

        return deepest;
    }

    /// <summary>Whether the faces of two triangles lie on each other.</summary>
    public static bool AreLevel(ConcaveScratch scratch, in PairDistance pair)
    {
        PartSide a = scratch.SideOf(pair.Pair.A, true), b = scratch.B;
        if (!a.IsTriangle(pair.PartA) || !b.IsTriangle(pair.PartB)) return false;
        Double3 way = a.ToWorldDirection(ContactCone.NormalOf(a, pair.PartA));
        return FaceSearch.IsLevel(b, pair.PartB, way);
    }

    /// <summary>Removes the points that are further apart than a gap.</summary>
    public static void RemoveBeyond(List<PairContacts> contacts, float maxGap)
    {
        int kept = 0;
        for (int k = 0; k < contacts.Count; k++)
        {
            PairContacts one = contacts[k];
            ContactManifold near = default;
            near.Begin(one.Manifold.Normal);
            for (int i = 0; i < one.Manifold.Count; i++)
                if (!(one.Manifold[i].Gap > maxGap)) near.Add(one.Manifold[i]);
            if (near.Count > 0) contacts[kept++] = new PairContacts(one.PartA, one.PartB, one.Result, near, one.Pair);
        }

        contacts.RemoveRange(kept, contacts.Count - kept);
    }

    /// <summary>Whether a part, or a triangle at one of its corners, lies level across a way.</summary>
    private static bool HasLevelFace(PartSide side, int part, in Double3 way)
    {
        if (!side.IsTriangle(part) || FaceSearch.IsLevel(side, part, way)) return true;
        for (int corner = 3 * part; side.Mesh is not null && corner < 3 * part + 3; corner++)
        {
            for (CornerRing ring = side.Mesh.SidesAt(corner); ring.MoveNext();)
                if (FaceSearch.IsLevel(side, ring.Current / 3, way)) return true;
        }

        return false;
    }
}
