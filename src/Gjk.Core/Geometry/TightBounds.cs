using System;

namespace Gjk.Core;

/// <summary>
/// Whether a type's <see cref="ISupportMap.BoundingRadius"/> is the distance of a point of the shape, or nearly so.
/// </summary>
internal static class TightBounds<T>
    where T : struct, ISupportMap
{
    /// <summary>
    /// Tolerances follow a tight radius, so the library's own shapes must report one; a user's may be generous, and is
    /// measured. True for the library's own shapes and for decorators of these, and for those that measure what is
    /// inside; false for a user's.
    /// </summary>
    public static readonly bool Are = IsTight(typeof(T));

    private static bool IsTight(Type type)
    {
        if (type.Assembly != typeof(ISupportMap).Assembly) return false;
        return !type.IsGenericType || type.IsDefined(typeof(MeasuresRadiusAttribute), false)
            || IsTight(type.GetGenericArguments()[0]);
    }
}

/// <summary>
/// Marks a decorator that measures its bounding radius, so that it is tight whatever the shape inside reports.
/// </summary>
[AttributeUsage(AttributeTargets.Struct)]
internal sealed class MeasuresRadiusAttribute : Attribute
{
}
