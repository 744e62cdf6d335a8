namespace Gjk.Core;

public readonly partial struct ConvexShape
{
    object ILibraryShape.MakeTraits() => new Traits();

    bool ILibraryShape.TryGetTarget(out RayTarget target) => TryGetTarget(out target);

    /// <inheritdoc cref="ILibraryShape.TryGetTarget"/>
    internal bool TryGetTarget(out RayTarget target)
    {
        bool found = _parts.Layer is ScaledLayer scaled
            ? scaled.Shape.TryGetTarget(out target)
            : TryGetCore(out target);
        target.Round(_parts.Rounding);
        return found && (_parts.Placement is null || _parts.Placement.TryPlace(ref target));
    }

    private sealed class Traits : PlacedTraits<ConvexShape>
    {
        public Traits()
            : base(isTight: true)
        {
        }

        public override RayForm GetPlain(ref ConvexShape shape, out Double3 size) => shape.GetPlain(out size);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private RayForm GetPlain(out Double3 size)
    {
        bool isBall = _isPlain & _parts.Kind == ShapeKind.Sphere, isBox = _core == CoreKind.Box;
        size = isBall ? new Double3(1, 1, 1) * _margin
            : isBox & _parts.Hull is not null ? _parts.Hull!.Cells.Stretch : _parts.A;
        return isBall ? RayForm.Ball : isBox ? RayForm.Box : _core == CoreKind.Hull ? RayForm.Hull : RayForm.None;
    }

    /// <summary>What a ray sees of a shape without layers, not yet widened.</summary>
    private bool TryGetCore(out RayTarget target)
    {
        switch (_parts.Kind)
        {
            case ShapeKind.Point or ShapeKind.Sphere:
                RayTarget.Ball(_parts.InnerMargin, out target);
                break;
            case ShapeKind.Box:
                RayTarget.Of(RayForm.Box, _parts.A, out target);
                break;
            case ShapeKind.Mesh:
                RayTarget.Of(_parts.Hull!, out target);
                break;
            case ShapeKind.Segment or ShapeKind.Capsule:
                RayTarget.Capsule(_parts.A, _parts.B, CoreCenter(_parts), _parts.InnerMargin, out target);
                break;
            case ShapeKind.Triangle:
                RayTarget.Triangle(_parts.A, _parts.B, _parts.C, CoreCenter(_parts), out target);
                break;
            default:
                if (_parts.Curve?.TryGetTarget(out target) == true) break;
                target = default;
                return false;
        }

        if (_parts.Scaling is null) return true;
        target.Center = _center;
        target.CenterError = _parts.Scaling.CenterError;
        return target.Scale(_parts.Scaling.Axes);
    }
}
