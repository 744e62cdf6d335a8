using System;
using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>Where two colliders touch, or nearly do. World units, world frame. Immutable.</summary>
    public readonly struct ColliderContact
    {
        internal ColliderContact(in ManifoldPoint point, System.Numerics.Vector3 direction)
        {
            pointA = point.PointA.ToUnity();
            pointB = point.PointB.ToUnity();
            normal = direction.ToUnity();
            separation = point.Gap;
        }

        /// <summary>On the surface of A.</summary>
        public Vector3 pointA { get; }

        /// <summary>On the surface of B.</summary>
        public Vector3 pointB { get; }

        /// <summary>A unit vector from A to B, the same for all points of a pair of parts.</summary>
        public Vector3 normal { get; }

        /// <summary>Between the two points along the normal; negative inside each other.</summary>
        public float separation { get; }

        /// <summary>For people to read.</summary>
        public override string ToString() =>
            FormattableString.Invariant($"separation {separation:G6}, {pointA} to {pointB}, normal {normal}");
    }
}
