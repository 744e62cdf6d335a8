#if NET
using System.Runtime.CompilerServices;
#endif

namespace Gjk.Core;

/// <summary>Finds the box that a shape is: a box, a mesh that is one, or either in a closed type.</summary>
/// <typeparam name="T">The shape's type.</typeparam>
internal static class BoxOf<T>
    where T : struct, ISupportMap
{
    /// <summary>
    /// A delegate, since a struct of a type that is not known cannot be cast without a copy on the heap.
    /// </summary>
    private static readonly Getter? Find = Make();

    private delegate bool Getter(ref T shape, out BoxCore box);

    /// <summary>The box that a shape is, margin included; false when it is none.</summary>
    public static bool TryGet(ref T shape, out BoxCore box)
    {
#if NET
        if (typeof(T) == typeof(BoxCore))
        {
            box = Unsafe.As<T, BoxCore>(ref shape);
            return true;
        }
#endif
        box = default;
        return Find is not null && Find(ref shape, out box);
    }

    private static Getter? Make()
    {
        if (typeof(T) == typeof(BoxShape)) return (Getter)(object)new BoxOf<BoxShape>.Getter(OfBox);
        if (typeof(T) == typeof(ConvexMesh)) return (Getter)(object)new BoxOf<ConvexMesh>.Getter(OfMesh);
        if (typeof(T) == typeof(ConvexShape)) return (Getter)(object)new BoxOf<ConvexShape>.Getter(OfShape);
        return typeof(T) == typeof(BoxCore) ? (Getter)(object)new BoxOf<BoxCore>.Getter(OfCore) : null;
    }

    private static bool OfBox(ref BoxShape shape, out BoxCore box)
    {
        shape.Get(out box);
        return true;
    }

    private static bool OfMesh(ref ConvexMesh shape, out BoxCore box)
    {
        box = default;
        if (shape.Core != CoreKind.Box) return false;
        shape.Get(out box);
        return true;
    }

    private static bool OfShape(ref ConvexShape shape, out BoxCore box)
    {
        box = default;
        if (shape.Core != CoreKind.Box) return false;
        shape.Get(out box);
        return true;
    }

    private static bool OfCore(ref BoxCore shape, out BoxCore box)
    {
        box = shape;
        return true;
    }
}
