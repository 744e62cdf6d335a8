using System;
using System.Collections.Generic;
using Gjk.Core;
using UnityEngine;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>The queries of two posed shapes, convex or not: one place that knows which class of the library to ask.
    /// Memory for the search is kept for each thread.</summary>
    internal static class PairQueries
    {
        [ThreadStatic]
        private static ConcaveScratch _scratch;

        [ThreadStatic]
        private static List<PairDistance> _parts;

        [ThreadStatic]
        private static List<PairContacts> _contacts;

        private static ConcaveScratch Scratch => _scratch ?? (_scratch = new ConcaveScratch());

        /// <summary>The distance, 0 where the shapes overlap; beyond the limit the query may end.</summary>
        public static DistanceResult Distance(in PosedShape a, in PosedShape b, float maxDistance) =>
            a.IsConvex && b.IsConvex
                ? ConvexQuery.Distance(a.Shape, a.Pose, b.Shape, b.Pose, maxDistance)
                : ConcaveQuery.Distance(a.Any, a.Pose, b.Any, b.Pose, Scratch, maxDistance).Result;

        /// <summary>The distance, or minus the depth. Of shapes that are not convex it is that of the two parts that
        /// overlap deepest, and 0 where one lies inside the other without a part of its surface.</summary>
        public static DistanceResult Signed(in PosedShape a, in PosedShape b)
        {
            if (a.IsConvex && b.IsConvex) return ConvexQuery.SignedDistance(a.Shape, a.Pose, b.Shape, b.Pose);
            DistanceResult found = ConcaveQuery.SignedDistance(a.Any, a.Pose, b.Any, b.Pose, Scratch).Result;
            if (!found.IsOverlapping || found.Distance < 0) return found;
            if (_parts == null) _parts = new List<PairDistance>();
            ConcaveQuery.FindDepths(a.Any, a.Pose, b.Any, b.Pose, Scratch, _parts);
            for (int i = 0; i < _parts.Count; i++)
            {
                if (_parts[i].Distance < found.Distance) found = _parts[i].Result;
            }

            return found;
        }

        /// <summary>The points of contact; where there are more than fit, the deepest.</summary>
        /// <returns>How many there are in the results.</returns>
        public static int Contacts(in PosedShape a, in PosedShape b, float maxGap, ColliderContact[] results)
        {
            int count = 0;
            if (a.IsConvex && b.IsConvex)
            {
                ConvexQuery.Contacts(a.Shape, a.Pose, b.Shape, b.Pose, maxGap, out ContactManifold found);
                Keep(found, results, ref count);
                return count;
            }

            if (_contacts == null) _contacts = new List<PairContacts>();
            ConcaveQuery.FindContacts(a.Any, a.Pose, b.Any, b.Pose, maxGap, Scratch, _contacts);
            for (int i = 0; i < _contacts.Count; i++) Keep(_contacts[i].Manifold, results, ref count);
            return count;
        }

        private static void Keep(in ContactManifold manifold, ColliderContact[] results, ref int count)
        {
            for (int i = 0; i < manifold.Count; i++)
            {
                var point = new ColliderContact(manifold[i], manifold.Normal);
                if (count < results.Length)
                {
                    results[count++] = point;
                    continue;
                }

                int last = 0;
                for (int k = 1; k < count; k++)
                    if (results[k].separation > results[last].separation) last = k;
                if (count > 0 && point.separation < results[last].separation) results[last] = point;
            }
        }

        public static bool Overlaps(in PosedShape a, in PosedShape b) =>
            a.IsConvex && b.IsConvex
                ? ConvexQuery.Overlaps(a.Shape, a.Pose, b.Shape, b.Pose)
                : ConcaveQuery.Overlaps(a.Any, a.Pose, b.Any, b.Pose, Scratch);

        public static CastResult Cast(in PosedShape a, Numerics.Vector3 way, float maxFraction, in PosedShape b) =>
            a.IsConvex && b.IsConvex
                ? ConvexQuery.Cast(a.Shape, a.Pose, way, b.Shape, b.Pose, default, maxFraction)
                : ConcaveQuery.Cast(a.Any, a.Pose, way, b.Any, b.Pose, default, Scratch, maxFraction).Result;

        public static RayCastResult RayCast(
            in PosedShape shape, in RayQuery ray, RaySides sides, out int triangle)
        {
            triangle = -1;
            if (shape.IsConvex)
            {
                return ConvexQuery.RayCast(
                    shape.Shape, shape.Pose, ray.Origin, ray.Direction, ray.MaxDistance, sides: sides);
            }

            RayHit hit = ConcaveQuery.RayCast(
                shape.Any, shape.Pose, ray.Origin, ray.Direction, Scratch, ray.MaxDistance, sides: sides);
            triangle = hit.Part;
            return hit.Result;
        }

        /// <summary>The vector and the part of it that a motion along a direction is: all of a finite one, and of an
        /// endless one the direction itself, without end.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The direction has no length, or the distance is negative or
        /// NaN.</exception>
        public static Numerics.Vector3 Way(Vector3 direction, float maxDistance, out float maxFraction)
        {
            var given = new Double3(direction.x, direction.y, direction.z);
            double length = given.Length;
            if (!(length > 0) || double.IsInfinity(length))
                throw new ArgumentOutOfRangeException(nameof(direction), direction, "The direction has no length.");
            if (!(maxDistance >= 0))
                throw new ArgumentOutOfRangeException(nameof(maxDistance), maxDistance, "Must be a number from 0 on.");
            bool isEndless = float.IsInfinity(maxDistance);
            maxFraction = isEndless ? float.PositiveInfinity : 1;
            return (Numerics.Vector3)(given * ((isEndless ? 1 : maxDistance) / length));
        }
    }
}
