namespace Gjk.Core;

/// <summary>A closed surface of triangles, which can be removed and added. Holds the faces' planes and their
/// half-edges.</summary>
/// <remarks>Half-edge 3 f + e is edge e of face f. It leads from its origin to the origin of the face's next half-edge.
/// Not thread-safe: one per build.</remarks>
internal sealed class HullSurface(HullPredicates predicates)
{
    public struct Face
    {
        public HullPlane Plane;

        /// <summary>The largest height in the list. Rounded: the choice of a point is a matter of speed.</summary>
        public double FurthestHeight;

        /// <summary>Head of the list of points above, -1 when empty.</summary>
        public int FirstAbove;
        public int Furthest;

        /// <summary>The number of the step that last tested the face; negative when it was hidden.</summary>
        public int Stamp;

        /// <summary>The number of the walk that last tested the face.</summary>
        public int Walk;
    }

    private const int Dead = -1;
    private const int FirstCapacity = 64;

    private readonly List<int> _free = new();
    private Face[] _faces = new Face[FirstCapacity];
    private int[] _origin = new int[3 * FirstCapacity];
    private int[] _twin = new int[3 * FirstCapacity];
    private int _faceCount;

    /// <summary>By face. Another array after <see cref="AddFace"/>.</summary>
    public Face[] Faces => _faces;

    /// <summary>By half-edge, the one on the other side. Another array after <see cref="AddFace"/>.</summary>
    public int[] Twins => _twin;

    /// <summary>Half-edges are numbered from 0 up to this; some belong to no face.</summary>
    public int HalfEdgeLimit => 3 * _faceCount;

    public static int Next(int halfEdge) => halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1;

    public bool IsAlive(int halfEdge) => _origin[halfEdge] != Dead;

    public int Origin(int halfEdge) => _origin[halfEdge];

    public int Twin(int halfEdge) => _twin[halfEdge];

    /// <summary>True when the faces on both sides of the edge lie in one plane.</summary>
    public bool IsFlat(int halfEdge)
    {
        int apex = _origin[Next(Next(_twin[halfEdge]))];
        return predicates.Side(_faces[halfEdge / 3].Plane, apex, out _) == 0;
    }

    /// <summary>Adds a face, counter-clockwise seen from outside; its edges are yet to be linked.</summary>
    public int AddFace(int a, int b, int c)
    {
        int face;
        if (_free.Count > 0)
        {
            face = _free[_free.Count - 1];
            _free.RemoveAt(_free.Count - 1);
        }
        else
        {
            face = _faceCount++;
            if (face == _faces.Length)
            {
                Array.Resize(ref _faces, 2 * face);
                Array.Resize(ref _origin, 6 * face);
                Array.Resize(ref _twin, 6 * face);
            }
        }

        _faces[face] = new Face { Plane = predicates.PlaneThrough(a, b, c), FirstAbove = -1 };
        _origin[3 * face] = a;
        _origin[3 * face + 1] = b;
        _origin[3 * face + 2] = c;
        return face;
    }

    public void Remove(int face)
    {
        _faces[face].FirstAbove = -1;
        _origin[3 * face] = _origin[3 * face + 1] = _origin[3 * face + 2] = Dead;
        _free.Add(face);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Link(int halfEdge, int other)
    {
        _twin[halfEdge] = other;
        _twin[other] = halfEdge;
    }
}
