namespace Gjk.Core;

public readonly partial struct ConvexShape
{
    /// <inheritdoc/>
    public unsafe void GetFace(in Double3 direction, ref FaceCorners corners)
    {
        if (_parts.Placement is not null)
        {
            _parts.Placement.GetFace(InCoreAxes(), direction, ref corners);
            return;
        }

        if (_parts.Layer is not null)
        {
            _parts.Layer.GetFace(direction, ref corners);
            return;
        }

        ShapeScale? scaling = _parts.Scaling;
        if (scaling is null)
        {
            CoreFace(direction, ref corners);
            return;
        }

        // Uneven factors make a margin part of a core that has no corners then.
        if (_parts.InnerMargin > 0 && !scaling.Axes.KeepsBalls) return;
        OuterFrame outer = scaling.Axes.Frame(corners, direction);
        OuterFrame* around = corners.Outer;
        if (!scaling.Axes.KeepsBalls) corners.Outer = &outer;
        CoreFace(scaling.Axes.Inward(direction), ref corners);
        corners.Outer = around;
        scaling.Axes.Outward(ref corners, scaling.CenterError);
    }

    /// <summary>The face of the core before the scale, measured from the core's centre.</summary>
    private void CoreFace(in Double3 direction, ref FaceCorners corners)
    {
        Double3 center = CoreCenter(_parts), a = _parts.A - center, b = _parts.B - center;
        switch (_parts.Kind)
        {
            case ShapeKind.Mesh:
                new ConvexMesh(_parts.Hull!).GetFace(direction, ref corners);
                break;
            case ShapeKind.Box:
                BoxSupport.Face(_parts.A, direction, ref corners);
                break;
            case ShapeKind.Segment or ShapeKind.Capsule:
                PrimitiveFaces.Segment(a, b, direction, ref corners);
                break;
            case ShapeKind.Triangle:
                TriangleCore.Face(a, b, _parts.C - center, direction, ref corners);
                break;
            default:
                _parts.Curve?.GetFace(direction, ref corners);
                break;
        }
    }
}
