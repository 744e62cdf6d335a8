#if NET
using System.Runtime.CompilerServices;

#endif
namespace Gjk.Core;

/// <summary>Asks a shape whose type may or may not show its faces.</summary>
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
    /// <summary>
    /// A delegate, since a struct of a type that is not known cannot be cast without a copy on the heap; null for the
    /// types of which only the cast is left.
    /// </summary>
    private static readonly Getter? Find =
        Of<BoxShape>() ?? Of<ConvexMesh>() ?? Of<ConvexShape>() ?? Of<CapsuleShape>() ?? Of<CylinderShape>()
        ?? Of<ConeShape>() ?? Of<SegmentShape>() ?? Of<TriangleShape>();

    private static readonly bool ShowsFaces = typeof(ISupportFace).IsAssignableFrom(typeof(T));

    private delegate void Getter(in T shape, in Vector3D direction, ref FaceCorners corners);

    /// <summary>The face, edge or corner in a direction; nothing where the shape shows none.</summary>
    public static void Get(in T shape, in Vector3D direction, ref FaceCorners corners)
    {
        if (Find is not null) Find(shape, direction, ref corners);
        else if (ShowsFaces) ((ISupportFace)shape).GetFace(direction, ref corners);
    }

    private static Getter? Of<TShape>()
        where TShape : struct, ISupportMap, ISupportFace =>
        typeof(T) == typeof(TShape) ? (Getter)(object)new FaceOf<TShape>.Getter(Known<TShape>.Get) : null;
#endif
}

#if !NET
/// <summary>A shape's face, without a box.</summary>
internal static class Known<TShape>
    where TShape : struct, ISupportFace
{
    public static void Get(in TShape shape, in Vector3D direction, ref FaceCorners corners) =>
        shape.GetFace(direction, ref corners);
}
#endif
