using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>
    /// Where a moving collider first touches another one. World units, world frame. Immutable.
    /// </summary>
    public readonly struct ColliderCastHit
    {
        internal ColliderCastHit(in CastResult result, float reach)
        {
            fraction = result.Fraction;
            distance = result.Fraction * reach;
            point = result.Point.ToUnity();
            normal = result.IsHit ? (-result.Normal).ToUnity() : Vector3.zero;
            depth = result.Depth;
            isOverlappedAtStart = result.Status == CastStatus.OverlappingAtStart;
        }

        /// <summary>How far the collider moved until it touched; 0 where the two overlapped before.</summary>
        public float distance { get; }

        /// <summary>The same as a part of the longest way, 0 to 1.</summary>
        public float fraction { get; }

        /// <summary>A point that the two share then.</summary>
        public Vector3 point { get; }

        /// <summary>
        /// The unit normal of the surface that was hit, towards the collider that moved. Where the two overlapped
        /// before, it is the direction in which that one leaves the other by the shortest way; zero where the search
        /// ended at its limit, with nothing in the way up to the distance.
        /// </summary>
        public Vector3 normal { get; }

        /// <summary>World units: how far it has to leave along the normal; 0 where they did not overlap.</summary>
        public float depth { get; }

        /// <summary>Whether they overlapped before anything moved.</summary>
        public bool isOverlappedAtStart { get; }
    }
}
