namespace Gjk.Core;

/// <summary>Finds corners of a mesh that lie on another triangle's border edge, between its ends (T-junctions).
/// Triangles without area fill the gaps there, so that the triangles on both sides are joined. Queries do not see the
/// fill; only neighbourhood does.</summary>
/// <remarks>Corners are put into cubes as large as the average border edge, or as the width that counts as on an edge.
/// Each edge searches the cubes along it, piece by piece: there are at most twice as many pieces as edges, and some 27
/// cubes at each.</remarks>
internal sealed class CornersOnEdges
{
    /// <summary>Count: so many corners are near a border edge, on average. A heap of triangles that has more has no
    /// T-junctions, and looking for them would take quadratic time. Pinned by FloorTests.</summary>
    private const int MostNear = 64;

    private readonly TriangleMesh _mesh;
    private readonly double _cube;

    /// <summary>The last of the corners in each cube, and the one before each; -1 where there is none.</summary>
    private readonly Dictionary<Vector3, int> _last = [];

    private readonly List<(int Corner, int Before)> _corners = [];
    private readonly List<(int Side, double Along, int Corner)> _found = [];
    private long _left;

    private CornersOnEdges(TriangleMesh mesh, double cube, int borders) =>
        (_mesh, _cube, _left) = (mesh, cube, (long)MostNear * borders);

    /// <summary>Three vertices of each triangle of the fill; empty where there is no T-junction.</summary>
    /// <param name="mesh">A mesh whose tree is built.</param>
    /// <param name="borders">The sides that are edges of one triangle alone.</param>
    public static int[] Fill(TriangleMesh mesh, int[] borders)
    {
        if (borders.Length == 0) return [];
        double sum = 0;
        foreach (int side in borders)
            sum += (mesh.GetCorner(TriangleList.NextSide(side)) - mesh.GetCorner(side)).Length;
        double least = 2 * ContactCone.Flat * (mesh.Tree.Origin.Length + 2 * mesh.Tree.Radius);
        var search = new CornersOnEdges(mesh, Math.Max(sum / borders.Length, least), borders.Length);
        search.Collect(borders);
        foreach (int side in borders)
            if (!search.TryFindOn(side)) return [];
        search._found.Sort();
        return search.ListTriangles();
    }

    private void Collect(int[] borders)
    {
        var seen = new HashSet<Vector3>();
        for (int i = 0; i < 2 * borders.Length; i++)
        {
            int corner = i % 2 == 0 ? borders[i / 2] : TriangleList.NextSide(borders[i / 2]);
            Double3 place = _mesh.GetCorner(corner);
            if (!seen.Add((Vector3)place)) continue;
            var key = (Vector3)CubeOf(place);
            if (!_last.TryGetValue(key, out int before)) before = -1;
            _last[key] = _corners.Count;
            _corners.Add((corner, before));
        }
    }

    private Double3 CubeOf(in Double3 place)
    {
        Double3 at = (place - _mesh.Tree.Origin) * (1 / _cube);
        return new Double3(Math.Floor(at.X), Math.Floor(at.Y), Math.Floor(at.Z));
    }

    /// <summary>Finds the corners on an edge, piece by piece.</summary>
    /// <returns>False where there are too many corners to test.</returns>
    private bool TryFindOn(int side)
    {
        Double3 start = _mesh.GetCorner(side), edge = _mesh.GetCorner(TriangleList.NextSide(side)) - start;
        double length = edge.Length, room = ContactCone.Flat * (length + start.Length);
        var most = new Double3(room, room, room);
        var pieces = (int)Math.Ceiling(length / _cube);
        for (int i = 0; i < pieces; i++)
        {
            Double3 a = start + edge * ((double)i / pieces), b = start + edge * ((i + 1.0) / pieces);
            Double3 middle = (a + b) * 0.5, half = (b - a) * 0.5;
            half = new Double3(Math.Abs(half.X), Math.Abs(half.Y), Math.Abs(half.Z)) + most;
            Double3 low = CubeOf(middle - half), high = CubeOf(middle + half);
            for (double x = low.X; x <= high.X; x++)
            {
                for (double y = low.Y; y <= high.Y; y++)
                    for (double z = low.Z; z <= high.Z; z++)
                        FindInCube(side, start, edge, (Vector3)new Double3(x, y, z));
            }
        }

        return _left >= 0;
    }

    private void FindInCube(int side, in Double3 start, in Double3 edge, Vector3 cube)
    {
        if (!_last.TryGetValue(cube, out int at)) return;
        for (; at >= 0 && _left >= 0; at = _corners[at].Before, _left--)
        {
            int corner = _corners[at].Corner;
            if (IsBetween(start, edge, _mesh.GetCorner(corner), out double along)) _found.Add((side, along, corner));
        }
    }

    private static bool IsBetween(in Double3 start, in Double3 edge, in Double3 place, out double along)
    {
        along = Double3.Dot(place - start, edge) / edge.LengthSquared;
        return along > 0 && along < 1 && place != start && place != start + edge
            && ContactCone.IsFlat(start, start + edge, place);
    }

    /// <summary>Makes triangles of each edge and the corners on it, in their order along the edge.</summary>
    private int[] ListTriangles()
    {
        var fill = new List<int>();
        for (int i = 0; i < _found.Count; i++)
        {
            (int side, _, int corner) = _found[i];
            if (i > 0 && _found[i] == _found[i - 1]) continue;
            int from = i > 0 && _found[i - 1].Side == side ? _found[i - 1].Corner : side;
            fill.AddRange([_mesh.VertexOf(from), _mesh.VertexOf(corner), _mesh.VertexOf(TriangleList.NextSide(side))]);
        }

        return [.. fill];
    }
}
