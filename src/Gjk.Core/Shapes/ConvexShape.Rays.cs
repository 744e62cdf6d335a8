namespace Gjk.Core;

public readonly partial struct ConvexShape
{
    object ILibraryShape.MakeTraits() => new Traits();

    bool ILibraryShape.TryGetForm(out ShapeForm form) => TryGetForm(out form);

    /// <inheritdoc cref="ILibraryShape.TryGetForm"/>
    internal bool TryGetForm(out ShapeForm form)
    {
        bool found = _parts.Layer is ScaledLayer scaled
            ? scaled.Shape.TryGetForm(out form)
            : TryGetCore(out form);
        form.Round(_parts.Rounding);
        return found && (_parts.Placement is null || _parts.Placement.TryPlace(ref form));
    }

    private sealed class Traits() : PlacedTraits<ConvexShape>(isTight: true)
    {
        public override FormKind GetPlain(ref ConvexShape shape, out Double3 size) => shape.GetPlain(out size);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private FormKind GetPlain(out Double3 size)
    {
        bool isBall = _isPlain & _parts.Kind == ShapeKind.Sphere;
        size = isBall ? new Double3(1, 1, 1) * _margin
            : _core == FormKind.Box & _parts.Hull is not null ? _parts.Hull!.Cells.Stretch : _parts.A;
        return isBall ? FormKind.Ball : _core;
    }

    /// <summary>What a ray sees of a shape without layers, not yet widened.</summary>
    private bool TryGetCore(out ShapeForm form)
    {
        bool found = _parts.Kind switch
        {
            ShapeKind.Point or ShapeKind.Sphere => ShapeForm.Ball(_parts.InnerMargin, out form),
            ShapeKind.Box => ShapeForm.Of(FormKind.Box, _parts.A, out form),
            ShapeKind.Mesh => ShapeForm.Of(_parts.Hull, out form),
            ShapeKind.Segment or ShapeKind.Capsule =>
                ShapeForm.Capsule(_parts.A, _parts.B, CoreCenter(_parts), _parts.InnerMargin, out form),
            ShapeKind.Triangle =>
                ShapeForm.Triangle(_parts.A, _parts.B, _parts.C, CoreCenter(_parts), out form),
            _ => _parts.Curve is null ? ShapeForm.None(out form) : _parts.Curve.TryGetForm(out form),
        };
        if (!found || _parts.Scaling is null) return found;
        form.Center = _center;
        form.CenterError = _parts.Scaling.CenterError;
        return form.Scale(_parts.Scaling.Axes);
    }
}
