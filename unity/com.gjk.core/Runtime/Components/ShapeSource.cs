using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>
    /// Reads the shape of a game object in each frame: of its collider, or else of its mesh filter.
    /// </summary>
    internal sealed class ShapeSource
    {
        private GameObject _owner;
        private Component _source;
        private string _reported;

        /// <summary>Null, or why the last reading found no shape.</summary>
        public string Problem { get; private set; }

        /// <summary>The collider of an object, or its mesh filter, or null.</summary>
        public static Component Of(GameObject owner)
        {
            if (owner.TryGetComponent(out Collider collider)) return collider;
            return owner.TryGetComponent(out MeshFilter filter) ? filter : null;
        }

        public bool Read(GameObject owner, out PosedShape posed)
        {
            posed = default;
            if (owner == null)
            {
                _owner = null;
                Problem = "There is no target.";
                return false;
            }

            if (_source == null || owner != _owner)
            {
                _owner = owner;
                _source = Of(owner);
            }

            if (_source == null)
            {
                Problem = "'" + owner.name + "' has neither a collider nor a mesh filter.";
                return false;
            }

            bool isRead = GjkShapes.TryFrom(_source, out posed, out string reason);
            Problem = reason;
            return isRead;
        }

        /// <summary>Logs a problem once, not in every frame.</summary>
        public void Report(Object context)
        {
            if (Problem == _reported) return;
            _reported = Problem;
            if (Problem != null) Debug.LogWarning(Problem, context);
        }
    }
}
