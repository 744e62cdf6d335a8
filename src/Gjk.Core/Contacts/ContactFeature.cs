namespace Gjk.Core;

/// <summary>The numbers of contact points: A's part in the upper half, B's in the lower, each a kind and a corner's
/// id.</summary>
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

    /// <summary>Whether one number comes before another: by their smaller halves, then by their larger ones, so that
    /// that of most points stays where bodies move and <see cref="PairOrder"/> changes, then by A's.</summary>
    public static bool IsBefore(long one, long other)
    {
        uint a = (uint)(one >> Half & LowerHalf), b = (uint)(one & LowerHalf);
        uint otherA = (uint)(other >> Half & LowerHalf), otherB = (uint)(other & LowerHalf);
        uint least = Math.Min(a, b), otherLeast = Math.Min(otherA, otherB);
        uint most = Math.Max(a, b), otherMost = Math.Max(otherA, otherB);
        return least != otherLeast ? least < otherLeast : most != otherMost ? most < otherMost : a < otherA;
    }

    /// <summary>The number with A and B exchanged.</summary>
    public static long Swapped(long id) => Of((uint)(id & LowerHalf), (uint)(id >> Half & LowerHalf));
}
