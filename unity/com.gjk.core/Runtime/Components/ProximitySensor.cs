using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Events;

namespace Gjk.Unity
{
    /// <summary>Finds in every frame all colliders within a distance of this object's own shape, and tells when one
    /// comes near and when it leaves.</summary>
    /// <remarks>The colliders are those of a <see cref="GjkWorld"/>, or else the sensor's own, which it collects when
    /// it is enabled, and by <see cref="Rescan"/> and <see cref="Watch"/>; moving ones are read in every frame, static
    /// ones once. The colliders of this object and of its children are left out. Nothing is allocated per frame once
    /// the lists have their size. Destroyed colliders leave by themselves. One that has no shape is reported once, and
    /// left out until it is switched off and on. Each <see cref="Entered"/> has one <see cref="Exited"/>, whatever a
    /// listener does: it may disable the sensor, call <see cref="Sense"/> or throw, which is logged.</remarks>
    [AddComponentMenu("Gjk/Proximity Sensor")]
    [DisallowMultipleComponent]
    public sealed class ProximitySensor : MonoBehaviour
    {
        [SerializeField]
        [Min(0)]
        [Tooltip("World units from surface to surface; 0 finds what touches.")]
        private float _radius = 1;

        [SerializeField]
        [Tooltip("Only objects in these layers are found.")]
        private LayerMask _layers = ~0;

        [SerializeField]
        [Tooltip("The colliders to look among, shared with other sensors; the sensor's own when empty.")]
        private GjkWorld _world;

        [SerializeField]
        [Tooltip("Without a world: only colliders of this object and its children; the whole scene when empty.")]
        private GameObject _root;

        [SerializeField]
        [Tooltip("Find triggers, too, and count those of this object to its shape.")]
        private bool _includeTriggers;

        [SerializeField]
        [Tooltip("Take closed meshes that are not convex with what they enclose, not as surfaces.")]
        private bool _solidMeshes;

        [SerializeField]
        [Tooltip("Called with the collider that has come near.")]
        private UnityEvent<Component> _entered = new UnityEvent<Component>();

        [SerializeField]
        [Tooltip("Called with the collider that has left.")]
        private UnityEvent<Component> _exited = new UnityEvent<Component>();

        private readonly ShapeSource _own = new ShapeSource();
        private readonly ColliderScene _scene = new ColliderScene();
        private readonly List<ProximityHit> _near = new List<ProximityHit>();

        /// <summary>Those of which it was told that they came near, and not yet that they left.</summary>
        private readonly HashSet<Component> _told = new HashSet<Component>(ColliderScene.ByReference.Comparer);

        private readonly HashSet<Component> _now = new HashSet<Component>(ColliderScene.ByReference.Comparer);
        private readonly List<Component> _changed = new List<Component>();

        /// <summary>Counts the lists of changes: the older one is dropped where a listener made another.</summary>
        private int _changes;

        /// <summary>World units from surface to surface, at least 0.</summary>
        public float Radius
        {
            get => _radius;
            set => _radius = value >= 0
                ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "Must not be negative or NaN.");
        }

        /// <summary>Only objects in these layers are found.</summary>
        public LayerMask Layers
        {
            get => _layers;
            set => _layers = value;
        }

        /// <summary>The colliders to look among; null for the sensor's own.</summary>
        public GjkWorld World
        {
            get => _world;
            set => _world = value;
        }

        /// <summary>Where <see cref="Rescan"/> looks; everywhere when null.</summary>
        public GameObject Root
        {
            get => _root;
            set => _root = value;
        }

        /// <summary>Whether triggers are found, and those of this object belong to its shape.</summary>
        public bool IncludeTriggers
        {
            get => _includeTriggers;
            set => _includeTriggers = value;
        }

        /// <summary>Whether closed meshes that are not convex count with what they enclose. A mesh that is known
        /// already keeps what it was taken for until it is switched off and on.</summary>
        public bool SolidMeshes
        {
            get => _solidMeshes;
            set => _solidMeshes = value;
        }

        /// <summary>Called with the collider that has come near.</summary>
        public UnityEvent<Component> Entered
        {
            get => _entered;
            set => _entered = value;
        }

        /// <summary>Called with the collider that has left, was switched off or was destroyed; then it equals
        /// null.</summary>
        public UnityEvent<Component> Exited
        {
            get => _exited;
            set => _exited = value;
        }

        /// <summary>What is near now, in no order. The list is the sensor's own and changes with each frame.</summary>
        public IReadOnlyList<ProximityHit> Near => _near;

        /// <summary>How many colliders are watched.</summary>
        public int WatchedCount => _world != null ? _world.Count : _scene.Count;

        /// <summary>Null, or why the sensor itself has no shape.</summary>
        public string Problem => _own.Problem;

        /// <summary>The nearest thing within the radius, of several the first that the sensor came to know.</summary>
        /// <returns>False when nothing is near.</returns>
        public bool TryGetNearest(out ProximityHit nearest)
        {
            nearest = default;
            for (int i = 0; i < _near.Count; i++)
            {
                if (i == 0 || _near[i].Distance.distance < nearest.Distance.distance) nearest = _near[i];
            }

            return _near.Count > 0;
        }

        /// <summary>Collects all colliders anew: below the root, or in the whole scene. This allocates.</summary>
        public void Rescan()
        {
            foreach (Component collider in SceneColliders.Below(_root)) Watch(collider);
        }

        /// <summary>Also watches one collider or mesh filter, such as one that was made later.</summary>
        /// <returns>False when it is watched already, or is part of the sensor's own object or its children.</returns>
        /// <exception cref="ArgumentNullException">There is none, or it was destroyed.</exception>
        public bool Watch(Component source)
        {
            if (source == null) throw new ArgumentNullException(nameof(source));
            return !source.transform.IsChildOf(transform) && _scene.Add(source);
        }

        /// <summary>Watches something no longer, without telling that it leaves.</summary>
        /// <returns>False when it is not watched.</returns>
        public bool Unwatch(Component source)
        {
            if (!_scene.Remove(source)) return false;
            _told.Remove(source);
            return true;
        }

        /// <summary>Looks now instead of at the end of the frame.</summary>
        public void Sense()
        {
            ColliderScene scene = _scene;
            if (_world != null)
            {
                scene = _world.Fresh();
            }
            else
            {
                scene.IsSolid = _solidMeshes;
                scene.Refresh();
            }

            _near.Clear();
            bool isRead = _own.Read(gameObject, _solidMeshes, _includeTriggers);
            _own.Report(this);
            var filter = new SceneFilter(_layers.value, transform, _includeTriggers);
            for (int i = 0; isRead && i < _own.Shapes.Count; i++)
            {
                scene.CollectWithin(_own.Shapes[i], _radius, filter, _near);
                if (i > 0) KeepNearest();
            }

            Tell();
        }

        private void OnEnable()
        {
            if (_world == null) Rescan();
        }

        private void OnDisable()
        {
            _near.Clear();
            Tell();
        }

        private void LateUpdate() => Sense();

        private void OnDrawGizmos()
        {
            for (int i = 0; i < _near.Count; i++)
            {
                ColliderDistance3D distance = _near[i].Distance;
                Gizmos.color = distance.isOverlapped ? Color.red : Color.white;
                Gizmos.DrawLine(distance.pointA, distance.pointB);
            }
        }

        /// <summary>Of what two of the sensor's own shapes have found, the nearer.</summary>
        private void KeepNearest()
        {
            for (int i = _near.Count - 1; i > 0; i--)
            {
                int first = i;
                while (--first >= 0 && !ReferenceEquals(_near[first].Source, _near[i].Source))
                {
                }

                if (first < 0) continue;
                if (_near[i].Distance.distance < _near[first].Distance.distance) _near[first] = _near[i];
                _near.RemoveAt(i);
            }
        }

        /// <summary>Calls the events, leaving before entering. What a listener is told is noted before it is called;
        /// and where it makes the sensor look again or switches it off, that has told the rest.</summary>
        private void Tell()
        {
            int own = ++_changes;
            _now.Clear();
            _changed.Clear();
            for (int i = 0; i < _near.Count; i++) _now.Add(_near[i].Source);
            foreach (Component source in _told)
            {
                if (!_now.Contains(source)) _changed.Add(source);
            }

            for (int i = 0; i < _near.Count; i++)
            {
                if (!_told.Contains(_near[i].Source)) _changed.Add(_near[i].Source);
            }

            for (int i = 0; i < _changed.Count && own == _changes; i++)
            {
                Component source = _changed[i];
                bool hasEntered = !_told.Remove(source);
                if (hasEntered) _told.Add(source);
                try
                {
                    (hasEntered ? _entered : _exited).Invoke(source);
                }
                catch (Exception exception)
                {
                    Debug.LogException(exception, this);
                }
            }
        }
    }
}
