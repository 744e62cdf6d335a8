using System;
using System.Collections.Generic;
using Gjk.Core;
using UnityEngine;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>All colliders of some layers in one scene, for sensors to share and for questions about all of them:
    /// what is near, what a ray meets, what a moving collider meets.</summary>
    /// <remarks>It collects the colliders once, when it is enabled. Those that are made later belong to it by a
    /// <see cref="GjkMember"/> on their object, or by <see cref="Add(GameObject)"/>; destroyed ones leave by
    /// themselves. Before the first question of a frame all that is not static is read again; after moving things in
    /// the same frame, call <see cref="Refresh"/>. For the main thread. Questions allocate nothing once lists have
    /// their size.</remarks>
    [AddComponentMenu("Gjk/World")]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(-100)]
    public sealed class GjkWorld : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Only colliders of objects in these layers belong to it.")]
        private LayerMask _layers = ~0;

        [SerializeField]
        [Tooltip("Take closed meshes that are not convex with what they enclose, not as surfaces.")]
        private bool _solidMeshes;

        private readonly ColliderScene _scene = new ColliderScene();
        private readonly List<ProximityHit> _hits = new List<ProximityHit>();
        private int _freshIn = -1;

        /// <summary>The world that was enabled last, or null: that of members that name none.</summary>
        public static GjkWorld Current { get; private set; }

        /// <summary>Only colliders of objects in these layers belong to it.</summary>
        public LayerMask Layers
        {
            get => _layers;
            set => _layers = value;
        }

        /// <summary>Whether closed meshes that are not convex count with what they enclose. Set it before they are
        /// added.</summary>
        public bool SolidMeshes
        {
            get => _solidMeshes;
            set => _solidMeshes = value;
        }

        /// <summary>How many colliders belong to it.</summary>
        public int Count => _scene.Count;

        /// <summary>Adds an object's colliders, and those of its children. This allocates.</summary>
        /// <exception cref="ArgumentNullException">There is none, or it was destroyed.</exception>
        public void Add(GameObject owner)
        {
            if (owner == null) throw new ArgumentNullException(nameof(owner));
            foreach (Collider collider in owner.GetComponentsInChildren<Collider>()) Add(collider);
        }

        /// <summary>Adds a collider or mesh filter, whatever its layer was when the others were collected.</summary>
        /// <returns>False when it belongs to the world already, or its layer does not.</returns>
        /// <exception cref="ArgumentNullException">There is none, or it was destroyed.</exception>
        public bool Add(Component source)
        {
            if (source == null) throw new ArgumentNullException(nameof(source));
            _freshIn = -1;
            return (_layers.value >> source.gameObject.layer & 1) != 0 && _scene.Add(source);
        }

        /// <summary>Removes a collider or mesh filter.</summary>
        /// <returns>False when it does not belong to the world.</returns>
        public bool Remove(Component source) => !(source is null) && _scene.Remove(source);

        /// <summary>Reads again where all colliders are.</summary>
        public void Refresh()
        {
            _freshIn = Time.frameCount;
            _scene.IsSolid = _solidMeshes;
            _scene.Refresh();
        }

        /// <summary>What is within a distance of a collider; its own object and children are left out.</summary>
        /// <param name="collider">It need not belong to the world.</param>
        /// <param name="distance">World units from surface to surface, at least 0.</param>
        /// <param name="results">Gets what is near, in no order; those that do not fit are left out.</param>
        /// <param name="layerMask">Only objects in these layers are found.</param>
        /// <returns>How many there are.</returns>
        public int WithinNonAlloc(Collider collider, float distance, ProximityHit[] results, int layerMask = ~0)
        {
            if (results == null) throw new ArgumentNullException(nameof(results));
            if (!(distance >= 0))
                throw new ArgumentOutOfRangeException(nameof(distance), distance, "Must be a number from 0 on.");
            PosedShape shape = GjkShapes.From(collider, _solidMeshes);
            _hits.Clear();
            Fresh().CollectWithin(shape, distance, Filter(collider, layerMask), _hits);
            int count = Math.Min(_hits.Count, results.Length);
            for (int i = 0; i < count; i++) results[i] = _hits[i];
            return count;
        }

        /// <summary>What is nearest to a collider, with the arguments of the other.</summary>
        /// <returns>False when nothing is within the distance.</returns>
        public bool TryGetNearest(
            Collider collider, out ProximityHit nearest, float maxDistance = Mathf.Infinity, int layerMask = ~0)
        {
            nearest = default;
            PosedShape shape = GjkShapes.From(collider, _solidMeshes);
            _hits.Clear();
            Fresh().CollectWithin(shape, maxDistance, Filter(collider, layerMask), _hits);
            for (int i = 0; i < _hits.Count; i++)
            {
                if (i == 0 || _hits[i].Distance.distance < nearest.Distance.distance) nearest = _hits[i];
            }

            return _hits.Count > 0;
        }

        /// <summary>What a ray meets first, with the arguments of <c>Physics.Raycast</c>.</summary>
        public bool Raycast(
            Vector3 origin, Vector3 direction, out ColliderRayHit hit, float maxDistance = Mathf.Infinity,
            int layerMask = ~0)
        {
            PairQueries.Way(direction, maxDistance, out float _);
            var ray = new RayQuery(origin.ToNumerics(), direction.ToNumerics(), maxDistance);
            bool isHit = Fresh().TryRayCast(
                ray, Filter(null, layerMask), out RayCastResult result, out int triangle, out Component met);
            hit = isHit ? new ColliderRayHit(result, triangle, met as Collider) : default;
            return isHit;
        }

        /// <summary>What a collider meets first when it moves; itself, its object and its children are passed. The
        /// arguments are those of <c>Rigidbody.SweepTest</c>.</summary>
        public bool ColliderCast(
            Collider collider, Vector3 direction, out ColliderCastHit hit, float maxDistance = Mathf.Infinity,
            int layerMask = ~0)
        {
            Numerics.Vector3 way = PairQueries.Way(direction, maxDistance, out float maxFraction);
            PosedShape shape = GjkShapes.From(collider, _solidMeshes);
            bool isHit = Fresh().TryCast(
                shape, way, maxFraction, Filter(collider, layerMask), out CastResult result, out Component met);
            hit = isHit ? new ColliderCastHit(result, maxDistance, met as Collider) : default;
            return isHit;
        }

        /// <summary>The colliders, read in this frame.</summary>
        internal ColliderScene Fresh()
        {
            if (_freshIn != Time.frameCount) Refresh();
            return _scene;
        }

        private static SceneFilter Filter(Collider own, int layerMask) =>
            new SceneFilter(layerMask, own is null ? null : own.transform, withTriggers: true);

        /// <summary>A project can keep the domain when play begins. It is not called Reset, which the engine would call
        /// for a component.</summary>
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Begin() => Current = null;

        private void OnEnable()
        {
            Current = this;
            foreach (Component collider in SceneColliders.Below(null)) Add(collider);
        }

        private void OnDisable()
        {
            if (ReferenceEquals(Current, this)) Current = null;
        }
    }
}
