using UnityEngine;
using UnityEngine.Events;

namespace Gjk.Unity
{
    /// <summary>
    /// Measures the distance between this object and another one in every frame, and tells when they begin and end to
    /// overlap. In the scene view a line joins the closest points: white when apart, red when overlapping.
    /// </summary>
    /// <remarks>
    /// Each of the two needs a collider or, where it has none, a mesh filter. Nothing is allocated per frame as long as
    /// both can be measured.
    /// </remarks>
    [AddComponentMenu("Gjk/Convex Distance")]
    [DisallowMultipleComponent]
    public sealed class ConvexDistance : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("The other object: with a box, sphere, capsule or convex mesh collider, or a mesh filter.")]
        private GameObject _target;

        [SerializeField]
        [Tooltip("Called in the frame in which the two begin to overlap.")]
        private UnityEvent _entered = new UnityEvent();

        [SerializeField]
        [Tooltip("Called in the frame in which they no longer overlap.")]
        private UnityEvent _exited = new UnityEvent();

        private readonly ShapeSource _own = new ShapeSource(), _other = new ShapeSource();
        private ColliderDistance3D _result;
        private bool _wasOverlapped;

        /// <summary>The other object.</summary>
        public GameObject Target
        {
            get => _target;
            set => _target = value;
        }

        /// <summary>Called in the frame in which the two begin to overlap.</summary>
        public UnityEvent Entered
        {
            get => _entered;
            set => _entered = value;
        }

        /// <summary>Called in the frame in which they no longer overlap.</summary>
        public UnityEvent Exited
        {
            get => _exited;
            set => _exited = value;
        }

        /// <summary>
        /// What the last frame found; A is this object, B the other. Not valid while one of them cannot be measured.
        /// </summary>
        public ColliderDistance3D Result => _result;

        /// <summary>Null, or why there is no result.</summary>
        public string Problem => _own.Problem ?? _other.Problem;

        /// <summary>Measures now instead of at the end of the frame.</summary>
        public ColliderDistance3D Measure()
        {
            bool isReady = _own.Read(gameObject, out PosedShape a) & _other.Read(_target, out PosedShape b);
            _result = isReady ? GjkPhysics.Distance(a, b) : default;
            return _result;
        }

        private void OnDisable() => Tell(false);

        private void LateUpdate()
        {
            Measure();
            _own.Report(this);
            _other.Report(this);
            Tell(_result.isOverlapped);
        }

        private void OnDrawGizmos()
        {
            if (!Application.isPlaying) Measure();
            if (!_result.isValid) return;
            Gizmos.color = _result.isOverlapped ? Color.red : Color.white;
            Gizmos.DrawLine(_result.pointA, _result.pointB);
        }

        private void Tell(bool isOverlapped)
        {
            if (isOverlapped == _wasOverlapped) return;
            _wasOverlapped = isOverlapped;
            (isOverlapped ? _entered : _exited).Invoke();
        }
    }
}
