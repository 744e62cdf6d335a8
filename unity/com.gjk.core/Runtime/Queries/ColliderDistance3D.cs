using System;
using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>How far two colliders are apart or how deep they overlap: in 3D what the engine's
    /// <c>ColliderDistance2D</c> is in 2D, with the same members. World units, world frame. Immutable.</summary>
    /// <remarks>Always pointB = pointA + normal * distance. Moving collider A by normal * distance makes the two touch,
    /// from either side; of shapes that are not convex, the two parts that overlap deepest, or that are nearest. Those
    /// that touch count as overlapped, at distance 0: they share a point, as <c>Physics.OverlapBox</c> and the engine's
    /// triggers see it, while <c>ColliderDistance2D.isOverlapped</c> asks for <c>distance &lt; 0</c>. Ask for that
    /// yourself where touching is to count as apart.</remarks>
    public readonly struct ColliderDistance3D
    {
        internal ColliderDistance3D(in DistanceResult result)
        {
            distance = result.Distance;
            normal = result.Normal.ToUnity();
            pointA = result.PointA.ToUnity();
            pointB = result.PointB.ToUnity();
            isOverlapped = result.Status == GjkStatus.Overlapping;
            isValid = isOverlapped || result.Status == GjkStatus.Separated;
            iterations = result.Iterations;
        }

        /// <summary>The distance; minus the depth when they overlap, 0 where no parts of two surfaces do; NaN when not
        /// valid.</summary>
        public float distance { get; }

        /// <summary>A unit vector from A to B; when they overlap, the direction in which B leaves A by the shortest
        /// way.</summary>
        public Vector3 normal { get; }

        /// <summary>The point of A closest to B; when they overlap, the one deepest in B.</summary>
        public Vector3 pointA { get; }

        /// <summary>The point of B closest to A; when they overlap, the one deepest in A.</summary>
        public Vector3 pointB { get; }

        /// <summary>Whether they share a point, touching included.</summary>
        public bool isOverlapped { get; }

        /// <summary>False for <c>default</c>, and where the query did not end with an answer.</summary>
        public bool isValid { get; }

        /// <summary>How many support points of each the query asked for.</summary>
        public int iterations { get; }

        /// <summary>The same with A and B exchanged.</summary>
        public ColliderDistance3D swapped => new ColliderDistance3D(this);

        private ColliderDistance3D(in ColliderDistance3D other)
        {
            distance = other.distance;
            normal = -other.normal;
            pointA = other.pointB;
            pointB = other.pointA;
            isOverlapped = other.isOverlapped;
            isValid = other.isValid;
            iterations = other.iterations;
        }

        /// <summary>For people to read.</summary>
        public override string ToString() =>
            !isValid ? "not valid"
                : FormattableString.Invariant($"{(isOverlapped ? "overlapped" : "apart")}, distance {distance:G6}, ")
                    + FormattableString.Invariant($"{pointA} to {pointB}");
    }
}
