namespace Gjk.Core;

/// <summary>The corner of a mesh to which its surface climbs along a direction, from a triangle and from corner to
/// corner: what a solid's triangle belongs to that is behind a face.</summary>
internal static class MeshClimb
{
    /// <summary>Count: a tip that is more corners away is another part of the surface. More costs time only.</summary>
    private const int MostSteps = 32;

    /// <param name="mesh">The surface.</param>
    /// <param name="triangle">Where to begin.</param>
    /// <param name="direction">In the mesh's frame.</param>
    /// <param name="corner">The lowest of the sides that begin at the corner.</param>
    /// <returns>False where it is further away than is looked.</returns>
    public static bool TryFind(TriangleMesh mesh, int triangle, in Double3 direction, out int corner)
    {
        corner = 3 * triangle;
        double height = Double3.Dot(direction, mesh.GetCorner(corner));
        Climb(mesh, corner + 1, direction, ref corner, ref height);
        Climb(mesh, 3 * triangle + 2, direction, ref corner, ref height);
        for (int step = 0; step < MostSteps; step++)
        {
            int before = corner, lowest = corner;
            for (CornerRing ring = mesh.SidesAt(before); ring.MoveNext();)
            {
                lowest = Math.Min(lowest, ring.Current);
                Climb(mesh, ContactCone.After(ring.Current), direction, ref corner, ref height);
                Climb(mesh, ContactCone.Before(ring.Current), direction, ref corner, ref height);
            }

            if (corner == before) ClimbOverFlat(mesh, before, direction, ref corner, ref height);
            if (corner != before) continue;
            corner = lowest;
            return true;
        }

        return false;
    }

    /// <summary>A corner on the long edge of a triangle without area hides what is joined to that edge.</summary>
    private static void ClimbOverFlat(
        TriangleMesh mesh, int side, in Double3 direction, ref int corner, ref double height)
    {
        for (CornerRing ring = mesh.SidesAt(side); ring.MoveNext();)
        {
            mesh.GetCorners(ring.Current / 3, out Double3 a, out Double3 b, out Double3 c);
            if (!ContactCone.IsFlat(a, b, c)) continue;
            for (CornerRing end = mesh.SidesAt(ContactCone.After(ring.Current)); end.MoveNext();)
            {
                Climb(mesh, ContactCone.After(end.Current), direction, ref corner, ref height);
                Climb(mesh, ContactCone.Before(end.Current), direction, ref corner, ref height);
            }
        }
    }

    private static void Climb(TriangleMesh mesh, int side, in Double3 direction, ref int corner, ref double height)
    {
        double found = Double3.Dot(direction, mesh.GetCorner(side));
        if (found > height) (corner, height) = (side, found);
    }
}
