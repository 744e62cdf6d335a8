using System;
using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>Where a moving collider first touches another one. World units, world frame. Immutable.</summary>
    public readonly struct ColliderCastHit
    {
        internal ColliderCastHit(in CastResult result, float reach, Collider met)
        {
            // Of an endless way the fraction is the distance itself.
            bool isEndless = float.IsInfinity(reach);
            fraction = isEndless ? 0 : result.Fraction;
            distance = isEndless ? result.Fraction : result.Fraction * reach;
            collider = met;
            point = result.Point.ToUnity();
            normal = result.IsHit ? (-result.Normal).ToUnity() : Vector3.zero;
            depth = result.Depth;
            isOverlappedAtStart = result.Status == CastStatus.OverlappingAtStart;
        }

        /// <summary>The collider that was met.</summary>
        public Collider collider { get; }

        /// <summary>How far the collider moved until it touched; 0 where the two overlapped before.</summary>
        public float distance { get; }

        /// <summary>The same as a part of the longest way, 0 to 1; 0 where that is endless.</summary>
        public float fraction { get; }

        /// <summary>A point that the two share then.</summary>
        public Vector3 point { get; }

        /// <summary>The unit normal of the surface that was hit, towards the collider that moved. Where the two
        /// overlapped before, it is the direction in which that one leaves the other by the shortest way; zero where
        /// the search ended at its limit, with nothing in the way up to the distance.</summary>
        public Vector3 normal { get; }

        /// <summary>World units: how far it has to leave along the normal; 0 where they did not overlap.</summary>
        public float depth { get; }

        /// <summary>Whether they overlapped before anything moved.</summary>
        public bool isOverlappedAtStart { get; }

        /// <summary>For people to read.</summary>
        public override string ToString() =>
            isOverlappedAtStart
                ? FormattableString.Invariant($"overlapped at the start, depth {depth:G6}")
                : FormattableString.Invariant($"hit at {distance:G6}, point {point}, normal {normal}");
    }
}
