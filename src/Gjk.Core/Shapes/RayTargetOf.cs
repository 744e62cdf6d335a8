using System.Runtime.CompilerServices;
#if !NET
using System;
using System.Reflection;
#endif

namespace Gjk.Core;

/// <summary>
/// Asks a shape whose type may be unknown what a ray sees of it, without a box where the runtime can.
/// </summary>
/// <typeparam name="T">The shape's type.</typeparam>
internal static class RayTargetOf<T>
    where T : struct, ISupportMap
{
    /// <summary>
    /// The commonest bodies in short, without a <see cref="RayTarget"/>: a ball or a box about the local origin; None
    /// for everything else. Which types can be one is known when the code is compiled.
    /// </summary>
    /// <param name="shape">The shape.</param>
    /// <param name="size">The ball's radius, three times; or half the box's sides.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static RayForm GetPlain(ref T shape, out Vector3D size)
    {
        if (typeof(T) == typeof(ConvexShape)) return As<ConvexShape>(ref shape).GetPlain(out size);
        bool isBall = typeof(T) == typeof(SphereShape), isBox = typeof(T) == typeof(BoxShape);
        size = isBall ? new Vector3D(1, 1, 1) * As<SphereShape>(ref shape).Radius
            : isBox ? (Vector3D)As<BoxShape>(ref shape).HalfExtents
            : default;
        return isBall ? RayForm.Ball : isBox ? RayForm.Box : RayForm.None;
    }

    /// <summary>The shape as the type that it is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#if NET
    private static ref TShape As<TShape>(ref T shape)
        where TShape : struct =>
        ref Unsafe.As<T, TShape>(ref shape);
#else
    private static unsafe ref TShape As<TShape>(ref T shape)
        where TShape : struct
    {
#pragma warning disable CS8500 // The two are one type, so what the garbage collector sees does not change.
        fixed (T* same = &shape) return ref *(TShape*)same;
#pragma warning restore CS8500
    }
#endif

#if NET
    /// <summary>The body; false for a user's shape and for what no closed form fits.</summary>
    [MethodImpl(Jit.AtOnce)]
    public static bool TryGet(ref T shape, out RayTarget target)
    {
        // As an interface, the largest of the shapes would be copied.
        if (typeof(T) == typeof(ConvexShape)) return Unsafe.As<T, ConvexShape>(ref shape).TryGetTarget(out target);

        // Whoever optimizes this sees the type, and no box is made; code that is compiled in a hurry would make one.
        if (shape is IRayTarget) return ((IRayTarget)shape).TryGetTarget(out target);
        target = default;
        return false;
    }
#else
    private static readonly bool IsTarget = typeof(IRayTarget).IsAssignableFrom(typeof(T));

    /// <summary>Null where there is none, or the runtime cannot make one; then the cast makes a box.</summary>
    private static readonly Getter? Find = IsTarget ? Make() : null;

    private delegate bool Getter(ref T shape, out RayTarget target);

    /// <summary>The body; false for a user's shape and for what no closed form fits.</summary>
    public static bool TryGet(ref T shape, out RayTarget target)
    {
        target = default;
        if (Find is not null) return Find(ref shape, out target);
        return IsTarget && ((IRayTarget)shape).TryGetTarget(out target);
    }

    /// <summary>
    /// A delegate of the type's own method, since a struct of a type that is not known cannot be cast without a copy on
    /// the heap.
    /// </summary>
    private static Getter? Make()
    {
        try
        {
            MethodInfo method = typeof(T).GetInterfaceMap(typeof(IRayTarget)).TargetMethods[0];
            return (Getter)Delegate.CreateDelegate(typeof(Getter), method);
        }
        catch (Exception e) when (e is ArgumentException or NotSupportedException or MemberAccessException)
        {
            return null;
        }
    }
#endif
}
