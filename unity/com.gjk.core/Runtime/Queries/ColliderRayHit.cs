using System;
using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>Where a ray meets a collider. World units, world frame. Immutable.</summary>
    public readonly struct ColliderRayHit
    {
        internal ColliderRayHit(in RayCastResult result, int triangle, Collider met)
        {
            distance = result.Distance;
            point = result.Point.ToUnity();
            normal = result.Normal.ToUnity();
            triangleIndex = triangle;
            isOverlappedAtStart = result.Status == CastStatus.OverlappingAtStart;
            collider = met;
        }

        /// <summary>The collider that was met.</summary>
        public Collider collider { get; }

        /// <summary>From the ray's origin; 0 where that is inside.</summary>
        public float distance { get; }

        /// <summary>Where they meet.</summary>
        public Vector3 point { get; }

        /// <summary>The unit normal of the surface there, towards the ray's origin.</summary>
        public Vector3 normal { get; }

        /// <summary>Which triangle of a mesh that is not convex was met, else -1.</summary>
        public int triangleIndex { get; }

        /// <summary>Whether the ray begins inside.</summary>
        public bool isOverlappedAtStart { get; }

        /// <summary>For people to read.</summary>
        public override string ToString() =>
            FormattableString.Invariant($"hit at {distance:G6}, point {point}, normal {normal}");
    }
}
