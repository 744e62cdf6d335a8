namespace Gjk.Core;

/// <summary>References that the compiler does not vouch for: to values that are written before they are read, and to
/// readonly ones.</summary>
internal static class Uncleared
{
    /// <summary>As <c>Unsafe.SkipInit</c>, which only the newer runtimes have.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Begin<T>(out T value)
        where T : struct
    {
#if NET
        Unsafe.SkipInit(out value);
#else
#pragma warning disable CS8500 // Nothing goes through the pointer.
        fixed (T* same = &value)
        {
        }
#pragma warning restore CS8500
#endif
    }

    /// <summary>One of some values that follow each other, by a reference that can be written through.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe ref T At<T>(scoped in T first, int index)
        where T : struct
    {
#if NET
        return ref Unsafe.Add(ref Unsafe.AsRef(in first), index);
#else
#pragma warning disable CS8500 // The pointer is a reference again before the garbage collector may move anything.
        fixed (T* same = &first) return ref same[index];
#pragma warning restore CS8500
#endif
    }

    /// <summary>A value as one of another type, which it is known to be.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe ref TTo As<T, TTo>(ref T value)
    {
#if NET
        return ref Unsafe.As<T, TTo>(ref value);
#else
#pragma warning disable CS8500 // The pointer is a reference again before the garbage collector may move anything.
        fixed (T* same = &value) return ref *(TTo*)same;
#pragma warning restore CS8500
#endif
    }
}
