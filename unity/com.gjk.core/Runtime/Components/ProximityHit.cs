using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>Something that a <see cref="ProximitySensor"/> found. Immutable.</summary>
    public readonly struct ProximityHit
    {
        internal ProximityHit(Component source, in ColliderDistance3D distance)
        {
            Source = source;
            Distance = distance;
        }

        /// <summary>The collider or mesh filter.</summary>
        public Component Source { get; }

        /// <summary>How far it is; A is the sensor. The distance is 0, not a depth, when the two overlap.</summary>
        public ColliderDistance3D Distance { get; }

        /// <summary>For people to read.</summary>
        public override string ToString() => (Source == null ? "destroyed" : Source.name) + ": " + Distance;
    }
}
