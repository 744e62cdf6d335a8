#if NET
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <summary>What every step in lanes needs: choices by mask, signs, and the two halves of slots.</summary>
internal static class WideLanes
{
    /// <summary>a in the lanes of the mask, b in the others.</summary>
    public static Lanes Select(Lanes mask, Lanes a, Lanes b) => Vector256.ConditionalSelect(mask, a, b);

    /// <inheritdoc cref="Select(Lanes, Lanes, Lanes)"/>
    public static Vector256<long> Select(Lanes mask, Vector256<long> a, Vector256<long> b) =>
        Vector256.ConditionalSelect(mask.AsInt64(), a, b);

    /// <summary>1 or -1, as the number; 1 for a zero of either sign.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes SignOf(Lanes x) => ((x + Lanes.Zero) & Vector256.Create(-0.0)) | Lanes.One;

    /// <summary>A's half of slots; see <see cref="WidePairs.SlotsA"/>.</summary>
    public static Vector256<long> Low(Vector256<long> slots) => slots & Vector256.Create((long)uint.MaxValue);

    /// <summary>B's half of slots.</summary>
    public static Vector256<long> High(Vector256<long> slots) => Vector256.ShiftRightLogical(slots, 32);

    /// <summary>The ids below their counts, and 0 for others, which are not found.</summary>
    public static Vector256<long> Below(Vector256<long> counts, Vector256<long> ids, ref Lanes found)
    {
        Vector256<long> isThere = Vector256.LessThan(ids, counts);
        found &= isThere.AsDouble();
        return ids & isThere;
    }
}
#endif
