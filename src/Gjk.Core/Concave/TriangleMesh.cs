namespace Gjk.Core;

/// <summary>Triangles, kept as they are given: the surface that is their union, with a tree for queries. Build it once
/// and share it: it is immutable but for <see cref="Core.HeightField.SetHeights"/>, and any number of shapes and
/// threads may use it.</summary>
/// <remarks>Triangles keep the caller's numbers; degenerate and repeated ones count like all others. The largest
/// triangle numbers are limited by memory alone: some 54 to 90 bytes a triangle in meshes with half as many vertices as
/// triangles.</remarks>
[DebuggerDisplay("{" + nameof(TriangleCount) + "} triangles, {" + nameof(VertexCount) + "} vertices")]
public sealed partial class TriangleMesh : IPartSource
{
    /// <summary>Count: what fills the lanes of the triangle filter well, and keeps the tree small.</summary>
    private const int LeafSize = 4, MostInLeaf = 7;

    private readonly TriangleList _list;
    private readonly MeshTopology _topology;

    /// <summary>As <see cref="MeshTopology.Around"/>, with the sides of what fills T-junctions.</summary>
    private readonly int[] _around;

    /// <summary>The tree over the triangles.</summary>
    internal readonly PartTree Tree;

    /// <summary>Where all vertices are, if the mesh is flat and its heights have not changed.</summary>
    internal MeshSlab? Slab { get; private set; }

    /// <summary>For each connected piece, whether its normals point into the solid; empty where none do.</summary>
    private readonly bool[] _looksIn;

    /// <summary>The scale in double, so that products with vertices are exact.</summary>
    private readonly Double3 _scale;

    /// <summary>What it encloses, if it is closed.</summary>
    internal readonly SolidInside[] Insides;

    /// <summary>Builds a mesh.</summary>
    /// <param name="vertices">Finite points in the local frame; they need not all be used. Copied.</param>
    /// <param name="indices">Three for each triangle, at least one triangle, each at least 0 and below the number of
    /// vertices. Copied.</param>
    /// <param name="workers">The threads to use; null for the caller's own. The mesh is the same.</param>
    /// <exception cref="ArgumentNullException">A list is null.</exception>
    /// <exception cref="ArgumentException"><see cref="TryCreate"/> would refuse the lists; the message says
    /// why.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public TriangleMesh(IReadOnlyList<Vector3> vertices, IReadOnlyList<int> indices, Workers? workers = null)
        : this(CheckLists(vertices, indices, workers), Vector3.One, workers: workers)
    {
    }

    private TriangleMesh(
        (TriangleList List, MeshTopology Topology) triangles, Vector3 scale, PartTree? like = null,
        HeightGrid? grid = null, Workers? workers = null)
    {
        (_list, _topology) = triangles;
        Scale = scale;
        _scale = scale;
        Tree = like is not null
            ? PartTreeRefit.Fit(this, like)
            : PartTreeBuilder.Build(this, LeafSize, MostInLeaf, workers);
        _around = _topology.Around;
        int[] fill = CornersOnEdges.Fill(this, _topology.Borders);
        if (fill.Length > 0) (_list, _around) = (_list.WithFill(fill), _topology.AroundWith(_list.CopyIndices(), fill));
        Slab = MeshSlab.Find(this);
        _looksIn = PieceSides.LooksIn(this);
        Insides = HasInside ? [new SolidInside(this)] : [];
        HeightField = grid is null ? null : new HeightField(this, grid);
    }

    /// <summary>The cells and heights of a mesh that <see cref="FromHeights"/> has made, else null.</summary>
    public HeightField? HeightField { get; }

    /// <summary>How many triangles there are, at least one.</summary>
    public int TriangleCount => _list.SideCount / 3;

    /// <summary>How many vertices there are, the unused ones included.</summary>
    public int VertexCount => _list.VertexCount;

    /// <summary>The factors that the vertices are multiplied with, exactly; 1 unless <see cref="Scaled"/>.</summary>
    public Vector3 Scale { get; }

    /// <summary>Whether each edge belongs to an even number of triangles. Vertices with equal coordinates are
    /// one.</summary>
    public bool IsClosed => _topology.IsClosed;

    /// <summary>Whether the triangles go along each edge as often in one direction as in the other, or once more where
    /// their number is odd.</summary>
    public bool IsOriented => _topology.IsOriented;

    /// <summary>How many edges belong to one triangle alone.</summary>
    public int BorderEdgeCount => _topology.BorderEdges;

    /// <summary>How many triangles have no area: their corners are on one line, exactly.</summary>
    public int DegenerateCount => _topology.Degenerate;

    /// <summary>How many triangles have the corners of an earlier one, in whichever order.</summary>
    public int DuplicateCount => _topology.Duplicate;

    /// <summary>In how many pieces the triangles hang together by common vertices.</summary>
    public int ComponentCount => _topology.Components.Length;

    /// <summary>Whether the mesh has an inside: it is closed and consistently oriented, so that triangles go along each
    /// edge as often in one direction as in the other.</summary>
    public bool HasInside => _topology.FaultyA < 0;

    /// <summary>Null, or which edge keeps the mesh from having an inside, in one sentence.</summary>
    public string? WhyNoInside
    {
        get
        {
            MeshTopology found = _topology;
            return HasInside
                ? null
                : $"The edge from vertex {found.FaultyA} to vertex {found.FaultyB} has "
                    + $"{Triangles(found.FaultyAlong)} along it and {Triangles(found.FaultyAgainst)} against it.";
        }
    }

    /// <summary>The same triangles scaled about the local origin, exactly; factors of an earlier call are
    /// multiplied.</summary>
    /// <param name="scale">Along the local axes; negative factors mirror.</param>
    /// <returns>A mesh that shares the vertices and has a tree of its own; the heights of a height field are copied, so
    /// that a change of one leaves the other.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A factor, or its product with an earlier one, is 0, NaN or
    /// infinite.</exception>
    public TriangleMesh Scaled(Vector3 scale)
    {
        Guard.Scale(scale, nameof(scale));
        Vector3 factors = Guard.Scale(Scale * scale, nameof(scale));
        TriangleList list = HeightField is null ? _list : _list.Copy();
        return new TriangleMesh((list, _topology), factors, grid: HeightField?.Grid);
    }

    /// <summary>Volume, mass, centre of mass and inertia of the solid inside, in the mesh's frame, to a few roundings
    /// of double however far it lies from the origin.</summary>
    /// <param name="density">Mass in a unit of volume; at least 0 and finite.</param>
    /// <returns>The same whichever way the triangles are turned. What pieces enclose together counts once for each of
    /// them; a cavity, whose triangles are turned the other way, does not count. Time is in proportion to the
    /// triangles; keep the result.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The density is negative, NaN or infinite.</exception>
    /// <exception cref="InvalidOperationException">The mesh has no inside; the message names an edge.</exception>
    public MassProperties GetMassProperties(float density = 1)
    {
        Guard.NonNegative(density, nameof(density));
        if (!HasInside) throw new InvalidOperationException(WhyNoInside);
        var sum = new TetrahedronSum(Tree.Origin);
        for (int i = 0; i < TriangleCount; i++)
        {
            GetCorners(i, out Double3 a, out Double3 b, out Double3 c);
            if (OutwardOf(i) > 0) sum.Add(a, b, c);
            else sum.Add(a, c, b);
        }

        return sum.ToMass().Times(density);
    }

    /// <summary>A vertex in the local frame, before the scale.</summary>
    /// <param name="index">From 0 to <see cref="VertexCount"/> - 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such vertex.</exception>
    public Vector3 GetVertex(int index) => _list.Vertex(Guard.Index(index, VertexCount, nameof(index), "vertex"));

    /// <summary>The vertices of a triangle.</summary>
    /// <param name="index">From 0 to <see cref="TriangleCount"/> - 1, as given.</param>
    /// <param name="a">The first vertex.</param>
    /// <param name="b">The second vertex.</param>
    /// <param name="c">The third vertex.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such triangle.</exception>
    public void GetTriangle(int index, out int a, out int b, out int c)
    {
        Guard.Index(index, TriangleCount, nameof(index), "triangle");
        _list.GetVertices(3 * index, out a, out b, out c);
    }

    /// <summary>One triangle of each connected piece.</summary>
    internal int[] Components => _topology.Components;

    /// <summary>The sides that begin where a side begins.</summary>
    internal CornerRing SidesAt(int side) => new(_list, _around, side);

    /// <summary>The number of a triangle's connected piece.</summary>
    internal int PieceOf(int triangle) =>
        _topology.Pieces.Length == 0 ? 0 : _topology.Pieces[_list.VertexOf(3 * triangle)];

    /// <summary>1 where a triangle's normal looks out of the solid, else -1.</summary>
    internal int OutwardOf(int triangle) => _looksIn.Length > 0 && _looksIn[PieceOf(triangle)] ? -1 : 1;

    internal bool IsScaled => Scale != Vector3.One;

    /// <summary>-1 where the scale mirrors, so that the corners run the other way round, else 1.</summary>
    internal int Mirror => Math.Sign(_scale.X) * Math.Sign(_scale.Y) * Math.Sign(_scale.Z);

    /// <summary>The corners of a triangle with the scale.</summary>
    internal void GetCorners(int triangle, out Double3 a, out Double3 b, out Double3 c)
    {
        _list.GetPositions(3 * triangle, out Vector3 first, out Vector3 second, out Vector3 third);
        a = Double3.Multiply(first, _scale);
        b = Double3.Multiply(second, _scale);
        c = Double3.Multiply(third, _scale);
    }

    /// <summary>A vertex with the scale.</summary>
    internal Double3 GetScaledVertex(int vertex) => Double3.Multiply(_list.Vertex(vertex), _scale);

    /// <inheritdoc cref="TriangleList.SetHeight"/>
    internal void SetHeight(int vertex, float height, bool isZUp)
    {
        Slab = null;
        _list.SetHeight(vertex, height, isZUp);
    }

    /// <summary>How far the vertices reach along a direction; reads only every so many of them.</summary>
    internal double Reach(in Double3 direction, int step)
    {
        Double3 scaled = Double3.Multiply(direction, _scale);
        double most = double.NegativeInfinity;
        for (int i = 0; i < VertexCount; i += step) most = Math.Max(most, Double3.Dot(scaled, _list.Vertex(i)));
        return most;
    }

    /// <summary>A corner of a triangle with the scale.</summary>
    /// <param name="side">Three times the triangle, and the corner.</param>
    internal Double3 GetCorner(int side) => GetScaledVertex(VertexOf(side));

    /// <summary>The vertex at which a side begins.</summary>
    internal int VertexOf(int side) => _list.VertexOf(side);

    /// <summary>A triangle as a shape of its own.</summary>
    internal ConvexShape GetShape(int triangle)
    {
        _list.GetPositions(3 * triangle, out Vector3 a, out Vector3 b, out Vector3 c);
        var shape = ConvexShape.Triangle(a, b, c);
        return IsScaled ? shape.Scaled(Scale) : shape;
    }

    /// <summary>A triangle as a shape of its own, where there is no scale.</summary>
    internal TriangleShape GetPlain(int triangle)
    {
        _list.GetPositions(3 * triangle, out Vector3 a, out Vector3 b, out Vector3 c);
        return new TriangleShape(a, b, c);
    }

    /// <summary>A triangle as the solvers take it.</summary>
    internal void GetCore(int triangle, out TriangleCore core)
    {
        GetCorners(triangle, out Double3 a, out Double3 b, out Double3 c);
        Double3 center = TriangleShape.Centroid(a, b, c);
        TriangleCore.Make(a, b, c, center, TriangleShape.RadiusAbout(center, a, b, c), 0, out core);
    }

    private static string Triangles(int count) => count == 1 ? "1 triangle" : $"{count} triangles";

    int IPartSource.Count => TriangleCount;

    void IPartSource.GetBox(int part, out Double3 min, out Double3 max)
    {
        GetCorners(part, out Double3 a, out Double3 b, out Double3 c);
        min = new Double3(
            Math.Min(Math.Min(a.X, b.X), c.X), Math.Min(Math.Min(a.Y, b.Y), c.Y),
            Math.Min(Math.Min(a.Z, b.Z), c.Z));
        max = new Double3(
            Math.Max(Math.Max(a.X, b.X), c.X), Math.Max(Math.Max(a.Y, b.Y), c.Y),
            Math.Max(Math.Max(a.Z, b.Z), c.Z));
    }

    bool IPartSource.TryGetTriangle(int part, out Double3 a, out Double3 b, out Double3 c)
    {
        GetCorners(part, out a, out b, out c);
        return true;
    }
}
