namespace Gjk.Core;

/// <summary>Values whose bytes are whatever lay there: they are written before they are read.</summary>
internal static class Uncleared
{
    /// <summary>As <c>Unsafe.SkipInit</c>, which only the newer runtimes have.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Begin<T>(out T value)
        where T : unmanaged
    {
#if NET
        Unsafe.SkipInit(out value);
#else
        fixed (T* same = &value)
        {
        }
#endif
    }
}
