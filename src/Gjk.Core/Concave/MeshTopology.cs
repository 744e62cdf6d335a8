using System.Linq;

namespace Gjk.Core;

/// <summary>The topology of a list of triangles: shared edges, degenerate and repeated triangles, and connected pieces.
/// Vertices at the same place are one vertex; no tolerance joins others.</summary>
internal sealed class MeshTopology
{
    // Used only while it is built.
    private readonly int[] _corners, _indices, _component;

    /// <summary>The first vertex at the place of each; empty for a grid.</summary>
    private readonly int[] _joined = [];

    private readonly List<int> _borders = [];
    private int _faulty;

    /// <param name="vertices">The vertices.</param>
    /// <param name="indices">Three of each triangle.</param>
    public MeshTopology(Vector3[] vertices, int[] indices)
    {
        _indices = indices;
        _joined = Joined(vertices);
        _corners = Array.ConvertAll(indices, i => _joined[i]);
        _component = new int[vertices.Length];
        Around = RingsAround(_corners, vertices.Length);
        CountEdges();
        Borders = [.. _borders];
        BorderEdges = Borders.Length;
        Degenerate = CountDegenerate(vertices, indices);
        FindComponents();
        _corners = _indices = _component = [];
        _borders = [];
    }

    /// <summary>The topology after the vertices have moved. In most cases the same vertices are joined, and it can be
    /// reused.</summary>
    public MeshTopology WithVertices(Vector3[] vertices, int[] indices)
    {
        if (!Joined(vertices).SequenceEqual(_joined)) return new MeshTopology(vertices, indices);
        var same = (MeshTopology)MemberwiseClone();
        same.Degenerate = CountDegenerate(vertices, indices);
        return same;
    }

    private static bool IsDegenerate(HullPredicates predicates, int a, int b, int c) =>
        a == b || b == c || c == a || predicates.AreCollinear(a, b, c);

    /// <summary>The topology of a grid, which needs no search: its outline is open.</summary>
    public MeshTopology(int columns, int rows, bool isZUp)
    {
        (_corners, _indices, _component, Around) = ([], [], [], []);
        BorderEdges = 2 * (columns + rows - 2);
        IsClosed = false;
        (FaultyA, FaultyB, FaultyAlong) = (0, isZUp ? 1 : columns, 1);
        Components = [0];
    }

    /// <summary>How many edges belong to one triangle alone.</summary>
    public int BorderEdges { get; private set; }

    /// <summary>Whether each edge belongs to an even number of triangles.</summary>
    public bool IsClosed { get; private set; } = true;

    /// <summary>Whether triangles go along each edge as often in one direction as in the other, or once more.</summary>
    public bool IsOriented { get; private set; } = true;

    /// <summary>The ends of an edge that no closed and oriented surface has; -1 where there is none.</summary>
    public int FaultyA { get; private set; } = -1;

    /// <inheritdoc cref="FaultyA"/>
    public int FaultyB { get; private set; } = -1;

    /// <summary>How often triangles go along that edge, and against it.</summary>
    public int FaultyAlong { get; private set; }

    /// <inheritdoc cref="FaultyAlong"/>
    public int FaultyAgainst { get; private set; }

    /// <summary>For each side of a triangle (three times the triangle, plus the corner at which it begins), the next
    /// one that begins at the same place, in a ring.</summary>
    public int[] Around { get; }

    /// <summary>The sides that are edges of one triangle alone; empty for a grid.</summary>
    public int[] Borders { get; } = [];

    /// <summary><see cref="Around"/> with more triangles.</summary>
    public int[] AroundWith(int[] indices, int[] more) =>
        RingsAround(Array.ConvertAll([.. indices, .. more], i => _joined[i]), _joined.Length);

    public int Degenerate { get; private set; }

    public int Duplicate { get; private set; }

    /// <summary>One triangle of each connected part: the first.</summary>
    public int[] Components { get; private set; } = [];

    /// <summary>For each vertex the number of its connected part in <see cref="Components"/>; empty where there is one
    /// part.</summary>
    public int[] Pieces { get; private set; } = [];

    /// <summary>The first vertex at each vertex's place.</summary>
    private static int[] Joined(Vector3[] vertices)
    {
        var places = new Dictionary<Vector3, int>(vertices.Length);
        int[] joined = new int[vertices.Length];
        for (int i = 0; i < vertices.Length; i++)
        {
            // -0 + 0 is 0.
            Vector3 place = vertices[i] + Vector3.Zero;
            if (!places.TryGetValue(place, out joined[i])) places.Add(place, joined[i] = i);
        }

        return joined;
    }

    /// <summary>Links the sides that begin at each vertex into rings, in their order.</summary>
    private static int[] RingsAround(int[] corners, int vertices)
    {
        int[] first = new int[vertices], around = new int[corners.Length];
        for (int i = corners.Length - 1; i >= 0; i--)
        {
            int next = first[corners[i]] - 1;
            around[i] = next < 0 ? i : around[next];
            if (next >= 0) around[next] = i;
            else first[corners[i]] = i + 1;
        }

        return around;
    }

    private void CountEdges()
    {
        var keys = new ulong[_corners.Length];
        int[] sides = new int[_corners.Length];
        for (int i = 0; i < keys.Length; i++)
        {
            int a = _corners[i], b = _corners[TriangleList.NextSide(i)];
            keys[i] = ((ulong)(uint)Math.Min(a, b) << 32) | (uint)Math.Max(a, b);
            sides[i] = i;
        }

        Array.Sort(keys, sides);
        var thirds = new List<int>();
        for (int begin = 0; begin < keys.Length;)
        {
            int end = begin, along = 0, first = int.MaxValue;
            int low = (int)(keys[begin] >> 32), high = (int)(keys[begin] & uint.MaxValue);
            for (; end < keys.Length && keys[end] == keys[begin]; end++)
            {
                if (_corners[sides[end]] == low) along++;
                first = Math.Min(first, sides[end]);
            }

            if (low != high) CountEdge(along, end - begin - along, first);
            if (end > begin + 1) CountDuplicates(sides, begin, end, thirds);
            begin = end;
        }
    }

    private void CountEdge(int along, int against, int first)
    {
        int count = along + against;
        if (count == 1) _borders.Add(first);
        if (count % 2 != 0) IsClosed = false;
        if (Math.Abs(along - against) > 1) IsOriented = false;
        if (along == against || (FaultyA >= 0 && first > _faulty)) return;
        _faulty = first;
        (FaultyA, FaultyB) = (_indices[first], _indices[TriangleList.NextSide(first)]);
        bool isAlong = _corners[first] < _corners[TriangleList.NextSide(first)];
        (FaultyAlong, FaultyAgainst) = isAlong ? (along, against) : (against, along);
    }

    /// <summary>Counts the repeated triangles at an edge. Each is counted at the edge of its two lowest
    /// corners.</summary>
    private void CountDuplicates(int[] sides, int begin, int end, List<int> thirds)
    {
        thirds.Clear();
        for (int i = begin; i < end; i++)
        {
            int side = sides[i], first = side - side % 3;
            int from = _corners[side], to = _corners[TriangleList.NextSide(side)];
            int third = _corners[TriangleList.PreviousSide(side)], high = Math.Max(from, to);

            // If corners are equal, only one of the triangle's sides counts.
            bool isOne = from < to || (from == to && side == first);
            if (third > high || (third == high && isOne)) thirds.Add(third);
        }

        thirds.Sort();
        for (int i = 1; i < thirds.Count; i++)
            if (thirds[i] == thirds[i - 1]) Duplicate++;
    }

    private int CountDegenerate(Vector3[] vertices, int[] indices)
    {
        var predicates = new HullPredicates(vertices);
        int count = 0;
        for (int i = 0; i < indices.Length; i += 3)
            if (IsDegenerate(predicates, _joined[indices[i]], _joined[indices[i + 1]], _joined[indices[i + 2]]))
                count++;
        return count;
    }

    private void FindComponents()
    {
        for (int i = 0; i < _component.Length; i++) _component[i] = i;
        for (int i = 0; i < _corners.Length; i += 3)
        {
            Join(_corners[i], _corners[i + 1]);
            Join(_corners[i], _corners[i + 2]);
        }

        var firsts = new List<int>();
        int[] pieces = new int[_component.Length];
        var numbers = new Dictionary<int, int>();
        for (int i = 0; i < _corners.Length; i++)
        {
            int root = Root(_corners[i]);
            if (!numbers.TryGetValue(root, out int number))
            {
                numbers.Add(root, number = firsts.Count);
                firsts.Add(i / 3);
            }

            pieces[_indices[i]] = number;
        }

        Components = firsts.ToArray();
        if (firsts.Count > 1) Pieces = pieces;
    }

    private void Join(int a, int b)
    {
        int rootA = Root(a), rootB = Root(b);
        _component[Math.Max(rootA, rootB)] = Math.Min(rootA, rootB);
    }

    private int Root(int vertex)
    {
        while (_component[vertex] != vertex)
            vertex = _component[vertex] = _component[_component[vertex]];
        return vertex;
    }
}
