using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>Brings the colliders of its object and children to a <see cref="GjkWorld"/> when it is enabled, and
    /// takes them out when it is disabled: for prefabs that are spawned. Without it, only those are found that were
    /// there when the world was enabled.</summary>
    [AddComponentMenu("Gjk/World Member")]
    [DisallowMultipleComponent]
    public sealed class GjkMember : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("The world; the one that was enabled last when empty.")]
        private GjkWorld _world;

        private GjkWorld _joined;
        private Component[] _colliders;

        /// <summary>The world; null for the one that was enabled last.</summary>
        public GjkWorld World
        {
            get => _world;
            set => _world = value;
        }

        private void OnEnable()
        {
            _joined = _world != null ? _world : GjkWorld.Current;
            if (_joined == null) return;
            _colliders = SceneColliders.Below(gameObject);
            foreach (Component collider in _colliders) _joined.Add(collider);
        }

        private void OnDisable()
        {
            if (_joined == null) return;
            foreach (Component collider in _colliders) _joined.Remove(collider);
            _joined = null;
        }
    }
}
