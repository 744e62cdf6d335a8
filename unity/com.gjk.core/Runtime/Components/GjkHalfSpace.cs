using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>All space below a plane, as a floor that never ends: the plane goes through the object's position, and
    /// its y axis leads out. It is turned with the object; scales change nothing.</summary>
    /// <remarks>Worlds and sensors find it as they find colliders, and an object with it has it among its shapes. It is
    /// no collider of the engine's: results name it where they name a component, and have no collider. Two of them have
    /// no distance.</remarks>
    [AddComponentMenu("Gjk/Half-Space")]
    [DisallowMultipleComponent]
    public sealed class GjkHalfSpace : MonoBehaviour
    {
        /// <summary>World units: half the side of the square that the scene view shows.</summary>
        private const float Shown = 5;

        private void OnDrawGizmosSelected()
        {
            Vector3 at = transform.position, along = transform.rotation * Vector3.forward * Shown;
            Vector3 across = transform.rotation * Vector3.right * Shown;
            Gizmos.color = Color.green;
            Gizmos.DrawLine(at - along - across, at + along - across);
            Gizmos.DrawLine(at + along - across, at + along + across);
            Gizmos.DrawLine(at + along + across, at - along + across);
            Gizmos.DrawLine(at - along + across, at - along - across);
            Gizmos.DrawLine(at, at + transform.rotation * Vector3.up);
        }

        /// <summary>Scripts with this one have a switch in the inspector.</summary>
        private void OnEnable()
        {
        }
    }
}
