using System.Numerics;

namespace Gjk.Core;

public static partial class ConvexQuery
{
    /// <summary>Where a ray first meets a shape.</summary>
    /// <typeparam name="T">The shape's type.</typeparam>
    /// <param name="shape">The shape.</param>
    /// <param name="pose">Where it is.</param>
    /// <param name="origin">Where the ray begins, in the world.</param>
    /// <param name="direction">Any finite vector but zero; its length does not matter.</param>
    /// <param name="maxDistance">
    /// World units: how far the ray reaches, +infinity for all the way; less than 0 counts as 0.
    /// </param>
    /// <returns>
    /// The first point of the ray that is in the closed shape, or <see cref="CastStatus.Miss"/>, or
    /// <see cref="CastStatus.OverlappingAtStart"/> where the origin is in it. The distance is the true one, rounded to
    /// float.
    /// </returns>
    public static RayCastResult RayCast<T>(
        in T shape, in RigidPose pose, Vector3 origin, Vector3 direction, float maxDistance = float.PositiveInfinity)
        where T : struct, ISupportMap
    {
        double length = ((Vector3D)direction).Length;
        if (!(length > 0) || !Guard.IsFinite(origin))
            return RayCastResult.Nothing(CastStatus.InvalidInput, float.NaN, 0);
        CastResult hit = Cast(
            shape, pose, Vector3.Zero, default(PointShape), new RigidPose(origin), direction,
            (float)(maxDistance / length));
        float distance = hit.Status == CastStatus.Miss ? maxDistance : (float)(hit.Fraction * length);
        return new RayCastResult(hit.Status, distance, hit.Point, hit.Normal, hit.Iterations);
    }
}
