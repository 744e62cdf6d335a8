namespace Gjk.Core;

public readonly partial struct ConvexShape
{
    bool IRayTarget.TryGetTarget(out RayTarget target) => TryGetTarget(out target);

    /// <inheritdoc cref="IRayTarget.TryGetTarget"/>
    internal bool TryGetTarget(out RayTarget target)
    {
        bool found = _parts.Layer is null ? TryGetCore(out target) : _parts.Layer.TryGetTarget(out target);
        target.Round(_parts.Rounding);
        return found;
    }

    /// <summary>What a ray sees of a shape without layers, not yet widened.</summary>
    private bool TryGetCore(out RayTarget target)
    {
        switch (_parts.Kind)
        {
            case ShapeKind.Point or ShapeKind.Sphere:
                target = RayTarget.Ball(_parts.InnerMargin);
                break;
            case ShapeKind.Box:
                target = RayTarget.Of(RayForm.Box, _parts.A);
                break;
            case ShapeKind.Mesh:
                target = RayTarget.Of(_parts.Hull!);
                break;
            case ShapeKind.Segment or ShapeKind.Capsule:
                target = RayTarget.Capsule(_parts.A, _parts.B, CoreCenter(_parts), _parts.InnerMargin);
                break;
            case ShapeKind.Triangle:
                target = RayTarget.Triangle(_parts.A, _parts.B, _parts.C, CoreCenter(_parts));
                break;
            case ShapeKind.Cylinder:
                target = RayTarget.Of(RayForm.Cylinder, _parts.A);
                break;
            case ShapeKind.Cone:
                target = RayTarget.Of(RayForm.Cone, _parts.A);
                break;
            case ShapeKind.Ellipsoid:
                target = RayTarget.Of(RayForm.Ellipsoid, _parts.A);
                break;
            default:
                target = default;
                return false;
        }

        if (_isPlain) return true;
        target.Center = _center;
        target.CenterError = _centerError;
        return target.Scale(_scale);
    }
}
