namespace Gjk.Core;

/// <summary>The faces of a hull as contacts take them: triangles that lie in one plane, or would but for the rounding
/// of their corners, joined to a convex polygon. Immutable.</summary>
/// <remarks>A cap that a program computed by sine and cosine, or that was turned in float, is flat to the eye and a fan
/// of tilted triangles to exact predicates; a body that stands on it needs all of its rim. The corners stay the hull's
/// own, so contact points lie on the hull whatever was joined.</remarks>
/// <param name="hull">Whose faces these are; its corners and neighbours are there already.</param>
/// <param name="regions">Its triangles, joined.</param>
internal sealed class HullFaces(ConvexHull hull, FaceRegions regions)
{

    /// <summary>The corners of face i are those from FaceStart[i] up to, not including, FaceStart[i + 1].</summary>
    private readonly int[] _faceStart = regions.FaceStart, _corners = regions.Corners;

    /// <summary>Of unit length, outward.</summary>
    private readonly Double3[] _normals = regions.Normals;

    /// <summary>The faces at vertex i are those from VertexStart[i] up to, not including, VertexStart[i + 1].</summary>
    private readonly int[] _vertexStart = regions.VertexStart, _vertexFaces = regions.VertexFaces;

    /// <summary>How many there are.</summary>
    public int Count => _normals.Length;

    /// <summary>Shows the face, edge or corner at a vertex that lies most level across a direction.</summary>
    /// <param name="vertex">The furthest in the direction.</param>
    /// <param name="direction">Of any length.</param>
    /// <param name="corners">Filled with the corners, measured from the hull's centre.</param>
    public void Get(int vertex, in Double3 direction, ref FaceCorners corners)
    {
        int face = -1;
        double most = 0;
        for (int i = _vertexStart[vertex]; i < _vertexStart[vertex + 1]; i++)
        {
            double along = corners.OuterCosine(_normals[_vertexFaces[i]], direction);
            if (along <= most) continue;
            most = along;
            face = _vertexFaces[i];
        }

        if (face >= 0 && FaceTilt.IsLevelFace(_normals[face], direction, corners)) GetFace(face, ref corners);
        else GetEdge(vertex, direction, ref corners);
    }

    /// <summary>The corners of a face; of more than there is room for, some, spread evenly.</summary>
    private void GetFace(int face, ref FaceCorners corners)
    {
        int start = _faceStart[face], count = _faceStart[face + 1] - start;
        int shown = Math.Min(count, FaceCorners.Capacity);
        for (int i = 0; i < shown; i++) Add(_corners[start + (int)((long)i * count / shown)], ref corners);
    }

    /// <summary>The most level edge at a vertex, or the vertex.</summary>
    private void GetEdge(int vertex, in Double3 direction, ref FaceCorners corners)
    {
        hull.GetVertex(vertex, out Double3 point);
        int end = -1;
        double least = double.PositiveInfinity;
        Double3 up = corners.OuterDirection(direction);
        for (int i = hull.NeighborStart[vertex]; i < hull.NeighborStart[vertex + 1]; i++)
        {
            hull.GetVertex(hull.Neighbors[i], out Double3 other);
            Double3 edge = corners.ToOuter(other - point);
            double rise = FaceTilt.Rise(edge, up);
            if (!FaceTilt.IsLevelEdge(edge, up) || rise >= least) continue;
            least = rise;
            end = hull.Neighbors[i];
        }

        Add(end < 0 ? vertex : Math.Min(vertex, end), ref corners);
        if (end >= 0) Add(Math.Max(vertex, end), ref corners);
    }

    private void Add(int id, ref FaceCorners corners)
    {
        hull.GetVertex(id, out Double3 point);
        corners.Add(point - hull.Center, id);
    }
}
