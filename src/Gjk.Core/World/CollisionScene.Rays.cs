namespace Gjk.Core;

public sealed partial class CollisionScene
{
    /// <summary>The object that a ray meets first; of several that are met at once, as on a seam between tiles, one
    /// whose side no other of them covers, then the one with the least id. Where the ray begins in objects, that is one
    /// of these, at distance 0.</summary>
    /// <param name="ray">The ray.</param>
    /// <param name="hit">The object, or -1 where there is none, the part, and where the ray meets it, with the bits of
    /// <c>ConvexQuery.RayCast</c>; a miss where there is none. An object whose query ends with
    /// <see cref="CastStatus.IterationLimit"/> counts as met at its distance, up to which nothing is proved to be in
    /// the way.</param>
    /// <param name="filter">Which objects are seen; by default all.</param>
    /// <param name="options">Which contacts are passed; by default none.</param>
    /// <param name="sides">Which sides are met; by default both, of solid shapes.</param>
    /// <returns>Whether the ray meets an object, or may.</returns>
    /// <exception cref="ArgumentException">The ray is a <c>default</c> struct.</exception>
    public bool TryFindRayHit(
        in RayQuery ray, out RayHit hit, in QueryFilter filter = default, in CastOptions options = default,
        RaySides sides = RaySides.Both)
    {
        CheckRay(ray);
        var first = new FirstRayHit(_objects, ray, filter, options, sides);
        _phase.Sweep(ray.Path(), ref first);
        hit = first.Hit;
        return hit.Id >= 0;
    }

    /// <summary>All objects that a ray meets, as it would without the others.</summary>
    /// <param name="ray">The ray.</param>
    /// <param name="results">Emptied first; then the objects by distance, at the same distance by id, those whose query
    /// ends with <see cref="CastStatus.IterationLimit"/> among them.</param>
    /// <param name="filter">Which objects are seen; by default all.</param>
    /// <param name="options">Which contacts are passed; by default none.</param>
    /// <param name="sides">Which sides are met; by default both, of solid shapes.</param>
    /// <exception cref="ArgumentException">The ray is a <c>default</c> struct.</exception>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    public void FindRayHits(
        in RayQuery ray, List<RayHit> results, in QueryFilter filter = default, in CastOptions options = default,
        RaySides sides = RaySides.Both)
    {
        CheckRay(ray);
        Guard.NotNull(results, nameof(results)).Clear();
        var all = new AllRayHits(_objects, ray, filter, options, sides, results);
        _phase.Sweep(ray.Path(), ref all);
        InPlaceSort.Sort(results);
    }

    /// <summary>The object that each of many rays meets first, with the bits of asking for one ray at a time.</summary>
    /// <param name="rays">The rays.</param>
    /// <param name="results">At least as long as the rays; the id is -1 where a ray meets nothing.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <param name="filter">Which objects are seen; by default all.</param>
    /// <param name="options">Which contacts are passed; by default none.</param>
    /// <param name="sides">Which sides are met; by default both, of solid shapes.</param>
    /// <exception cref="ArgumentNullException">An array is null.</exception>
    /// <exception cref="ArgumentException">There are fewer results than rays, or a ray is a <c>default</c> struct; the
    /// message names the ray.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public void FindFirstRayHits(
        RayQuery[] rays, RayHit[] results, Workers? workers = null, in QueryFilter filter = default,
        in CastOptions options = default, RaySides sides = RaySides.Both)
    {
        RayQuery.Check(rays, results);
        if (_phase.Bounded is DynamicAabbTree tree) tree.UpdateLeaves();
        Workers.Run(
            workers, new SceneRayJob(_phase, _objects, rays, results, filter, options, sides), rays.Length,
            _objects.Concave.ShareLength);
    }

    private static void CheckRay(in RayQuery ray)
    {
        if (!ray.IsValid) throw new ArgumentException("A default RayQuery has no direction.", nameof(ray));
    }
}
