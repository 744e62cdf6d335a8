namespace Gjk.Core;

/// <summary>Corners of a mesh that lie on another triangle's border edge, between its ends (T-junctions): triangles
/// without area fill them, so that what meets there is joined. They are no parts; only neighbourhood knows
/// them.</summary>
internal static class CornersOnEdges
{
    /// <summary>Three vertices of each triangle that fills one; empty where there are none.</summary>
    /// <param name="mesh">Whose tree is built.</param>
    /// <param name="borders">The sides that are edges of one triangle alone.</param>
    public static int[] Fill(TriangleMesh mesh, int[] borders)
    {
        if (borders.Length == 0) return [];
        var isBorder = new bool[3 * mesh.TriangleCount];
        foreach (int side in borders) isBorder[side] = true;
        var found = new List<(int Side, double Along, int Corner)>();
        var seen = new HashSet<Vector3>();
        var scratch = new ConcaveScratch();
        AnyShape surface = AnyShape.Surface(mesh), point = AnyShape.Of(ConvexShape.Point());
        for (int i = 0; i < 2 * borders.Length; i++)
        {
            int corner = i % 2 == 0 ? borders[i / 2] : ContactCone.After(borders[i / 2]);
            Double3 place = mesh.GetCorner(corner);
            if (!seen.Add((Vector3)place)) continue;
            var gap = (float)(ContactCone.Flat * (2 * mesh.Tree.Radius + place.Length));
            ConcaveQuery.FindPairsWithin(
                surface, RigidPose.Identity, point, new RigidPose((Vector3)place), gap, scratch, scratch.Near);
            foreach (PairDistance near in scratch.Near)
            {
                int first = 3 * near.PartA;
                for (int side = first; side < first + 3; side++)
                    if (isBorder[side] && IsBetween(mesh, side, place, out double along))
                        found.Add((side, along, corner));
            }
        }

        found.Sort();
        return Fan(mesh, found);
    }

    private static bool IsBetween(TriangleMesh mesh, int side, in Double3 place, out double along)
    {
        Double3 start = mesh.GetCorner(side), edge = mesh.GetCorner(ContactCone.After(side)) - start;
        along = Double3.Dot(place - start, edge) / edge.LengthSquared;
        return along > 0 && along < 1 && place != start && place != start + edge
            && ContactCone.IsFlat(start, start + edge, place);
    }

    /// <summary>Each edge with the corners on it, in their order, from where it begins.</summary>
    private static int[] Fan(TriangleMesh mesh, List<(int Side, double Along, int Corner)> found)
    {
        var fill = new int[3 * found.Count];
        for (int i = 0; i < found.Count; i++)
        {
            (int side, _, int corner) = found[i];
            bool isFirst = i == 0 || found[i - 1].Side != side;
            fill[3 * i] = mesh.VertexOf(isFirst ? side : found[i - 1].Corner);
            fill[3 * i + 1] = mesh.VertexOf(corner);
            fill[3 * i + 2] = mesh.VertexOf(ContactCone.After(side));
        }

        return fill;
    }
}
