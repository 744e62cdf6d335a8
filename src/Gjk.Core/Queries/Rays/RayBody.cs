using System.Runtime.CompilerServices;

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
}

/// <summary>Takes a line to the closed form of a body.</summary>
internal static class RayBody
{
    /// <summary>
    /// The part of the line in the body. Flat to nothing, a body has no closed form: such hits are a matter of touching
    /// within rounding, which the cast decides.
    /// </summary>
    /// <param name="target">The body.</param>
    /// <param name="ray">In the shape's axes.</param>
    /// <param name="span">The part of the line, with the normal in the shape's axes.</param>
    public static RayFinding Find(in RayTarget target, in LocalRay ray, out RaySpan span)
    {
        if (!target.IsPlaced && !target.IsScaled) return FindPlain(target, ray, out span);
        LocalRay own = ray;
        own.Foot -= target.CenterError;
        RotationD turn = default;
        if (target.IsPlaced)
        {
            turn = new RotationD(target.Turn);
            own.Foot = turn.InverseRotate(own.Foot);
            own.Direction = turn.InverseRotate(own.Direction);
        }

        var inverse = new Vector3D(1, 1, 1);
        if (target.IsScaled)
        {
            inverse = new Vector3D(1 / target.Factors.X, 1 / target.Factors.Y, 1 / target.Factors.Z);
            own.Foot = Vector3D.Multiply(own.Foot, inverse);
            own.Direction = Vector3D.Multiply(own.Direction, inverse);
        }

        RayFinding found = FindPlain(target, own, out span);
        span.Normal = Vector3D.Multiply(span.Normal, inverse);
        if (target.IsPlaced) span.Normal = turn.Rotate(span.Normal);
        return found;
    }

    /// <summary>The same in the body's own axes and size.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static RayFinding FindPlain(in RayTarget target, in LocalRay ray, out RaySpan span)
    {
        Vector3D size = target.A;
        switch (target.Form)
        {
            case RayForm.Ball when target.Radius > 0:
                return Result(RayBall.TryFind(ray, target.Radius, out span));
            case RayForm.Box when size.X * size.Y + size.Y * size.Z + size.Z * size.X > 0
                && !RayBox.IsAlongSide(ray, size):
                return Result(RayBox.TryFind(ray, size, out span));
            case RayForm.Hull when target.Hull!.Planes is not null:
                return RayHull.Find(ray.Foot, ray.Direction, target.Hull, target.Hull.Planes, out span);
            case RayForm.Capsule when target.Radius > 0:
                return Result(
                    RayCapsule.TryFind(ray.Foot, ray.Direction, target.A, target.B, target.Radius, out span));
            case RayForm.Cylinder when size.X > 0 && !IsAlongCap(ray, size):
                return Result(RayCylinder.TryFind(ray.Foot, ray.Direction, size.X, size.Y, out span));
            case RayForm.Cone when size.X > 0 && size.Y > 0 && !IsAlongCap(ray, size):
                return Result(RayCone.TryFind(ray.Foot, ray.Direction, size.X, size.Y, out span));
            case RayForm.Ellipsoid when size.X > 0 && size.Y > 0 && size.Z > 0:
                return Result(RayEllipsoid.TryFind(ray, size, out span));
            case RayForm.Triangle when RayTriangle.IsFit(ray, target.A, target.B, target.C, out Vector3D normal):
                return Result(RayTriangle.TryFind(ray, target.A, target.B, target.C, normal, out span));
            default:
                span = default;
                return RayFinding.Unfit;
        }
    }

    /// <summary>Whether the line runs along the base of a cone, or an end of a cylinder.</summary>
    private static bool IsAlongCap(in LocalRay ray, in Vector3D size) =>
        RayGraze.IsAlongSlab(
            size.Y, ray.Foot.Y, ray.Direction.Y, RayGraze.LengthOf(ray.Direction), size.X + size.Y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static RayFinding Result(bool found) => found ? RayFinding.Found : RayFinding.Missed;
}
