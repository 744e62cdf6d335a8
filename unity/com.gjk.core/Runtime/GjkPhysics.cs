using System;
using Gjk.Core;
using UnityEngine;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>Questions about two colliders that the engine's <c>Physics</c> does not answer, or answers only when
    /// they overlap. No physics scene is asked, so neither needs a rigid body, a simulation step or to be
    /// enabled.</summary>
    /// <remarks>For the main thread. Nothing is allocated once the hulls of the meshes are made. What a collider must
    /// be, and the exceptions for one that is not, are those of <see cref="GjkShapes"/>.</remarks>
    public static class GjkPhysics
    {
        private static ShapeSource _first = new ShapeSource(), _second = new ShapeSource();

        /// <summary>How far two colliders are apart, or how deep they overlap, with the closest or deepest
        /// points.</summary>
        /// <param name="colliderA">The first.</param>
        /// <param name="colliderB">The second.</param>
        public static ColliderDistance3D Distance(Collider colliderA, Collider colliderB) =>
            Distance(GjkShapes.From(colliderA), GjkShapes.From(colliderB));

        /// <summary>The same as if their transforms were somewhere else in the world; their scales stay.</summary>
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
            new ColliderDistance3D(PairQueries.Signed(a, b));

        /// <summary>How far two objects are apart, each with all its colliders: the least over them. Of objects that
        /// overlap, it is the depth of the two colliders that overlap deepest.</summary>
        /// <param name="a">The first: with a Rigidbody its colliders and those of its children, without one its own;
        /// where there are none, its MeshFilter. Colliders that are switched off are left out where others are
        /// on.</param>
        /// <param name="b">The second.</param>
        /// <param name="isSolid">Whether closed meshes are meant with what they enclose.</param>
        /// <param name="withTriggers">Whether triggers are colliders here.</param>
        /// <exception cref="ArgumentNullException">There is none, or it was destroyed.</exception>
        /// <exception cref="ArgumentException">One has no shape; the message says which and why.</exception>
        public static ColliderDistance3D Distance(
            GameObject a, GameObject b, bool isSolid = false, bool withTriggers = false)
        {
            if (a == null) throw new ArgumentNullException(nameof(a));
            if (b == null) throw new ArgumentNullException(nameof(b));
            if (!_first.Read(a, isSolid, withTriggers)) throw new ArgumentException(_first.Problem, nameof(a));
            if (!_second.Read(b, isSolid, withTriggers)) throw new ArgumentException(_second.Problem, nameof(b));
            return _first.DistanceTo(_second);
        }

        /// <summary>How far a collider is from each of a list.</summary>
        /// <param name="collider">A of the results.</param>
        /// <param name="others">B of the results, in this order.</param>
        /// <param name="results">Gets the results; where it is shorter than the list, those of the first.</param>
        /// <returns>How many results there are.</returns>
        public static int Distances(Collider collider, Collider[] others, ColliderDistance3D[] results)
        {
            if (others == null) throw new ArgumentNullException(nameof(others));
            if (results == null) throw new ArgumentNullException(nameof(results));
            PosedShape a = GjkShapes.From(collider);
            int count = Math.Min(others.Length, results.Length);
            for (int i = 0; i < count; i++) results[i] = Distance(a, GjkShapes.From(others[i]));
            return count;
        }

        /// <summary>Where two colliders touch or nearly do: up to four points for convex ones, else so many for each
        /// triangle that carries.</summary>
        /// <param name="colliderA">The first.</param>
        /// <param name="colliderB">The second.</param>
        /// <param name="results">Gets the points; where there are more, the deepest.</param>
        /// <param name="maxGap">World units: points further apart are left out; at least 0.</param>
        /// <returns>How many points there are.</returns>
        public static int Contacts(
            Collider colliderA, Collider colliderB, ColliderContact[] results, float maxGap = 0)
        {
            if (results == null) throw new ArgumentNullException(nameof(results));
            return PairQueries.Contacts(GjkShapes.From(colliderA), GjkShapes.From(colliderB), maxGap, results);
        }

        /// <summary>Whether two colliders share a point, touching included.</summary>
        public static bool Overlaps(Collider colliderA, Collider colliderB) =>
            Overlaps(GjkShapes.From(colliderA), GjkShapes.From(colliderB));

        /// <summary>Whether two shapes share a point, touching included.</summary>
        public static bool Overlaps(in PosedShape a, in PosedShape b) =>
            PairQueries.Overlaps(a, b);

        /// <summary>The point of a collider closest to a point, with the arguments of <c>Physics.ClosestPoint</c>; the
        /// point itself where it is inside.</summary>
        /// <param name="point">World.</param>
        /// <param name="collider">The collider.</param>
        /// <param name="position">Where its transform is taken to be.</param>
        /// <param name="rotation">How its transform is taken to be turned.</param>
        public static Vector3 ClosestPoint(Vector3 point, Collider collider, Vector3 position, Quaternion rotation) =>
            ClosestPoint(point, GjkShapes.From(collider, position, rotation));

        /// <summary>The point of a collider closest to a point; the point itself where it is inside.</summary>
        public static Vector3 ClosestPoint(Vector3 point, Collider collider) =>
            ClosestPoint(point, GjkShapes.From(collider));

        /// <summary>When a collider that moves along a straight line first touches another one.</summary>
        /// <param name="colliderA">The one that moves, from where its transform is.</param>
        /// <param name="direction">Any vector but zero; its length does not matter.</param>
        /// <param name="maxDistance">World units: how far it moves; Mathf.Infinity for all the way.</param>
        /// <param name="colliderB">The one that rests.</param>
        /// <param name="hit">Where they touch; <c>default</c> where they do not.</param>
        /// <returns>Whether they touch. Colliders that overlap at the start do; those that only touch there do if the
        /// motion goes in, not if they slide or part.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The direction has no length, or the distance is negative or
        /// NaN.</exception>
        public static bool Cast(
            Collider colliderA, Vector3 direction, float maxDistance, Collider colliderB, out ColliderCastHit hit)
        {
            Numerics.Vector3 way = PairQueries.Way(direction, maxDistance, out float maxFraction);
            CastResult result = PairQueries.Cast(
                GjkShapes.From(colliderA), way, maxFraction, GjkShapes.From(colliderB));
            bool mayHit = result.IsHit || result.Status == CastStatus.IterationLimit;
            hit = mayHit ? new ColliderCastHit(result, maxDistance, colliderB) : default;
            return mayHit;
        }

        /// <summary>Where a ray first meets a collider, with the arguments of <c>Collider.Raycast</c>.</summary>
        /// <param name="collider">The collider.</param>
        /// <param name="ray">Its direction may have any length but 0.</param>
        /// <param name="hit">Where they meet; <c>default</c> where they do not.</param>
        /// <param name="maxDistance">World units; Mathf.Infinity for all the way.</param>
        /// <param name="sides">What of a surface the ray meets. By default both sides, and a start inside is a hit; as
        /// the engine has it: RaySides.Hollow and RaySides.FrontOnly.</param>
        public static bool Raycast(
            Collider collider, Ray ray, out ColliderRayHit hit, float maxDistance, RaySides sides = RaySides.Both)
        {
            PairQueries.Way(ray.direction, maxDistance, out float _);
            var query = new RayQuery(ray.origin.ToNumerics(), ray.direction.ToNumerics(), maxDistance);
            RayCastResult result = PairQueries.RayCast(GjkShapes.From(collider), query, sides, out int triangle);
            bool mayHit = result.IsHit || result.Status == CastStatus.IterationLimit;
            hit = mayHit ? new ColliderRayHit(result, triangle, collider) : default;
            return mayHit;
        }

        /// <summary>How to move the first collider out of the second, with the arguments of
        /// <c>Physics.ComputePenetration</c>; the shortest way there is. Where one is not convex, it is the way out of
        /// the part that is deepest inside, and another call may find the next.</summary>
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
            var posed = new PosedShape(ConvexShape.Point(), new RigidPose(point.ToNumerics()));
            DistanceResult result = PairQueries.Distance(posed, shape, float.PositiveInfinity);
            return result.Status == GjkStatus.Overlapping ? point : result.PointB.ToUnity();
        }

        /// <summary>They hold on to the objects of the last question, which a project that keeps the domain when play
        /// begins would never let go of.</summary>
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Reset()
        {
            _first = new ShapeSource();
            _second = new ShapeSource();
        }
    }
}
