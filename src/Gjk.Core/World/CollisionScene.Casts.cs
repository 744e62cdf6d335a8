namespace Gjk.Core;

public sealed partial class CollisionScene
{
    /// <summary>The object that a shape meets first when it is translated; of several the first in the
    /// order of <see cref="CastHit"/>. The shape is none of the scene's, and the objects rest.</summary>
    /// <param name="shape">Any shape but a <c>default</c> struct: A of the result.</param>
    /// <param name="pose">Its pose at the start.</param>
    /// <param name="translation">Its motion over the fractions from 0 to 1, in world units.</param>
    /// <param name="hit">The object (B), or -1 where there is none, the part, and when they first touch, with the bits
    /// of <c>ConvexQuery.Cast</c>, from where the shape is out of the objects if it begins in several and
    /// <see cref="CastOptions.OnlyDeeper"/> says so; a miss where there is none. An object whose query ends with
    /// <see cref="CastStatus.IterationLimit"/> counts as met at its fraction, up to which nothing is proved to be in
    /// the way.</param>
    /// <param name="maxFraction">How much of the motion is looked at: at least 0; 1 for all of it, more for the same
    /// motion continued.</param>
    /// <param name="filter">Which objects are seen; by default all.</param>
    /// <param name="options">Which contacts are passed; by default none.</param>
    /// <returns>Whether the shape meets an object, or may.</returns>
    /// <exception cref="ArgumentException">The shape or the pose is a <c>default</c> struct.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The motion is not finite, or the fraction is negative or
    /// NaN.</exception>
    public bool TryFindCastHit(
        in ConvexShape shape, in RigidPose pose, Vector3 translation, out CastHit hit, float maxFraction = 1,
        in QueryFilter filter = default, in CastOptions options = default)
    {
        CheckCast(shape, pose, translation, maxFraction);
        MovingShape moving = MakeMoving(shape, pose, translation, maxFraction, filter, options);
        hit = FirstHit(moving);
        if (options.PassesShallow)
        {
            var union = new UnionCast(this, moving);
            hit = UnionLift.FirstOfUnion(ref union, options, moving.Lifted, 0, hit);
        }

        return hit.Id >= 0;
    }

    private CastHit FirstHit(in MovingShape moving)
    {
        var first = new FirstCastHit(_objects, moving);
        _phase.Sweep(moving.Path(), ref first);
        return first.Hit;
    }

    /// <summary>All objects that a shape meets when it is translated, as it would without the others.</summary>
    /// <param name="shape">Any shape but a <c>default</c> struct: A of the results.</param>
    /// <param name="pose">Its pose at the start.</param>
    /// <param name="translation">Its motion over the fractions from 0 to 1, in world units.</param>
    /// <param name="results">Emptied first; then the objects by fraction, at the same fraction by id, those whose query
    /// ends with <see cref="CastStatus.IterationLimit"/> among them.</param>
    /// <param name="maxFraction">How much of the motion is looked at: at least 0.</param>
    /// <param name="filter">Which objects are seen; by default all.</param>
    /// <param name="options">Which contacts are passed; by default none.</param>
    /// <exception cref="ArgumentException">The shape or the pose is a <c>default</c> struct.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The motion is not finite, or the fraction is negative or
    /// NaN.</exception>
    /// <param name="eachPart">Whether objects that are not convex have a hit for each part that is met or overlaps, as
    /// <c>ConcaveQuery.CastAll</c> has them; by default one hit, their first.</param>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    public void FindCastHits(
        in ConvexShape shape, in RigidPose pose, Vector3 translation, List<CastHit> results, float maxFraction = 1,
        in QueryFilter filter = default, in CastOptions options = default, bool eachPart = false)
    {
        CheckCast(shape, pose, translation, maxFraction);
        Guard.NotNull(results, nameof(results)).Clear();
        MovingShape moving = MakeMoving(shape, pose, translation, maxFraction, filter, options);
        var all = new AllCastHits(_objects, moving, results, eachPart);
        _phase.Sweep(moving.Path(), ref all);
        InPlaceSort.Sort(results);
    }

    private MovingShape MakeMoving(
        in ConvexShape shape, in RigidPose pose, Vector3 translation, float maxFraction, in QueryFilter filter,
        in CastOptions options)
    {
        var moving = new MovingShape(shape, pose, translation, maxFraction, filter, options, pose, default);
        if (!options.PassesShallow) return moving;
        var union = new UnionCast(this, moving);
        return UnionLift.TryLift(ref union, options, out RigidPose lifted, out Double3 lift)
            ? moving.LiftedTo(lifted, lift)
            : moving;
    }

    /// <summary>The objects as the union that a shape moves in.</summary>
    private struct UnionCast(CollisionScene scene, in MovingShape moving) : IUnionCast
    {
        private readonly MovingShape _moving = moving;

        public readonly float Sign => -1;

        public readonly RigidPose PoseAt(float fraction) => _moving.PoseAt(fraction);

        public readonly float RoundingAt(float fraction, in RigidPose pose) => UnionLift.RoundingOf(pose);

        public readonly Double3 WayAt(in Double3 point, float fraction) => _moving.Translation;

        public readonly CastResult CastAlong(in RigidPose pose, Vector3 way) =>
            scene.FirstHit(_moving.StartingAt(pose, way, way == Vector3.Zero ? 0 : 1, default)).Result;

        public readonly CastHit CastFrom(float fraction, in RigidPose pose, in CastOptions options) =>
            scene.FirstHit(_moving.StartingAt(pose, _moving.Translation, _moving.MaxFraction - fraction, options));

        public readonly bool ShowsFace(in CastHit hit) => _moving.ShowsFace(scene._objects, hit);
    }

    private static void CheckCast(in ConvexShape shape, in RigidPose pose, Vector3 translation, float maxFraction)
    {
        CheckShape(shape);
        CheckPose(pose);
        Guard.Finite(translation, nameof(translation));
        Guard.NonNegativeOrInfinite(maxFraction, nameof(maxFraction));
    }

    private static void CheckShape(in ConvexShape shape)
    {
        if (shape.Kind == ShapeKind.None)
            throw new ArgumentException("A default ConvexShape is no shape.", nameof(shape));
    }
}
