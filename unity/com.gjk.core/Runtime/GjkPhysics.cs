using System;
using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>
    /// Questions about two colliders that the engine's <c>Physics</c> does not answer, or answers only when they
    /// overlap. No physics scene is asked, so neither needs a rigid body, a simulation step or to be enabled.
    /// </summary>
    /// <remarks>
    /// For the main thread. Nothing is allocated once the hulls of the meshes are made. What a collider must be, and
    /// the exceptions for one that is not, are those of <see cref="GjkShapes"/>.
    /// </remarks>
    public static class GjkPhysics
    {
        /// <summary>
        /// How far two colliders are apart, or how deep they overlap, with the closest or deepest points.
        /// </summary>
        /// <param name="colliderA">The first.</param>
        /// <param name="colliderB">The second.</param>
        public static ColliderDistance3D Distance(Collider colliderA, Collider colliderB) =>
            Distance(GjkShapes.From(colliderA), GjkShapes.From(colliderB));

        /// <summary>
        /// The same as if their transforms were somewhere else in the world; their scales stay.
        /// </summary>
        /// <param name="colliderA">The first.</param>
        /// <param name="positionA">Instead of its transform's position.</param>
        /// <param name="rotationA">Instead of its transform's rotation.</param>
        /// <param name="colliderB">The second.</param>
        /// <param name="positionB">Instead of its transform's position.</param>
        /// <param name="rotationB">Instead of its transform's rotation.</param>
        public static ColliderDistance3D Distance(
            Collider colliderA, Vector3 positionA, Quaternion rotationA, Collider colliderB, Vector3 positionB,
            Quaternion rotationB) =>
            Distance(
                GjkShapes.From(colliderA, positionA, rotationA), GjkShapes.From(colliderB, positionB, rotationB));

        /// <summary>How far two shapes are apart, or how deep they overlap.</summary>
        public static ColliderDistance3D Distance(in PosedShape a, in PosedShape b) =>
            new ColliderDistance3D(ConvexQuery.SignedDistance(a.Shape, a.Pose, b.Shape, b.Pose));

        /// <summary>Whether two colliders share a point, touching included.</summary>
        public static bool Overlaps(Collider colliderA, Collider colliderB) =>
            Overlaps(GjkShapes.From(colliderA), GjkShapes.From(colliderB));

        /// <summary>Whether two shapes share a point, touching included.</summary>
        public static bool Overlaps(in PosedShape a, in PosedShape b) =>
            ConvexQuery.Overlaps(a.Shape, a.Pose, b.Shape, b.Pose);

        /// <summary>
        /// The point of a collider closest to a point, with the arguments of <c>Physics.ClosestPoint</c>; the point
        /// itself where it is inside.
        /// </summary>
        /// <param name="point">World.</param>
        /// <param name="collider">The collider.</param>
        /// <param name="position">Where its transform is taken to be.</param>
        /// <param name="rotation">How its transform is taken to be turned.</param>
        public static Vector3 ClosestPoint(Vector3 point, Collider collider, Vector3 position, Quaternion rotation) =>
            ClosestPoint(point, GjkShapes.From(collider, position, rotation));

        /// <summary>The point of a collider closest to a point; the point itself where it is inside.</summary>
        public static Vector3 ClosestPoint(Vector3 point, Collider collider) =>
            ClosestPoint(point, GjkShapes.From(collider));

        /// <summary>
        /// When a collider that moves along a straight line first touches another one.
        /// </summary>
        /// <param name="colliderA">The one that moves, from where its transform is.</param>
        /// <param name="direction">Any vector but zero; its length does not matter.</param>
        /// <param name="maxDistance">World units: how far it moves; finite.</param>
        /// <param name="colliderB">The one that rests.</param>
        /// <param name="hit">Where they touch; <c>default</c> where they do not.</param>
        /// <returns>
        /// Whether they touch. Colliders that overlap at the start do; those that only touch there do if the motion
        /// goes in, not if they slide or part.
        /// </returns>
        /// <exception cref="ArgumentOutOfRangeException">
        /// The direction has no length, or the distance is negative or not finite.
        /// </exception>
        public static bool Cast(
            Collider colliderA, Vector3 direction, float maxDistance, Collider colliderB, out ColliderCastHit hit)
        {
            double length = new Double3(direction.x, direction.y, direction.z).Length;
            if (!(length > 0) || double.IsInfinity(length))
                throw new ArgumentOutOfRangeException(nameof(direction), direction, "The direction has no length.");
            if (!(maxDistance >= 0) || float.IsInfinity(maxDistance))
                throw new ArgumentOutOfRangeException(nameof(maxDistance), maxDistance, "Must be finite, from 0 on.");
            PosedShape a = GjkShapes.From(colliderA), b = GjkShapes.From(colliderB);
            var way = (System.Numerics.Vector3)(
                new Double3(direction.x, direction.y, direction.z) * (maxDistance / length));
            CastResult result = ConvexQuery.Cast(a.Shape, a.Pose, way, b.Shape, b.Pose, default);
            bool mayHit = result.IsHit || result.Status == CastStatus.IterationLimit;
            hit = mayHit ? new ColliderCastHit(result, maxDistance) : default;
            return mayHit;
        }

        /// <summary>
        /// How to move the first collider out of the second, with the arguments of <c>Physics.ComputePenetration</c>;
        /// the shortest way there is.
        /// </summary>
        /// <param name="colliderA">The one to move.</param>
        /// <param name="positionA">Where its transform is taken to be.</param>
        /// <param name="rotationA">How its transform is taken to be turned.</param>
        /// <param name="colliderB">The one that rests.</param>
        /// <param name="positionB">Where its transform is taken to be.</param>
        /// <param name="rotationB">How its transform is taken to be turned.</param>
        /// <param name="direction">Along which the first leaves the second; zero where they do not overlap.</param>
        /// <param name="distance">How far it has to go; 0 where they touch, or do not overlap.</param>
        /// <returns>Whether they overlap, touching included.</returns>
        public static bool ComputePenetration(
            Collider colliderA, Vector3 positionA, Quaternion rotationA, Collider colliderB, Vector3 positionB,
            Quaternion rotationB, out Vector3 direction, out float distance)
        {
            ColliderDistance3D found = Distance(colliderA, positionA, rotationA, colliderB, positionB, rotationB);
            direction = found.isOverlapped ? -found.normal : Vector3.zero;
            distance = found.isOverlapped ? -found.distance : 0;
            return found.isOverlapped;
        }

        private static Vector3 ClosestPoint(Vector3 point, in PosedShape shape)
        {
            var pose = new RigidPose(point.ToNumerics());
            DistanceResult result = ConvexQuery.Distance(ConvexShape.Point(), pose, shape.Shape, shape.Pose);
            return result.Status == GjkStatus.Overlapping ? point : result.PointB.ToUnity();
        }
    }
}
