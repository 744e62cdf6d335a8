namespace Gjk.Core;

/// <summary>Climbs a mesh's surface along a direction, from a triangle and from corner to corner, to its tip. It shows
/// which part of a solid a triangle behind a face belongs to.</summary>
internal static class MeshClimb
{
    /// <summary>Count: the most corners on the way. A tip further away is another part of the surface. More costs time
    /// only.</summary>
    private const int MostSteps = 32;

    /// <param name="mesh">The surface.</param>
    /// <param name="triangle">The triangle to begin at.</param>
    /// <param name="direction">In the mesh's frame.</param>
    /// <param name="corner">The tip, as the lowest-numbered side that begins there.</param>
    /// <returns>False where the tip is too many corners away.</returns>
    public static bool TryFind(TriangleMesh mesh, int triangle, in Double3 direction, out int corner)
    {
        corner = 3 * triangle;
        double height = Double3.Dot(direction, mesh.GetCorner(corner));
        Climb(mesh, 3 * triangle, direction, ref corner, ref height);
        for (int step = 0; step < MostSteps; step++)
        {
            int before = corner, lowest = corner;
            for (CornerRing ring = mesh.SidesAt(before); ring.MoveNext();)
            {
                lowest = Math.Min(lowest, ring.Current);
                Climb(mesh, ring.Current, direction, ref corner, ref height);
            }

            if (corner == before) ClimbOverFlat(mesh, before, direction, ref corner, ref height);
            if (corner != before) continue;
            corner = lowest;
            return true;
        }

        return false;
    }

    /// <summary>Climbs also from the corners of triangles without area: a corner on the long edge of one hides what is
    /// joined to that edge.</summary>
    private static void ClimbOverFlat(
        TriangleMesh mesh, int side, in Double3 direction, ref int corner, ref double height)
    {
        for (CornerRing ring = mesh.SidesAt(side); ring.MoveNext();)
        {
            mesh.GetCorners(ring.Current / 3, out Double3 a, out Double3 b, out Double3 c);
            if (!ContactCone.IsFlat(a, b, c)) continue;
            for (CornerRing end = mesh.SidesAt(TriangleList.NextSide(ring.Current)); end.MoveNext();)
                Climb(mesh, end.Current, direction, ref corner, ref height);
        }
    }

    /// <summary>Climbs to the higher of a triangle's other two corners, if that is the highest so far.</summary>
    private static void Climb(TriangleMesh mesh, int side, in Double3 direction, ref int corner, ref double height)
    {
        for (int other = TriangleList.NextSide(side); other != side; other = TriangleList.NextSide(other))
        {
            double found = Double3.Dot(direction, mesh.GetCorner(other));
            if (found > height) (corner, height) = (other, found);
        }
    }
}
