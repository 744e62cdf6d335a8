using UnityEngine;
using UnityEngine.Events;

namespace Gjk.Unity
{
    /// <summary>Measures the distance between this object and another one in every frame, and tells when they begin and
    /// end to overlap. In the scene view a line joins the closest points: white when apart, red when
    /// overlapping.</summary>
    /// <remarks>Each of the two is all its colliders, those of its children among them where it is a Rigidbody, or its
    /// mesh filter where it has none. Nothing is allocated per frame as long as both can be measured.</remarks>
    [AddComponentMenu("Gjk/Convex Distance")]
    [DisallowMultipleComponent]
    public sealed class ConvexDistance : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("The other object: with colliders, or a mesh filter.")]
        private GameObject _target;

        [SerializeField]
        [Tooltip("Count triggers to the shapes of both objects.")]
        private bool _includeTriggers;

        [SerializeField]
        [Tooltip("Take closed meshes that are not convex with what they enclose, not as surfaces.")]
        private bool _solidMeshes;

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

        /// <summary>Whether triggers belong to the shapes of both objects.</summary>
        public bool IncludeTriggers
        {
            get => _includeTriggers;
            set => _includeTriggers = value;
        }

        /// <summary>Whether closed meshes that are not convex count with what they enclose.</summary>
        public bool SolidMeshes
        {
            get => _solidMeshes;
            set => _solidMeshes = value;
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

        /// <summary>What the last frame found; A is this object, B the other. Not valid while one of them cannot be
        /// measured, nor while the component is disabled.</summary>
        public ColliderDistance3D Result => _result;

        /// <summary>Null, or why there is no result.</summary>
        public string Problem => _own.Problem ?? _other.Problem;

        /// <summary>Measures now instead of at the end of the frame.</summary>
        public ColliderDistance3D Measure()
        {
            bool isReady = _own.Read(gameObject, _solidMeshes, _includeTriggers)
                & _other.Read(_target, _solidMeshes, _includeTriggers);
            _result = isReady ? _own.DistanceTo(_other) : default;
            return _result;
        }

        private void OnDisable()
        {
            _result = default;
            Tell(false);
        }

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
