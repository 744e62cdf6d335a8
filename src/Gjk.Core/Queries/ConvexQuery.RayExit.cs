namespace Gjk.Core;

public static partial class ConvexQuery
{
    /// <summary>Ratio to the radius: how far beyond the foot the way back begins, so far out that a search begins anew
    /// (RayQuestion). A matter of cost only.</summary>
    private const double WayBack = 4;

    /// <summary>Ratio to how far the shape reaches: what a line crosses of it counts as no less. Much more rounds more
    /// of a distance away; far less begins inside of what is flat. Pinned by RayThinTests.</summary>
    private const double Thin = 1.0 / 64;

    /// <summary>Where a ray leaves a shape: the end of the part of it that is inside. With <c>RayCast</c>, which says
    /// where that part begins, it is the whole of what a solid cuts out of a ray.</summary>
    /// <typeparam name="T">The shape's type.</typeparam>
    /// <param name="shape">The shape.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="origin">Where the ray begins, in the world; it may be inside.</param>
    /// <param name="direction">Any finite vector but zero; its length does not matter.</param>
    /// <param name="maxDistance">World units: how far the ray reaches, +infinity for all the way; less than 0 counts as
    /// 0.</param>
    /// <returns>Hit: the last point of the ray that is in the closed shape, as far as <c>RayCast</c> promises it, and
    /// the outward normal there, along which the ray leaves. Miss: the ray has no point in the shape, as <c>RayCast</c>
    /// says it, or it is still inside where it ends. What is as thin as nothing is left where it is met. A ray that
    /// slides or leaves from an origin on the surface, which <c>RayCast</c> passes, ends on the surface, at its origin
    /// or further on, or has no end, as of a half-space. Where it only touches, at an edge or a corner, the normal is
    /// the ray's direction.</returns>
    /// <remarks>The line is followed backwards from beyond the shape, so entry and exit are found by one
    /// code.</remarks>
    public static RayCastResult RayExit<T>(
        in T shape, in RigidPose pose, Vector3 origin, Vector3 direction, float maxDistance = float.PositiveInfinity)
        where T : struct, ISupportMap
    {
        ref T inward = ref PairQuery.AsRef(shape);
        var line = new WorldRay(origin, direction, ((Double3)direction).Length, Math.Max(maxDistance, 0));
        CastRay(ref inward, pose, line, out RayMeeting hit);
        return ExitOf(ref inward, pose, line, hit);
    }

    /// <summary>Where a ray leaves that meets the shape, or begins in it; else what it says.</summary>
    private static RayCastResult ExitOf<T>(ref T shape, in RigidPose pose, in WorldRay line, in RayMeeting met)
        where T : struct, ISupportMap
    {
        RayMeeting hit = met;
        if (hit.Status == CastStatus.Hit || hit.Status == CastStatus.OverlappingAtStart)
        {
            int iterations = hit.Iterations;
            if (HalfSpacePair.IsHalfSpace(ref shape)) FindEnd(ref shape, pose, line, ref hit);
            else ComeBack(ref shape, pose, line, ref hit);
            if (hit.Status == CastStatus.Hit && hit.Distance <= line.Reach)
            {
                return new RayCastResult(
                    CastStatus.Hit, hit.Distance, (Vector3)line.At(hit.Distance), (Vector3)hit.Normal,
                    iterations + hit.Iterations, isBackFace: true);
            }

            if (hit.Status == CastStatus.Hit) hit.Status = CastStatus.Miss;
        }

        return RayCastResult.Nothing(
            hit.Status, FractionOf(hit.Status, hit.Distance, (float)line.Reach), hit.Iterations);
    }

    /// <summary>The entry of the line's other direction, which no rounding takes before the first one's.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void ComeBack<T>(ref T shape, in RigidPose pose, in WorldRay line, ref RayMeeting hit)
        where T : struct, ISupportMap
    {
        double entry = hit.Status == CastStatus.Hit ? hit.Distance : 0;
        Placement? placed = ShapeTraits<T>.Instance.PlacementOf(ref shape);
        VectorDD center = placed is null ? shape.Center : placed.ExactCenter;
        LocalRay.MakeFar(pose, center, line, out LocalRay ray);
        double radius = ReachAlong(ref shape, pose, ray);
        double far = ray.Shift + WayBack * radius;
        Double3 beyond = (Double3)VectorDD.ToWorld(pose, center) + ray.At(WayBack * radius);
        var back = new WorldRay(beyond, -line.Direction, line.Length, double.PositiveInfinity, radius);
        CastRay(ref shape, pose, back, out RayMeeting end);
        bool isFound = end.Status == CastStatus.Hit;
        hit.Distance = isFound ? Math.Max(far - end.Distance, entry) : entry;
        hit.Normal = isFound ? end.Normal : line.Direction * (1 / line.Length);
        hit.Iterations = end.Iterations;
        hit.Status = end.Status == CastStatus.IterationLimit ? end.Status : CastStatus.Hit;
    }

    /// <summary>The radius of a ball about the centre that holds what a line crosses of a shape. The bounding radius
    /// may be so generous that doubles of its size round the shape away. Of a flat shape that is crossed at its centre
    /// the line has no length, but the shape has.</summary>
    private static double ReachAlong<T>(ref T shape, in RigidPose pose, in LocalRay ray)
        where T : struct, ISupportMap
    {
        Double3 along = new RotationD(pose.Rotation).InverseRotate(ray.Direction);
        shape.Support(along, out Double3 last);
        shape.Support(-along, out Double3 first);
        double most = Math.Max(Double3.Dot(last, along), -Double3.Dot(first, along));
        double reach = Math.Max(most + ray.Foot.Length, Thin * last.Length);
        return Math.Min(reach, shape.BoundingRadius) + shape.Margin;
    }

    /// <summary>A half-space is left where the half-space on its other side is entered.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void FindEnd<T>(ref T shape, in RigidPose pose, in WorldRay line, ref RayMeeting hit)
        where T : struct, ISupportMap
    {
        ConvexShape outside = UnsafeRef.As<T, ConvexShape>(ref shape).Complement;
        CastRay(ref outside, pose, line, out RayMeeting end);
        bool isAtStart = end.Status == CastStatus.OverlappingAtStart;
        hit.Status = isAtStart ? CastStatus.Miss : end.Status;
        hit.Distance = end.Distance;
        hit.Normal = -end.Normal;
        hit.Iterations = end.Iterations;
    }
}
