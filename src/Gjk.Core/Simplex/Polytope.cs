using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// A closed surface of triangles between points of A - B, which grows by one point at a time (van den Bergen 2001): the
/// faces that the point lies above go, and their rim is joined to the point.
/// </summary>
/// <remarks>
/// <para>
/// Each face keeps a height: the least of its vertices' offsets from the origin along its normal, negative when the
/// origin is outside. However rounding has turned the normal, the whole face lies no nearer the origin than that. So
/// where all heights are at least r and positive, the surface is closed and the ball of radius r is inside it; the
/// surface need not be convex, and rounding may leave it dented.
/// </para>
/// <para>
/// Closed is a matter of bookkeeping alone: each edge is run through once in each direction. Where the rim passes a
/// vertex twice, any pairing of its new edges keeps that.
/// </para>
/// <para>
/// The memory is the caller's stack. A face that would be flat for sure takes the normal of its neighbour, in whose
/// plane it lies.
/// </para>
/// </remarks>
internal unsafe partial struct Polytope
{
    /// <summary>A face that is not there.</summary>
    private const double Gone = double.PositiveInfinity;

    /// <summary>No face.</summary>
    private const ushort None = ushort.MaxValue;

    private const int DoublesPerVertex = 10, DoublesPerFace = 5, DoublesPerCut = 3;

    /// <summary>A rim has at most two edges more than there are faces taken away.</summary>
    private const int RimSpare = 4;

    private readonly PolytopeVertex* _vertices;
    private readonly PolytopeFace* _faces;
    private readonly double* _heights;
    private readonly Vector3D* _cuts;

    /// <summary>
    /// Faces still to be looked across; free ones; the rim's outer edges; by vertex, a new face that begins there; by
    /// face, another one that begins where it does.
    /// </summary>
    private readonly ushort* _stack, _free, _rim, _fan, _sameFan;

    private readonly int _mostVertices, _mostFaces;
    private double _noise, _level;
    private int _vertexCount, _faceCount, _freeCount, _cutCount;
    private bool _isOpen;

    /// <summary>A polytope without vertices.</summary>
    /// <param name="memory">As many doubles as <see cref="Doubles"/> says.</param>
    /// <param name="mostVertices">How many vertices it has room for; at most 8,000, so that 16 bits number all.</param>
    public Polytope(double* memory, int mostVertices)
    {
        _mostVertices = mostVertices;
        _mostFaces = 2 * mostVertices;
        _noise = _level = 0;
        _vertexCount = _faceCount = _freeCount = _cutCount = 0;
        _isOpen = false;
        _vertices = (PolytopeVertex*)memory;
        memory += DoublesPerVertex * mostVertices;
        _faces = (PolytopeFace*)memory;
        memory += DoublesPerFace * _mostFaces;
        _heights = memory;
        _cuts = (Vector3D*)(memory + _mostFaces);
        _stack = (ushort*)(_cuts + MostCuts);
        _free = _stack + _mostFaces;
        _rim = _free + _mostFaces;
        _sameFan = _rim + _mostFaces + RimSpare;
        _fan = _sameFan + _mostFaces;
        for (int i = 0; i < mostVertices + MostCuts; i++) _fan[i] = None;
    }

    /// <summary>How much memory a polytope of so many vertices needs.</summary>
    public static int Doubles(int mostVertices)
    {
        int numbers = 2 * 4 * mostVertices + RimSpare + mostVertices + MostCuts;
        return (DoublesPerVertex + 2 * (DoublesPerFace + 1)) * mostVertices + DoublesPerCut * MostCuts
            + (numbers + 3) / 4;
    }

    /// <summary>How many faces there are or have been; some may be gone.</summary>
    public readonly int FaceCount => _faceCount;

    /// <summary>False after an expansion that found no room: nothing is proved by the faces then.</summary>
    public readonly bool IsClosed => !_isOpen;

    /// <summary>Whether there is room for another vertex.</summary>
    public readonly bool HasRoom => _vertexCount + _cutCount < _mostVertices;

    public readonly ref PolytopeVertex Vertex(int index) => ref _vertices[index];

    public readonly ref PolytopeFace Face(int index) => ref _faces[index];

    /// <summary>Whether the face is part of the surface.</summary>
    public readonly bool IsThere(int face) => _heights[face] < Gone;

    /// <summary>Takes a vertex of a simplex; returns its index.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Add(in Simplex simplex, int slot)
    {
        ref PolytopeVertex vertex = ref _vertices[_vertexCount];
        vertex.W = simplex.W(slot);
        vertex.OnA = simplex.OnA(slot);
        vertex.OnB = simplex.OnB(slot);
        vertex.IdA = simplex.IdA(slot);
        vertex.IdB = simplex.IdB(slot);
        return _vertexCount++;
    }

    /// <summary>Whether a vertex is one of those before it.</summary>
    public readonly bool Repeats(int vertex)
    {
        for (int i = 0; i < vertex; i++)
            if (_vertices[i].W == _vertices[vertex].W) return true;
        return false;
    }

    /// <summary>Forgets the newest vertex, which no face has.</summary>
    public void DropLast() => _vertexCount--;

    /// <summary>Makes the surface that of the first four vertices, in any order.</summary>
    /// <param name="noise">Length: a point counts as above a face when it is above it by more than this.</param>
    /// <param name="level">Length: how far a face's vertices may be from level before its normal is mended.</param>
    /// <returns>False when a face has no area, and so no normal.</returns>
    public bool TrySetTetrahedron(double noise, double level)
    {
        _noise = noise;
        _level = level;
        int a = 0, b = 1, c = 2, d = 3;
        Vector3D origin = _vertices[a].W;
        Vector3D normal = Vector3D.Cross(_vertices[b].W - origin, _vertices[c].W - origin);
        if (Vector3D.Dot(normal, _vertices[d].W - origin) > 0) (b, c) = (c, b);
        _faceCount = 4;
        SetFace(0, a, b, c, default);
        SetFace(1, a, c, d, default);
        SetFace(2, a, d, b, default);
        SetFace(3, b, d, c, default);
        Join(0, 0, 2, 2);
        Join(0, 1, 3, 2);
        Join(0, 2, 1, 0);
        Join(1, 1, 3, 1);
        Join(1, 2, 2, 0);
        Join(2, 1, 3, 0);
        return _faces[0].Normal != default && _faces[1].Normal != default
            && _faces[2].Normal != default && _faces[3].Normal != default;
    }

    /// <summary>The face of least height.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly int Lowest(out double height)
    {
        int lowest = 0;
        height = _heights[0];
        for (int i = 1; i < _faceCount; i++)
        {
            if (!(_heights[i] < height)) continue;
            height = _heights[i];
            lowest = i;
        }

        return lowest;
    }

    /// <summary>Puts a vertex above a face onto the surface.</summary>
    /// <param name="face">A face that the vertex lies above.</param>
    /// <param name="vertex">The vertex.</param>
    /// <param name="lowest">The least height of all faces.</param>
    /// <returns>False when there is no room; the surface is then no longer closed.</returns>
    public bool TryExpand(int face, int vertex, double lowest)
    {
        int rim = TakeAway(face, vertex);
        _isOpen = rim - _freeCount > _mostFaces - _faceCount;
        if (_isOpen) return false;
        ushort* added = _stack;
        for (int i = 0; i < rim; i++)
        {
            int twin = _rim[i], outer = twin >> 2, edge = twin & 3, made = NewFace();
            int from = _faces[outer].Vertices[Next(edge)], to = _faces[outer].Vertices[edge];
            SetFace(made, from, to, vertex, _faces[outer].Normal);
            Join(made, 0, outer, edge);
            _sameFan[made] = _fan[from];
            _fan[from] = added[i] = (ushort)made;
            if (_heights[made] < lowest && lowest > 0) Raise(made);
        }

        for (int i = 0; i < rim; i++)
        {
            int to = _faces[added[i]].Vertices[1], next = _fan[to];
            _isOpen = next == None;
            if (_isOpen) return false;
            _fan[to] = _sameFan[next];
            Join(added[i], 1, next, 2);
        }

        return true;
    }

    /// <summary>
    /// Takes away the face and all that can be reached from it across edges and that the point lies above too.
    /// </summary>
    /// <returns>How many edges the rim has.</returns>
    private int TakeAway(int face, int vertex)
    {
        int height = 0, rim = 0;
        bool isDirection = IsDirection(vertex);
        Vector3D point = isDirection ? _cuts[vertex - _mostVertices] : _vertices[vertex].W;
        double noise = isDirection ? CutNoise : _noise;
        _stack[height++] = (ushort)face;
        _heights[face] = Gone;
        while (height > 0)
        {
            int taken = _stack[--height];
            _free[_freeCount++] = (ushort)taken;
            for (int k = 0; k < 3; k++)
            {
                ushort twin = _faces[taken].Twins[k];
                int other = twin >> 2;
                double otherHeight = _heights[other];
                if (otherHeight == Gone) continue;
                if (Vector3D.Dot(_faces[other].Normal, point) - (isDirection ? 0 : otherHeight) > noise)
                {
                    _heights[other] = Gone;
                    _stack[height++] = (ushort)other;
                }
                else
                {
                    _rim[rim++] = twin;
                }
            }
        }

        return rim;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int NewFace() => _freeCount > 0 ? _free[--_freeCount] : _faceCount++;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Next(int edge) => edge == 2 ? 0 : edge + 1;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly void Join(int face, int edge, int other, int otherEdge)
    {
        _faces[face].Twins[edge] = (ushort)(other << 2 | otherEdge);
        _faces[other].Twins[otherEdge] = (ushort)(face << 2 | edge);
    }
}
