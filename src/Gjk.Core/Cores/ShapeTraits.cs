namespace Gjk.Core;

/// <summary>What a type of shape can do besides <see cref="ISupportMap"/>: the one place that queries ask, on every
/// form. A user's type can do nothing more.</summary>
/// <remarks>A struct of a type that is not known can only be cast to an interface through a copy on the heap, so it is
/// done once for each type: the shape makes an object that calls it by its own type. Compilers that optimize see
/// through it.</remarks>
/// <typeparam name="T">The shape's type.</typeparam>
internal class ShapeTraits<T>
    where T : struct, ISupportMap
{
    /// <summary>Those of the type.</summary>
    public static readonly ShapeTraits<T> Instance =
        default(T) is ILibraryShape shape ? (ShapeTraits<T>)shape.MakeTraits() : new ShapeTraits<T>();

    /// <summary>Whether <see cref="ISupportMap.BoundingRadius"/> is the distance of a point of the shape, or nearly so.
    /// Tolerances follow a tight radius, so the library's own shapes report one, and decorators of these; a user's may
    /// be generous, and is measured.</summary>
    public static readonly bool AreTight = Instance.IsTight;

    /// <summary>Whether a shape of the type may be placed, so that its core has axes of its own.</summary>
    public static readonly bool CanBePlaced = Instance.MayBePlaced;

    /// <inheritdoc cref="AreTight"/>
    protected virtual bool IsTight => false;

    /// <inheritdoc cref="CanBePlaced"/>
    protected virtual bool MayBePlaced => false;

    /// <summary>Where a shape's core is in its frame; null where it is not placed.</summary>
    public virtual Placement? PlacementOf(ref T shape) => null;

    /// <summary>The shape in the axes of its core; itself where it is not placed.</summary>
    public virtual T InCoreAxes(in T shape) => shape;

    /// <inheritdoc cref="ILibraryShape.TryGetForm"/>
    public virtual bool TryGetForm(ref T shape, out ShapeForm form) => ShapeForm.None(out form);

    /// <inheritdoc cref="IPlainBody.GetPlain"/>
    public virtual FormKind GetPlain(ref T shape, out Double3 size)
    {
        size = default;
        return FormKind.None;
    }
}

/// <summary>One of the library's own shapes.</summary>
internal interface ILibraryShape : ISupportMap
{
    /// <summary>A <see cref="ShapeTraits{T}"/> of this type; asked of a <c>default</c> struct.</summary>
    object MakeTraits();

    /// <summary>What rays and the searches for a depth see of it.</summary>
    /// <returns>False where it is none of the bodies that <see cref="FormKind"/> names.</returns>
    bool TryGetForm(out ShapeForm form);
}

/// <summary>A shape that may be placed.</summary>
/// <typeparam name="T">Its own type.</typeparam>
internal interface IPlacedShape<T> : ILibraryShape
{
    /// <inheritdoc cref="ShapeTraits{T}.PlacementOf"/>
    Placement? Placement { get; }

    /// <inheritdoc cref="ShapeTraits{T}.InCoreAxes"/>
    T InCoreAxes();
}

/// <summary>A shape that may be a ball or a box about its centre, and says so in short.</summary>
internal interface IPlainBody : ILibraryShape
{
    /// <summary>Which body it is: a ball, a box or hull (its margin apart), or None for everything else.</summary>
    /// <param name="size">The ball's radius, three times; or half the box's sides.</param>
    FormKind GetPlain(out Double3 size);
}

/// <inheritdoc/>
/// <param name="isTight">False where the radius may be as generous as that of a shape inside.</param>
internal class LibraryTraits<T>(bool isTight = true) : ShapeTraits<T>
    where T : struct, ISupportMap, ILibraryShape
{
    protected override bool IsTight => isTight;

    public override bool TryGetForm(ref T shape, out ShapeForm form) => shape.TryGetForm(out form);
}

/// <inheritdoc/>
internal sealed class PlainTraits<T> : LibraryTraits<T>
    where T : struct, ISupportMap, IPlainBody
{
    public override FormKind GetPlain(ref T shape, out Double3 size) => shape.GetPlain(out size);
}

/// <inheritdoc/>
internal class PlacedTraits<T>(bool isTight) : LibraryTraits<T>(isTight)
    where T : struct, ISupportMap, IPlacedShape<T>
{
    protected override bool MayBePlaced => true;

    public override Placement? PlacementOf(ref T shape) => shape.Placement;

    public override T InCoreAxes(in T shape) => shape.InCoreAxes();
}
