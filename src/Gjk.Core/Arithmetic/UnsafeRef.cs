namespace Gjk.Core;

/// <summary>What <c>System.Runtime.CompilerServices.Unsafe</c> offers, for netstandard2.0 too: references to values
/// that are not initialized, and writable references to readonly ones.</summary>
internal static class UnsafeRef
{
    /// <summary><c>Unsafe.SkipInit</c>, which only the newer runtimes have.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void SkipInit<T>(out T value)
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

    /// <summary>A writable reference to one of several values that lie one behind the other.</summary>
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

    /// <summary><c>Unsafe.As</c>: a value as one of another type, which it is known to be.</summary>
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
