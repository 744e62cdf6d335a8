using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>Finds colliders and half-spaces once, where nobody names them.</summary>
    internal static class SceneColliders
    {
        /// <summary>Those of an object and its children, or of all scenes when it is null. This allocates.</summary>
        public static Component[] Below(GameObject root)
        {
            Component[] colliders = Below<Collider>(root), halfSpaces = Below<GjkHalfSpace>(root);
            var all = new Component[colliders.Length + halfSpaces.Length];
            colliders.CopyTo(all, 0);
            halfSpaces.CopyTo(all, colliders.Length);
            return all;
        }

        private static T[] Below<T>(GameObject root)
            where T : Component
        {
            if (root != null) return root.GetComponentsInChildren<T>();
#if UNITY_6000_4_OR_NEWER
            return Object.FindObjectsByType<T>();
#elif UNITY_2023_1_OR_NEWER
            return Object.FindObjectsByType<T>(FindObjectsSortMode.None);
#else
            return Object.FindObjectsOfType<T>();
#endif
        }
    }
}
