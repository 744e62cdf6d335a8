namespace Gjk.Core;

/// <summary>A closed surface of triangles between points of A - B, which grows by one point at a time (van den Bergen
/// 2001): the faces that the point lies above go, and their rim is joined to the point.</summary>
/// <remarks>
/// <para>Each face keeps a height: the least of its vertices' offsets from the origin along its normal, negative when
/// the origin is outside. However rounding has turned the normal, the whole face lies no nearer the origin than that.
/// So where all heights are at least r and positive, the surface is closed and the ball of radius r is inside it; the
/// surface need not be convex, and rounding may leave it dented.</para>
/// <para>Closed is a matter of bookkeeping alone: each edge is run through once in each direction. A search of the
/// faces that go, depth first and edge by edge in turn, comes to their rim's edges in their own order, so each new face
/// lies beside the next. Where they have an island or more between them it does not; then edges are paired by their
/// vertices, and any pairing keeps the surface closed.</para>
/// <para>New faces are made four at a time, in slots behind all others, since four normals cost hardly more than one
/// where the processor has lanes for them (<c>Polytope.Lanes.cs</c>, with the bits of the same steps one by one). Slots
/// of faces that are gone come back when all are used. The memory is the caller's stack.</para>
/// </remarks>
internal unsafe partial struct Polytope
{
    /// <summary>Counts: vertices and faces that there is room for; 40 kilobytes. A surface of so many vertices has at
    /// most 284 faces. Pinned by StackTests.</summary>
    public const int Room = 144, MostFaces = 336;

    private const int BytesPerVertex = 96, BytesPerFace = 64, Alignment = 64;

    /// <summary>Count: room for the edges of the faces that are removed, and for those of their rim. The first face
    /// adds three edges, each other one at most one.</summary>
    private const int MostEdges = MostFaces + 4;

    /// <summary>Counts: the room that a search begins with. Mono clears what is allocated on the stack, 40 kilobytes as
    /// slowly as ten vertices are found, so there a search moves when it has outgrown the first room.</summary>
#if NET
    private const int FirstRoom = Room, FirstFaces = MostFaces;
#else
    private const int FirstRoom = 24, FirstFaces = 128;
#endif

    /// <summary>How many doubles of memory a polytope needs; and one with the first room.</summary>
    public const int Doubles = (Alignment + MostFaces * (BytesPerFace + sizeof(double)) + Room * BytesPerVertex
        + MostCuts * 3 * sizeof(double) + 2 * MostEdges * sizeof(ushort)) / sizeof(double),
        FirstDoubles = Doubles - ((MostFaces - FirstFaces) * (BytesPerFace + sizeof(double))
        + (Room - FirstRoom) * BytesPerVertex) / sizeof(double);

    private readonly DifferenceVertex* _vertices;
    private readonly PolytopeFace* _faces;

    /// <summary>What orders the faces by height; see <see cref="KeyOf"/>.</summary>
    private readonly double* _keys;

    private readonly Double3* _cuts;

    /// <summary>Edges to look across, and the rim's outer edges: a face's number times 4 plus the edge's.</summary>
    private readonly ushort* _stack, _rim;

    private double _noise, _level;
    private int _room, _lastFace, _vertexCount, _faceCount, _cutCount;

    /// <summary>A polytope without vertices.</summary>
    /// <param name="memory">As many doubles as <see cref="Doubles"/> or <see cref="FirstDoubles"/> says.</param>
    /// <param name="isFirst">With the first room.</param>
    public Polytope(double* memory, bool isFirst = false)
    {
        int faces = isFirst ? FirstFaces : MostFaces;
        _room = isFirst ? FirstRoom : Room;
        _lastFace = CanGrow ? FirstFaces - 2 * FirstRoom : MostFaces;
        _faces = (PolytopeFace*)(((ulong)memory + Alignment - 1) / Alignment * Alignment);
        _vertices = (DifferenceVertex*)(_faces + faces);
        _keys = (double*)(_vertices + _room);
        _cuts = (Double3*)(_keys + faces);
        _stack = (ushort*)(_cuts + MostCuts);
        _rim = _stack + MostEdges;
    }

    /// <summary>Whether a larger room is left to move to.</summary>
    public readonly bool CanGrow => _room < Room;

    /// <summary>Moves a polytope without cuts from its first room.</summary>
    /// <param name="memory">As many doubles as <see cref="Doubles"/> says.</param>
    public void Grow(double* memory)
    {
        var grown = new Polytope(memory);
        for (int i = 0; i < _faceCount; i++) (grown._faces[i], grown._keys[i]) = (_faces[i], _keys[i]);
        for (int i = 0; i < _vertexCount; i++) grown._vertices[i] = _vertices[i];
        (grown._noise, grown._level) = (_noise, _level);
        (grown._vertexCount, grown._faceCount) = (_vertexCount, _faceCount);
        this = grown;
    }

    /// <summary>How many faces there are or have been; some may be gone.</summary>
    public readonly int FaceCount => _faceCount;

    /// <summary>How many vertices were taken; not all need be on the surface.</summary>
    public readonly int VertexCount => _vertexCount;

    /// <summary>Whether there is room for another vertex; in the first room, for a face at each edge, too.</summary>
    public readonly bool HasRoom => _vertexCount + _cutCount < _room && _faceCount <= _lastFace;

    public readonly ref DifferenceVertex Vertex(int index) => ref _vertices[index];

    public readonly ref PolytopeFace Face(int index) => ref _faces[index];

    /// <summary>Whether the face is part of the surface.</summary>
    public readonly bool IsLive(int face) => _keys[face] < Gone;

    /// <summary>A place for a vertex, and its index.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public DifferenceVertex* Add(out int index)
    {
        index = _vertexCount++;
        return _vertices + index;
    }

    /// <summary>Takes a vertex of a simplex; returns its index.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Add(in Simplex simplex, int slot)
    {
        _vertices[_vertexCount] = simplex.At(slot);
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
        int b = 1, c = 2;
        Double3 origin = _vertices[0].W;
        Double3 normal = Double3.Cross(_vertices[b].W - origin, _vertices[c].W - origin);
        if (Double3.Dot(normal, _vertices[3].W - origin) > 0) (b, c) = (c, b);
        _faceCount = 4;
        _faces[0].SetVertices(0, b, c);
        _faces[1].SetVertices(0, c, 3);
        _faces[2].SetVertices(0, 3, b);
        _faces[3].SetVertices(b, 3, c);
        Join(0, 0, 2, 2);
        Join(0, 1, 3, 2);
        Join(0, 2, 1, 0);
        Join(1, 1, 3, 1);
        Join(1, 2, 2, 0);
        Join(2, 1, 3, 0);
        return TrySetFaces(0, 4, double.NegativeInfinity);
    }

    /// <summary>Puts a vertex above a face onto the surface.</summary>
    /// <param name="face">A face that the vertex lies above.</param>
    /// <param name="vertex">The vertex.</param>
    /// <param name="lowest">The least key of all faces where it is above 0; less where new faces may be lower.</param>
    /// <returns>False when there is no room; the surface is then no longer closed.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryExpand(int face, int vertex, double lowest)
    {
        int rim = IsDirection(vertex) ? RemoveBeyondCut(face, vertex) : RemoveVisible(face, _vertices[vertex].W);
        if (rim < 3 || (_faceCount + rim + 3 > MostFaces && !TryMakeRoom(rim))) return false;
        int first = _faceCount, last = first + rim - 1;
        bool isCycle = true;
        for (int i = 0, made = first; i < rim; i++, made++)
        {
            int twin = _rim[i], edge = twin & 3;
            PolytopeFace* outer = _faces + (twin >> 2), added = _faces + made;
            int from = outer->Vertices[Next(edge)], to = outer->Vertices[edge];
            isCycle &= i == 0 || added[-1].Vertices[1] == from;
            added->SetVertices(from, to, vertex);
            outer->Twins[edge] = (ushort)(made << 2);
            added->Twins[0] = (ushort)twin;
            added->Twins[1] = (ushort)((made == last ? first : made + 1) << 2 | 2);
            added->Twins[2] = (ushort)((made == first ? last : made - 1) << 2 | 1);
        }

        isCycle &= _faces[last].Vertices[1] == _faces[first].Vertices[0];
        if (!isCycle && !TryPair(first, rim)) return false;
        _faceCount += (rim + 3) & ~3;
        TrySetFaces(first, rim, lowest);
        return true;
    }

    /// <summary>Removes a face, and all faces that a point is above and that are connected to it over such
    /// faces.</summary>
    /// <returns>How many edges the rim has.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int RemoveVisible(int face, in Double3 point)
    {
        int height = BeginRim(face), rim = 0;
        while (height > 0)
        {
            int twin = _stack[--height], other = twin >> 2;
            if (_keys[other] == Gone) continue;
            PolytopeFace* next = _faces + other;
            if (Double3.Dot(next->Normal, point) > next->Limit) height = Cross(twin, height);
            else _rim[rim++] = (ushort)twin;
        }

        return rim;
    }

    /// <summary>Removes a face and pushes its edges, the first on top.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly int BeginRim(int face)
    {
        _keys[face] = Gone;
        _stack[0] = _faces[face].Twins[2];
        _stack[1] = _faces[face].Twins[1];
        _stack[2] = _faces[face].Twins[0];
        return 3;
    }

    /// <summary>Removes the face across an edge and pushes its other edges, the next on top.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly int Cross(int twin, int height)
    {
        PolytopeFace* face = _faces + (twin >> 2);
        int next = Next(twin & 3);
        _keys[twin >> 2] = Gone;
        _stack[height] = face->Twins[Next(next)];
        _stack[height + 1] = face->Twins[next];
        return height + 2;
    }

    /// <summary>Joins the new faces of a rim that is no cycle, each to one that begins where it ends.</summary>
    /// <returns>False where there is none left.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private readonly bool TryPair(int first, int rim)
    {
        int end = first + rim;
        for (int i = first; i < end; i++) _stack[i - first] = 0;
        for (int i = first; i < end; i++)
        {
            int next = first, begin = _faces[i].Vertices[1];
            while (next < end && (_stack[next - first] != 0 || _faces[next].Vertices[0] != begin)) next++;
            if (next == end) return false;
            _stack[next - first] = 1;
            Join(i, 1, next, 2);
        }

        return true;
    }

    /// <summary>Moves the faces that are there to the front, and the rim's edges with them.</summary>
    /// <returns>False when there still is no room for the faces of the rim.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool TryMakeRoom(int rim)
    {
        ushort* moved = _stack;
        int count = 0;
        for (int i = 0; i < _faceCount; i++)
        {
            if (!IsLive(i)) continue;
            moved[i] = (ushort)count;
            if (i != count) _faces[count] = _faces[i];
            _keys[count] = KeyOf(_keys[i], count);
            count++;
        }

        for (int i = 0; i < rim; i++) _rim[i] = (ushort)(moved[_rim[i] >> 2] << 2 | (_rim[i] & 3));
        for (int i = 0; i < count; i++)
        {
            for (int k = 0; k < 3; k++)
            {
                ref ushort twin = ref _faces[i].Twins[k];
                twin = (ushort)(moved[twin >> 2] << 2 | (twin & 3));
            }
        }

        while ((count & 3) != 0) _keys[count++] = Gone;
        _faceCount = count;
        return count + rim + 3 <= MostFaces;
    }

    private static int Next(int edge) => 9 >> (2 * edge) & 3;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly void Join(int face, int edge, int other, int otherEdge)
    {
        _faces[face].Twins[edge] = (ushort)(other << 2 | otherEdge);
        _faces[other].Twins[otherEdge] = (ushort)(face << 2 | edge);
    }
}
