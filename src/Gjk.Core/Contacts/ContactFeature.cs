namespace Gjk.Core;

/// <summary>
/// The numbers of contact points: A's part in the upper half, B's in the lower, each a kind and a corner's id.
/// </summary>
internal static class ContactFeature
{
    private const int Half = 32;
    private const long LowerHalf = (1L << Half) - 1;

    /// <summary>A part that says nothing: of a round side, or of a face, which the other's corner names.</summary>
    public const uint None = 0;

    /// <summary>A corner.</summary>
    public static uint Corner(int id) => (uint)id << 2 | 1;

    /// <summary>The corner that a shape shows, if it shows nothing else.</summary>
    public static uint OnlyCorner(in FaceCorners corners) => corners.Count == 1 ? Corner(corners.IdOf(0)) : None;

    /// <summary>The edge of a face that begins at a corner.</summary>
    public static uint Edge(int id) => (uint)id << 2 | 2;

    /// <summary>The number of a point.</summary>
    public static long Of(uint a, uint b) => (long)((ulong)a << Half | b);

    /// <summary>The number with A and B exchanged.</summary>
    public static long Swapped(long id) => Of((uint)(id & LowerHalf), (uint)(id >> Half & LowerHalf));
}
