namespace Gjk.Core;

/// <summary>Asks the processor to fetch what a loop over pairs will need: the second object of a pair may be anywhere
/// in memory, and a query is too long for the processor to look beyond it by itself. It changes no result; where there
/// is no such instruction nothing happens.</summary>
internal static class Prefetch
{
    /// <summary>Pairs: how far ahead; a few queries are some hundred nanoseconds, as long as the way to the memory. A
    /// matter of speed only.</summary>
    public const int PairsAhead = 4;

#if NET
    /// <summary>Bytes that are fetched at once, on all processors that have the instruction.</summary>
    private const int CacheLine = 64;
#endif

    /// <summary>The shape and the pose of the pair's second object; the first is near that of the pair
    /// before.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Objects<TShape, TPose>(ref TShape shape, ref TPose pose)
    {
        Item(ref shape);
        Item(ref pose);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static unsafe void Item<T>(ref T item)
    {
#if NET
        if (!Sse.IsSupported) return;
        byte* start = (byte*)Unsafe.AsPointer(ref item);
        for (int offset = 0; offset < Unsafe.SizeOf<T>(); offset += CacheLine) Sse.Prefetch0(start + offset);
#endif
    }
}
