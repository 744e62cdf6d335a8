namespace Gjk.Core;

/// <summary>The surface of A - B as directions of one cell see it, so that a surface of any number of faces can be
/// proved part by part in little memory.</summary>
/// <remarks>
/// <para>A cell is what half-spaces leave of all directions: those n with n·d at most 0 for each of its cuts d. Each
/// cut is a vertex at infinity, in the direction d. The surface with it is that of A - B and all rays along the cuts,
/// which no direction of the cell sees and which hide A - B from all others. So a cut is an ordinary step of the
/// expansion: the faces whose normals lie beyond it go, and their rim is joined to the ray. The faces that are left
/// have normals of the cell, and where all their heights are at least r, no direction of the cell has a shorter way out
/// than r.</para>
/// <para>Two cells that a cut divides share its great circle, and rounding turns a border by a few units in the last
/// place: what lies between them moves a height by as little as a rounding of the size does.</para>
/// </remarks>
internal unsafe partial struct Polytope
{
    /// <summary>Count: each halves a cell, so the last one is far smaller than any face that double can tell.</summary>
    public const int MostCuts = 48;

    /// <summary>Cosine: a normal counts as beyond a cut when it leans over it by more than this, some roundings.
    /// Another amount moves a few faces from one cell to its neighbour.</summary>
    private const double CutNoise = 64 * RoundOff.Unit;

    /// <summary>The key of a face between three rays, which no direction sees: above all others.</summary>
    private const double AtInfinity = 1e300;

    /// <summary>Vertices that a cell begins with: those of the tetrahedron, which stay where they are.</summary>
    private const int Kept = 4;

    /// <summary>How many cuts there are.</summary>
    public readonly int CutCount => _cutCount;

    /// <summary>Cuts off the directions on one side of a plane, and the vertices that only they see.</summary>
    /// <param name="direction">Of unit length.</param>
    /// <returns>False when there is no room; the surface is then no longer closed.</returns>
    public bool TryCut(in Double3 direction)
    {
        _cuts[_cutCount] = direction;
        int vertex = Room + _cutCount++, face = -1;
        double most = CutNoise;
        for (int i = 0; i < _faceCount; i++)
        {
            if (!IsLive(i)) continue;
            double cosine = Double3.Dot(_faces[i].UnitNormal, direction);
            if (!(cosine > most)) continue;
            most = cosine;
            face = i;
        }

        if (face < 0) return true;
        if (!TryExpand(face, vertex, double.NegativeInfinity)) return false;
        DropUnused();
        return true;
    }

    /// <summary>Begins the cell across a cut: the tetrahedron, the cuts before that one, and that one turned
    /// round.</summary>
    /// <param name="cut">The cut's number; those after it are forgotten.</param>
    /// <returns>False when there is no room; the surface is then no longer closed.</returns>
    public bool TryCross(int cut)
    {
        _vertexCount = Kept;
        _cutCount = 0;
        _cuts[cut] = -_cuts[cut];
        bool isWhole = TrySetTetrahedron(_noise, _level);
        while (isWhole && _cutCount <= cut) isWhole = TryCut(_cuts[_cutCount]);
        return isWhole;
    }

    /// <summary>A cut that separates the two faces below a height whose normals are about the furthest apart.</summary>
    /// <param name="limit">There is such a face.</param>
    public readonly Double3 BisectingCut(double limit)
    {
        int first = FurthestFrom(Lowest(out _), limit), second = FurthestFrom(first, limit);
        Double3 between = _faces[second].UnitNormal - _faces[first].UnitNormal;
        double length = between.Length;
        return length > 0 ? between * (1 / length) : _faces[first].UnitNormal;
    }

    private readonly int FurthestFrom(int face, double limit)
    {
        int furthest = face;
        double least = double.PositiveInfinity;
        for (int i = 0; i < _faceCount; i++)
        {
            if (!IsLive(i) || !(_faces[i].Height < limit)) continue;
            double cosine = Double3.Dot(_faces[i].UnitNormal, _faces[face].UnitNormal);
            if (!(cosine < least)) continue;
            least = cosine;
            furthest = i;
        }

        return furthest;
    }

    private static bool IsDirection(int vertex) => vertex >= Room;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsOpen(PolytopeFace* face) =>
        IsDirection(face->Vertices[0]) || IsDirection(face->Vertices[1]) || IsDirection(face->Vertices[2]);

    /// <summary><see cref="RemoveVisible"/> for a cut: what its ray sees.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private readonly int RemoveBeyondCut(int face, int cut)
    {
        Double3 direction = _cuts[cut - Room];
        int height = BeginRim(face), rim = 0;
        while (height > 0)
        {
            int twin = _stack[--height], other = twin >> 2;
            if (_keys[other] == Gone) continue;
            Double3 normal = _faces[other].Normal;
            bool isBeyond = Double3.Dot(normal, direction) > CutNoise * normal.SumOfMagnitudes;
            if (isBeyond) height = Cross(twin, height);
            else _rim[rim++] = (ushort)twin;
        }

        return rim;
    }

    /// <summary>Moves the vertices that faces have to the front, and forgets the others.</summary>
    private void DropUnused()
    {
        const ushort none = ushort.MaxValue;
        ushort* moved = _stack;
        for (int i = 0; i < Room + MostCuts; i++) moved[i] = i < Kept ? (ushort)0 : none;
        for (int i = 0; i < _faceCount; i++)
        {
            for (int k = 0; k < 3 && IsLive(i); k++) moved[_faces[i].Vertices[k]] = 0;
        }

        int count = 0;
        for (int i = 0; i < _vertexCount; i++)
        {
            if (moved[i] == none) continue;
            moved[i] = (ushort)count;
            _vertices[count++] = _vertices[i];
        }

        for (int i = 0; i < _faceCount; i++)
        {
            for (int k = 0; k < 3 && IsLive(i); k++)
            {
                ref ushort vertex = ref _faces[i].Vertices[k];
                if (!IsDirection(vertex)) vertex = moved[vertex];
            }
        }

        _vertexCount = count;
    }

    /// <summary>Sets the normal and the height of a face with a vertex at infinity.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private readonly void SetOpenFace(int index)
    {
        PolytopeFace* face = _faces + index;
        int first = 0;
        while (first < 3 && IsDirection(face->Vertices[first])) first++;
        Double3 normal = default, from = default;
        if (first < 3)
        {
            int second = face->Vertices[Next(first)], third = face->Vertices[Next(Next(first))];
            from = _vertices[face->Vertices[first]].W;
            var cross = (Double3)VectorDD.Cross(Edge(from, second), Edge(from, third));
            double length = cross.Length;
            PolytopeFace* beside = _faces + (face->Twins[0] >> 2);
            normal = length > 0 ? cross * (1 / length) : beside->NormalSquared > 0 ? beside->UnitNormal : default;
        }

        double least = Double3.Dot(normal, from);
        for (int k = 0; k < 3; k++)
        {
            int vertex = face->Vertices[k];
            if (!IsDirection(vertex)) least = Math.Min(least, Double3.Dot(normal, _vertices[vertex].W));
        }

        SetNormal(index, normal, least);
        if (normal != default) return;
        face->Offset = double.PositiveInfinity;
        _keys[index] = KeyOf(AtInfinity, index);
    }

    /// <summary>From a point to a vertex, or along a ray.</summary>
    private readonly VectorDD Edge(in Double3 from, int to) =>
        IsDirection(to) ? _cuts[to - Room] : (VectorDD)_vertices[to].W - from;
}
