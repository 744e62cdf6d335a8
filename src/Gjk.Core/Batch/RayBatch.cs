namespace Gjk.Core;

/// <summary>Many rays against one shape: rays in, results out, in the order of the rays and with the same bits for one
/// thread or many. Rays against many shapes are a question for a <see cref="CollisionScene"/>.</summary>
/// <remarks>Thread-safe as long as nobody writes to the arrays. Arguments are checked before anything is
/// written.</remarks>
public static class RayBatch
{
    /// <summary>Where each ray first meets a shape.</summary>
    /// <param name="shape">The shape; a <c>default</c> one gives <see cref="CastStatus.InvalidInput"/> for every
    /// ray.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="rays">The rays.</param>
    /// <param name="results">At least as long as the rays; gets what <see cref="ConvexQuery"/> says.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <param name="cancellation">Looked at every hundred rays or so.</param>
    /// <param name="options">Which contacts are passed; by default none.</param>
    /// <param name="sides">Which sides are met; by default both, of a solid shape.</param>
    /// <exception cref="ArgumentNullException">An array is null.</exception>
    /// <exception cref="ArgumentException">There are fewer results than rays, or a ray is a <c>default</c> struct; the
    /// message names the ray.</exception>
    /// <exception cref="OperationCanceledException">Cancelled; some of the results are written, the rest is as it
    /// was.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public static void RayCast(
        in ConvexShape shape, in RigidPose pose, RayQuery[] rays, RayCastResult[] results, Workers? workers = null,
        CancellationToken cancellation = default, in CastOptions options = default, RaySides sides = RaySides.Both)
    {
        RayQuery.Check(rays, results);
        Workers.Run(
            workers, new RayJob(shape, pose, rays, results, options, sides), rays.Length, PairBatch.ShareLength,
            cancellation);
    }

    private readonly struct RayJob(
        ConvexShape shape, RigidPose pose, RayQuery[] rays, RayCastResult[] results, CastOptions options,
        RaySides sides) : IShareJob
    {
        public void Run(int begin, int end)
        {
            for (int i = begin; i < end; i++)
            {
                RayQuery ray = rays[i];
                results[i] = ConvexQuery.RayCast(
                    shape, pose, ray.Origin, ray.Direction, ray.MaxDistance, options, sides);
            }
        }
    }
}
