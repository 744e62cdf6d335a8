using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>Finds colliders once, where nobody names them.</summary>
    internal static class SceneColliders
    {
        /// <summary>Those of an object and its children, or of all scenes when it is null. This allocates.</summary>
        public static Collider[] Below(GameObject root)
        {
            if (root != null) return root.GetComponentsInChildren<Collider>();
#if UNITY_6000_4_OR_NEWER
            return Object.FindObjectsByType<Collider>();
#elif UNITY_2023_1_OR_NEWER
            return Object.FindObjectsByType<Collider>(FindObjectsSortMode.None);
#else
            return Object.FindObjectsOfType<Collider>();
#endif
        }
    }
}
