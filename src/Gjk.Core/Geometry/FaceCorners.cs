namespace Gjk.Core;

/// <summary>The corners of the face that a shape shows in a direction, in order around it: see <see
/// cref="ISupportMap.GetFace"/>. It lives on the stack of a query.</summary>
public unsafe ref struct FaceCorners
{
    /// <summary>How many corners there is room for; further ones are left out. A face with more is shown by some of
    /// them, spread evenly around it.</summary>
    public const int Capacity = 64;

    /// <summary>Count: a disc is shown by every fourth corner of a polygon that fills the room. Two such polygons,
    /// turned against each other, share 97 % of what discs share. Pinned by ContactAreaTests.</summary>
    internal const int DiscStep = 4;

    private readonly FaceCorner* _corners;

    /// <param name="memory">Room for <see cref="Capacity"/> corners.</param>
    internal FaceCorners(FaceCorner* memory) => _corners = memory;

    /// <summary>How many corners there are: none, a corner, an edge's two ends, or a face's.</summary>
    public int Count { get; private set; }

    /// <summary>The round side of the core that a single edge lies on.</summary>
    internal RoundSide Side { get; set; }

    /// <summary>The distance of that side's axis from the last corner, across the side; 0 where there is none, or an
    /// unknown one.</summary>
    internal double SideRadius { get; set; }

    /// <summary>The same from the first corner, which is a cone's tip.</summary>
    internal readonly double FirstRadius => Side == RoundSide.Cylinder ? SideRadius : 0;

    /// <summary>The frame of the outermost shape, as seen from the shape that is asked; null where angles are the same
    /// in both.</summary>
    internal OuterFrame* Outer { get; set; }

    /// <summary>Whether the corners are those of a disc, or of what scaling has made of one.</summary>
    internal bool IsDisc { get; set; }

    /// <summary>Adds the next corner around the face.</summary>
    /// <param name="point">Measured from the shape's <see cref="ISupportMap.Center"/>, in its local frame.</param>
    /// <param name="id">What tells the corner from the shape's others, from 0 to 2^30 - 1: contact points carry it from
    /// frame to frame.</param>
    public void Add(in Double3 point, int id)
    {
        if (_corners == null || Count == Capacity) return;
        _corners[Count++] = new FaceCorner(point, id);
    }

    /// <summary>An edge in the outermost frame.</summary>
    internal readonly Double3 ToOuter(in Double3 edge) => Outer == null ? edge : Outer->Outward(edge);

    /// <summary>The direction in which the face is asked for, in the outermost frame.</summary>
    internal readonly Double3 OuterDirection(in Double3 direction) => Outer == null ? direction : Outer->Direction;

    /// <summary>The cosine, in the outermost frame, between a unit normal and the direction, times the direction's
    /// length if both frames are one: for comparing normals.</summary>
    internal readonly double OuterCosine(in Double3 normal, in Double3 direction) =>
        Outer == null ? Double3.Dot(normal, direction) : Outer->Cosine(normal);

    /// <summary><see cref="OuterCosine"/> for the local axes as normals.</summary>
    internal readonly Double3 OuterCosines(in Double3 direction) => Outer == null
        ? direction
        : new(
            Outer->Cosine(new Double3(1, 0, 0)), Outer->Cosine(new Double3(0, 1, 0)),
            Outer->Cosine(new Double3(0, 0, 1)));

    /// <summary>A corner's place.</summary>
    /// <param name="index">From 0 to <see cref="Count"/> - 1, unchecked.</param>
    internal readonly ref Double3 this[int index] => ref _corners[index].Point;

    /// <summary>A corner's id.</summary>
    /// <param name="index">From 0 to <see cref="Count"/> - 1, unchecked.</param>
    internal readonly int IdOf(int index) => _corners[index].Id;
}

/// <summary>A corner of a face.</summary>
internal struct FaceCorner(in Double3 point, int id)
{
    /// <summary>The corner itself.</summary>
    public Double3 Point = point;

    /// <summary>What tells it from the others.</summary>
    public readonly int Id = id;
}

/// <summary>What an edge that a shape shows is a line of.</summary>
internal enum RoundSide : byte
{
    /// <summary>The edge is sharp.</summary>
    None,

    /// <summary>A cylinder's side.</summary>
    Cylinder,

    /// <summary>A cone's side; the first corner is its tip.</summary>
    Cone,

    /// <summary>One that scaling has made of those.</summary>
    Unknown,
}
