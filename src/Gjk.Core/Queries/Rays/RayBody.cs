namespace Gjk.Core;

/// <summary>What became of a line and a body.</summary>
internal enum RayFinding
{
    /// <summary>No closed form is exact here.</summary>
    Unfit,

    /// <summary>The line misses the body.</summary>
    Missed,

    /// <summary>There is a part of the line in it.</summary>
    Found,

    /// <summary>Where the line enters is rounding, unless it is measured exactly.</summary>
    Close,
}

/// <summary>Takes a line to the closed form of a body.</summary>
internal static class RayBody
{
    /// <summary>The part of the line in the body. Flat to nothing, a body has no closed form: such hits are a matter of
    /// touching within rounding, which the cast decides.</summary>
    /// <param name="form">The body.</param>
    /// <param name="ray">In the shape's axes; if it is exact, in the body's.</param>
    /// <param name="span">The part of the line, with the normal in the shape's axes.</param>
    public static RayFinding Find(in ShapeForm form, in LocalRay ray, out RaySpan span)
    {
        if (!form.IsPlaced && !form.IsScaled) return FindPlain(form, ray, out span);
        LocalRay own = ray;
        RotationD turn = form.IsPlaced ? new RotationD(form.Turn) : default;
        if (!ray.IsExact)
        {
            own.Foot -= form.CenterError;
            if (form.IsPlaced)
            {
                own.Foot = turn.InverseRotate(own.Foot);
                own.Direction = turn.InverseRotate(own.Direction);
            }
        }

        RayFinding found = form.IsScaled ? FindScaled(form, ref own, out span) : FindPlain(form, own, out span);
        if (form.IsPlaced) span.Normal = turn.Rotate(span.Normal);
        return found;
    }

    /// <summary>The same in the body's own axes.</summary>
    private static RayFinding FindScaled(in ShapeForm form, ref LocalRay own, out RaySpan span)
    {
        if (!own.IsExact && RayGraze.IsAlongFlat(form.Factors, own.Direction))
        {
            span = default;
            return RayFinding.Close;
        }

        var inverse = new Double3(1 / form.Factors.X, 1 / form.Factors.Y, 1 / form.Factors.Z);
        own.Foot = Double3.Multiply(own.Foot, inverse);
        own.Direction = Double3.Multiply(own.Direction, inverse);
        double shift = LocalRay.MoveToFoot(ref own.Foot, own.Direction);
        RayFinding found = FindPlain(form, own, out span);
        span.Move(shift);
        span.Normal = Double3.Multiply(span.Normal, inverse);
        return found;
    }

    /// <summary>The same in the body's own axes and size.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static RayFinding FindPlain(in ShapeForm form, in LocalRay ray, out RaySpan span)
    {
        Double3 size = form.A;
        bool isFound, isAlong = false;
        switch (form.Kind)
        {
            case FormKind.Ball when form.Radius > 0:
                isFound = RayBall.TryFind(ray, form.Radius, out span);
                break;
            case FormKind.Box when RayBox.IsSolid(size):
                isFound = RayBox.TryFind(ray, size, out span);
                isAlong = RayBox.IsAlongSide(ray, size);
                break;
            case FormKind.Hull when form.Hull!.Planes is not null:
                return RayHull.Find(ray.Foot, ray.Direction, form.Hull, form.Hull.Planes, out span);
            case FormKind.Segment when form.Radius > 0:
                isFound = RayCapsule.TryFind(ray.Foot, ray.Direction, form.A, form.B, form.Radius, out span);
                break;
            case FormKind.Cylinder when size.X > 0:
                isFound = RayCylinder.TryFind(ray.Foot, ray.Direction, size.X, size.Y, out span);
                isAlong = IsAlongCap(ray, size);
                break;
            case FormKind.Cone when size.X > 0 && size.Y > 0:
                isFound = RayCone.TryFind(ray.Foot, ray.Direction, size.X, size.Y, out span);
                isAlong = IsAlongCap(ray, size)
                    || RayGraze.IsAlongFlat(new Double3(size.X, size.Y, size.X), ray.Direction);
                break;
            case FormKind.Ellipsoid when size.X > 0 && size.Y > 0 && size.Z > 0:
                isFound = RayEllipsoid.TryFind(ray, size, out span);
                isAlong = RayGraze.IsAlongFlat(size, ray.Direction);
                break;
            case FormKind.Triangle when RayTriangle.IsFit(ray, form.A, form.B, form.C, out Double3 normal):
                isFound = RayTriangle.TryFind(ray, form.A, form.B, form.C, normal, out span);
                break;
            default:
                span = default;
                return RayFinding.Unfit;
        }

        return (isAlong | span.IsClose) && !ray.IsExact ? RayFinding.Close
            : isFound ? RayFinding.Found : RayFinding.Missed;
    }

    /// <summary>Whether the line runs along the base of a cone, or an end of a cylinder.</summary>
    private static bool IsAlongCap(in LocalRay ray, in Double3 size) =>
        RayGraze.IsAlongSlab(size.Y, ray.Foot.Y, ray.Direction.Y, ray.Direction.LargestMagnitude, size.X + size.Y);
}
