#if NET
using System.Runtime.CompilerServices;
#else
using System;
using System.Reflection;
#endif

namespace Gjk.Core;

/// <summary>Asks a shape whose type may or may not show its faces, without a box where the runtime can.</summary>
/// <typeparam name="T">The shape's type.</typeparam>
internal static class FaceOf<T>
    where T : struct, ISupportMap
{
#if NET
    /// <summary>The face, edge or corner in a direction; nothing where the shape shows none.</summary>
    [MethodImpl(Jit.AtOnce)]
    public static void Get(in T shape, in Vector3D direction, ref FaceCorners corners)
    {
        // Whoever optimizes this sees the type, and no box is made; code that is compiled in a hurry would make one.
        if (shape is ISupportFace) ((ISupportFace)shape).GetFace(direction, ref corners);
    }
#else
    private static readonly bool ShowsFaces = typeof(ISupportFace).IsAssignableFrom(typeof(T));

    /// <summary>Null where there is none, or the runtime cannot make one; then the cast makes a box.</summary>
    private static readonly Getter? Find = ShowsFaces ? Make() : null;

    private delegate void Getter(ref T shape, in Vector3D direction, ref FaceCorners corners);

    /// <summary>The face, edge or corner in a direction; nothing where the shape shows none.</summary>
    public static void Get(in T shape, in Vector3D direction, ref FaceCorners corners)
    {
        T copy = shape;
        if (Find is not null) Find(ref copy, direction, ref corners);
        else if (ShowsFaces) ((ISupportFace)copy).GetFace(direction, ref corners);
    }

    /// <summary>
    /// A delegate of the type's own method, since a struct of a type that is not known cannot be cast without a copy on
    /// the heap.
    /// </summary>
    private static Getter? Make()
    {
        try
        {
            MethodInfo method = typeof(T).GetInterfaceMap(typeof(ISupportFace)).TargetMethods[0];
            return (Getter)Delegate.CreateDelegate(typeof(Getter), method);
        }
        catch (Exception e) when (e is ArgumentException or NotSupportedException or MemberAccessException)
        {
            return null;
        }
    }
#endif
}
