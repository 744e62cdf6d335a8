using System.Diagnostics.CodeAnalysis;

namespace Gjk.Core;

/// <summary>The convex hull of a cloud of points: its corners without repeats, their neighbours, and the surface as
/// triangles. Immutable; share one between as many shapes and threads as you like.</summary>
/// <remarks>Exact: a point is left out only if it is inside the hull of the others, on a facet or on an edge, decided
/// without rounding. So in no direction does the support value differ from the cloud's. Clouds that span only a point,
/// a segment or a plane are hulls too. Time grows with n log n for usual clouds; 10^5 random points take well under a
/// second.</remarks>
[DebuggerDisplay("{" + nameof(VertexCount) + "} vertices")]
public sealed class ConvexHull
{
    /// <summary>The corners.</summary>
    internal readonly HullVertices Vertices;

    /// <summary>The neighbours of vertex i are <see cref="Neighbors"/> from NeighborStart[i] up to, not including,
    /// NeighborStart[i + 1]; ascending.</summary>
    /// <remarks>The edges of the triangles. They leave no false summit: near a vertex the hull is the cone over the
    /// edges that meet there, coplanar triangles or not; where no neighbour is higher in a direction, nothing in that
    /// cone is, and so nothing in the hull.</remarks>
    internal readonly int[] NeighborStart, Neighbors;

    /// <summary>The corners of triangle i are those from 3 i on.</summary>
    internal readonly int[] Triangles;

    /// <summary>Which corners can be furthest in a direction.</summary>
    internal readonly HullCells Cells;

    /// <summary>Relative. A computed distance is too small by at most 4 u with u = 2^-53 (1 u for each difference, 1.5
    /// u for squares and sum, 1 u for the root, rounded up); 8 u is more (proofs/hull-radius.g).</summary>
    private const double RadiusSlack = 8.0 / (1L << 53);

    /// <summary>Whether the corners are the eight of <see cref="Bounds"/>, and lie at exactly half the extents on
    /// either side of <see cref="Center"/>.</summary>
    internal readonly bool IsExactBox;

#if NET
    /// <summary>The corners measured from <see cref="Center"/>: x, y, z and a 0 each.</summary>
    internal readonly double[] Centered;
#endif

    /// <summary>What it shows to contacts.</summary>
    internal readonly HullFaces Faces;

    /// <summary>What it shows to rays; null where they are cast.</summary>
    internal readonly HullPlanes? Planes;

    /// <summary>A ball of this radius about <see cref="Center"/> is inside; negative where that is outside.</summary>
    internal readonly double InnerRadius;

    private const string NoPoints = "At least one point is needed.";
    private const string NegativeCount = "The list says that it has fewer than no points.";

    private readonly int[] _sources;

    /// <summary>Builds the hull of a cloud.</summary>
    /// <param name="points">At least one; repeats and points inside are fine. Copied.</param>
    /// <exception cref="ArgumentNullException">The list is null.</exception>
    /// <exception cref="ArgumentException">The list is empty, or a coordinate is NaN or infinite; the message names the
    /// index.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The list's count is negative.</exception>
    public ConvexHull(IReadOnlyList<Vector3> points)
        : this(new DistinctPoints(CheckedCopy(points)))
    {
    }

    private ConvexHull(DistinctPoints cloud)
    {
        HullMesh mesh = ConvexHullBuilder.Build(cloud.Points);
        int count = mesh.Corners.Length;
        var corners = new Vector3[count];
        _sources = new int[count];
        Triangles = mesh.Triangles;
        for (int i = 0; i < count; i++)
        {
            corners[i] = cloud.Points[mesh.Corners[i]];
            _sources[i] = cloud.Sources[mesh.Corners[i]];
        }

        Bounds = Aabb.Around(corners);
        Vertices = new HullVertices(corners, mesh.Dimension, Bounds, HullOrigin.Of(Bounds));
        HullAdjacency.Build(mesh, out NeighborStart, out Neighbors);
        Center = Vertices.Center;
        BoundingRadius = MeasureRadius();
        Cells = new HullCells(Vertices);
        Faces = new HullFaces(this, new FaceRegions(corners, Triangles, Bounds));
#if NET
        Centered = Vertices.Centered();
#endif
        Planes = HullPlanes.Of(this);
        InnerRadius = HullInner.Radius(this);
        IsExactBox = Cells.Kind == HullCells.LookupKind.Box
            && Bounds.Max - Center == Cells.Stretch && Center - Bounds.Min == Cells.Stretch;
    }

    /// <summary>How many corners the hull has, at least one. They are numbered from 0 in the order in which they first
    /// occur in the cloud.</summary>
    public int VertexCount => Vertices.Count;

    /// <summary>What the cloud spans: 0 a point, 1 a segment, 2 a flat polygon, 3 a solid.</summary>
    public int Dimension => Vertices.Dimension;

    /// <summary>How many triangles the surface has. A flat polygon has both sides; a segment and a point have
    /// none.</summary>
    public int TriangleCount => Triangles.Length / 3;

    /// <summary>The smallest axis-aligned box around the hull.</summary>
    public Aabb Bounds { get; }

    /// <summary>The middle of <see cref="Bounds"/>.</summary>
    public Double3 Center { get; }

    /// <summary>The largest distance of a corner from <see cref="Center"/>, rounded up: the ball around it does hold
    /// the hull.</summary>
    public double BoundingRadius { get; }

    /// <summary>Builds the hull of a cloud, or says why it cannot.</summary>
    /// <param name="points">At least one; repeats and points inside are fine. Copied.</param>
    /// <param name="hull">The hull, or null.</param>
    /// <param name="reason">Null, or what is wrong with the points, in one sentence.</param>
    /// <returns>True when there is a hull.</returns>
    public static bool TryCreate(
        IReadOnlyList<Vector3>? points, [NotNullWhen(true)] out ConvexHull? hull,
        [NotNullWhen(false)] out string? reason)
    {
        hull = null;
        if (points is null)
        {
            reason = "There is no list of points.";
            return false;
        }

        reason = Refusal(points, out Vector3[] cloud);
        if (reason is not null) return false;
        hull = new ConvexHull(new DistinctPoints(cloud));
        return true;
    }

    /// <summary>The coordinates of a corner, as given (-0 as 0).</summary>
    /// <param name="id">From 0 to <see cref="VertexCount"/> - 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such corner.</exception>
    public Vector3 GetVertex(int id) => Vertices.GetVertex(Guard.Index(id, VertexCount, nameof(id), "vertex"));

    /// <summary>Where the corner first occurs in the cloud.</summary>
    /// <param name="id">From 0 to <see cref="VertexCount"/> - 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such corner.</exception>
    public int SourceIndex(int id) => _sources[Guard.Index(id, VertexCount, nameof(id), "vertex")];

    /// <summary>The corners of a triangle of the surface, counter-clockwise seen from outside. Facets with more than
    /// three corners are cut into several triangles.</summary>
    /// <param name="index">From 0 to <see cref="TriangleCount"/> - 1.</param>
    /// <param name="a">The first corner's id.</param>
    /// <param name="b">The second corner's id.</param>
    /// <param name="c">The third corner's id.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such triangle.</exception>
    public void GetTriangle(int index, out int a, out int b, out int c)
    {
        Guard.Index(index, TriangleCount, nameof(index), "triangle");
        a = Triangles[3 * index];
        b = Triangles[3 * index + 1];
        c = Triangles[3 * index + 2];
    }

    /// <summary>How many corners share an edge of a triangle with this one; on a segment the ends are
    /// neighbours.</summary>
    /// <param name="id">From 0 to <see cref="VertexCount"/> - 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such corner.</exception>
    public int NeighborCount(int id)
    {
        Guard.Index(id, VertexCount, nameof(id), "vertex");
        return NeighborStart[id + 1] - NeighborStart[id];
    }

    /// <summary>A neighbour's id; they ascend with k.</summary>
    /// <param name="id">From 0 to <see cref="VertexCount"/> - 1.</param>
    /// <param name="k">From 0 to <see cref="NeighborCount"/> - 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such corner or neighbour.</exception>
    public int GetNeighbor(int id, int k)
    {
        Guard.Index(k, NeighborCount(id), nameof(k), "neighbour");
        return Neighbors[NeighborStart[id] + k];
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void GetVertex(int id, out Double3 point) => Vertices.GetVertex(id, out point);

    /// <summary>A corner; some corner where there is none with the id.</summary>
    internal bool TryGetVertex(int id, out Double3 point)
    {
        bool found = (uint)id < (uint)VertexCount;
        GetVertex(found ? id : 0, out point);
        return found;
    }

    private static Vector3[] CheckedCopy(IReadOnlyList<Vector3> points)
    {
        string? reason = Refusal(Guard.NotNull(points, nameof(points)), out Vector3[] cloud);
        if (reason is null) return cloud;
        throw reason == NegativeCount
            ? new ArgumentOutOfRangeException(nameof(points), reason)
            : new ArgumentException(reason, nameof(points));
    }

    /// <summary>Copies the points; gives null, or what is wrong with them.</summary>
    private static string? Refusal(IReadOnlyList<Vector3> points, out Vector3[] cloud)
    {
        int count = points.Count;
        cloud = new Vector3[Math.Max(count, 0)];
        if (count <= 0) return count < 0 ? NegativeCount : NoPoints;
        for (int i = 0; i < count; i++)
        {
            cloud[i] = points[i];
            if (!Guard.IsFinite(cloud[i])) return $"Point {i} has a coordinate that is NaN or infinite.";
        }

        return null;
    }

    private double MeasureRadius()
    {
        double squared = 0;
        for (int i = 0; i < VertexCount; i++)
        {
            GetVertex(i, out Double3 p);
            squared = Math.Max(squared, (p - Center).LengthSquared);
        }

        return Math.Sqrt(squared) * (1 + RadiusSlack);
    }
}
