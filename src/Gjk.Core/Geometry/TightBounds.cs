using System;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// Whether a type's <see cref="ISupportMap.BoundingRadius"/> is the distance of a point of the shape, or nearly so.
/// </summary>
internal static class TightBounds<T>
    where T : struct, ISupportMap
{
    private static readonly bool AreInside = IsTight(typeof(T));

    /// <summary>
    /// Tolerances follow a tight radius, so the library's own shapes must report one; a user's may be generous, and is
    /// measured. True for the library's own shapes and for decorators of these, and for those that measure what is
    /// inside; false for a user's.
    /// </summary>
    public static bool Are
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
#if NET
            // Known when the code is compiled.
            if (typeof(ITightBounds).IsAssignableFrom(typeof(T))) return true;
#endif
            return AreInside;
        }
    }

    /// <summary>Of a decorator that is not tight by itself: what is inside it.</summary>
    private static bool IsTight(Type type) =>
        typeof(ITightBounds).IsAssignableFrom(type)
        || (type.Assembly == typeof(ISupportMap).Assembly && type.IsGenericType
            && IsTight(type.GetGenericArguments()[0]));
}

/// <summary>
/// Marks a shape of the library whose bounding radius is tight, or a decorator that measures it, so that it is tight
/// whatever the shape inside reports.
/// </summary>
internal interface ITightBounds
{
}
