using System;
using System.Collections.Generic;
using Gjk.Core;
using UnityEngine;
using UnityEngine.Events;

namespace Gjk.Unity
{
    /// <summary>
    /// Finds in every frame all colliders within a distance of this object's own shape, and tells when one comes near
    /// and when it leaves.
    /// </summary>
    /// <remarks>
    /// The colliders are collected when the sensor is enabled, and by <see cref="Rescan"/> and <see cref="Watch"/>;
    /// moving ones are read in every frame, static ones once. Nothing is allocated per frame once the lists have their
    /// size. Destroyed colliders leave by themselves. One that has no convex shape is reported once, and left out until
    /// it is switched off and on.
    /// </remarks>
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
        [Tooltip("Only colliders of this object and its children; the whole scene when empty.")]
        private GameObject _root;

        [SerializeField]
        [Tooltip("Called with the collider that has come near.")]
        private UnityEvent<Component> _entered = new UnityEvent<Component>();

        [SerializeField]
        [Tooltip("Called with the collider that has left.")]
        private UnityEvent<Component> _exited = new UnityEvent<Component>();

        private readonly ShapeSource _own = new ShapeSource();
        private readonly List<Watched> _watched = new List<Watched>();
        private readonly List<Watched> _changed = new List<Watched>();
        private readonly Dictionary<int, Watched> _byId = new Dictionary<int, Watched>();
        private readonly List<PairDistance> _pairs = new List<PairDistance>();
        private readonly List<ProximityHit> _near = new List<ProximityHit>();
        private readonly CollisionScene _scene = new CollisionScene();
        private ConvexShape _shape;
        private LayerMask _sceneLayers;
        private int _id = -1;

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

        /// <summary>Where <see cref="Rescan"/> looks; everywhere when null.</summary>
        public GameObject Root
        {
            get => _root;
            set => _root = value;
        }

        /// <summary>Called with the collider that has come near.</summary>
        public UnityEvent<Component> Entered
        {
            get => _entered;
            set => _entered = value;
        }

        /// <summary>
        /// Called with the collider that has left, was switched off or was destroyed; then it equals null.
        /// </summary>
        public UnityEvent<Component> Exited
        {
            get => _exited;
            set => _exited = value;
        }

        /// <summary>What is near now, in no order. The list is the sensor's own and changes with each frame.</summary>
        public IReadOnlyList<ProximityHit> Near => _near;

        /// <summary>How many colliders are watched.</summary>
        public int WatchedCount => _watched.Count;

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
            Collider[] all = _root != null ? _root.GetComponentsInChildren<Collider>() : FindObjectsOfType<Collider>();
            foreach (Collider collider in all) Watch(collider);
        }

        /// <summary>Also watches one collider or mesh filter, such as one that was made later.</summary>
        /// <returns>False when it is watched already, or is part of the sensor's own object.</returns>
        /// <exception cref="ArgumentNullException">There is none, or it was destroyed.</exception>
        public bool Watch(Component source)
        {
            if (source == null) throw new ArgumentNullException(nameof(source));
            if (source.gameObject == gameObject || IndexOf(source) >= 0) return false;
            _watched.Add(new Watched(source));
            return true;
        }

        /// <summary>Watches something no longer, without telling that it leaves.</summary>
        /// <returns>False when it is not watched.</returns>
        public bool Unwatch(Component source)
        {
            int index = IndexOf(source);
            if (index < 0) return false;
            Drop(index);
            return true;
        }

        /// <summary>Looks now instead of at the end of the frame.</summary>
        public void Sense()
        {
            for (int i = _watched.Count - 1; i >= 0; i--) Update(_watched[i]);
            _near.Clear();
            if (PlaceSensor())
            {
                _scene.FindPairsWithin(_radius, _pairs);
                for (int i = 0; i < _pairs.Count; i++) Note(_pairs[i]);
            }

            Tell();
        }

        private void OnEnable() => Rescan();

        private void OnDisable()
        {
            for (int i = 0; i < _watched.Count; i++) _watched[i].IsNear = false;
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

        private int IndexOf(Component source)
        {
            for (int i = 0; i < _watched.Count; i++)
            {
                if (ReferenceEquals(_watched[i].Source, source)) return i;
            }

            return -1;
        }

        private void Drop(int index)
        {
            Watched watched = _watched[index];
            _byId.Remove(watched.Id);
            watched.Leave(_scene);
            _watched.RemoveAt(index);
        }

        private void Update(Watched watched)
        {
            int before = watched.Id;
            watched.IsNear = false;
            watched.Update(_scene);
            if (watched.Id == before) return;
            _byId.Remove(before);
            if (watched.Id >= 0) _byId.Add(watched.Id, watched);
        }

        private bool PlaceSensor()
        {
            bool isRead = _own.Read(gameObject, out PosedShape posed);
            _own.Report(this);
            bool isSame = isRead && posed.Shape == _shape && _sceneLayers.value == _layers.value;
            if (_id >= 0 && isSame)
            {
                _scene.Move(_id, posed.Pose);
                return true;
            }

            if (_id >= 0) _scene.Remove(_id);
            _id = -1;
            if (!isRead) return false;

            // In all groups, so that nothing's mask refuses it; its own mask is the filter.
            var settings = new ObjectSettings(groups: uint.MaxValue, mask: (uint)_layers.value);
            _id = _scene.Add(posed.Shape, posed.Pose, settings);
            _shape = posed.Shape;
            _sceneLayers = _layers;
            return true;
        }

        private void Note(in PairDistance found)
        {
            bool isFirst = found.Pair.A == _id;
            Watched watched = _byId[isFirst ? found.Pair.B : found.Pair.A];
            watched.IsNear = true;
            _near.Add(new ProximityHit(
                watched.Source, new ColliderDistance3D(isFirst ? found.Result : found.Result.Swapped)));
        }

        /// <summary>
        /// Calls the events after all is up to date, since a listener may do anything, and drops what is destroyed.
        /// </summary>
        private void Tell()
        {
            _changed.Clear();
            for (int i = _watched.Count - 1; i >= 0; i--)
            {
                Watched watched = _watched[i];
                if (watched.IsNear != watched.WasNear) _changed.Add(watched);
                watched.WasNear = watched.IsNear;
                if (watched.IsGone) Drop(i);
            }

            for (int i = 0; i < _changed.Count; i++)
                (_changed[i].IsNear ? _entered : _exited).Invoke(_changed[i].Source);
        }
    }
}
