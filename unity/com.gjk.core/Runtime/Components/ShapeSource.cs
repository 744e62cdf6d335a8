using System.Collections.Generic;
using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>Reads the shapes of a game object in each frame: of its colliders, those of its children among them
    /// where it is a rigid body, and its half-space, or else of its mesh filter.</summary>
    internal sealed class ShapeSource
    {
        private readonly List<Collider> _colliders = new List<Collider>();
        private readonly List<PosedShape> _shapes = new List<PosedShape>();
        private string _leftOut, _reported;
        private GameObject _owner;

        /// <summary>Null, or why the last reading found no shape.</summary>
        public string Problem { get; private set; }

        /// <summary>The shapes of the last reading; the object is all of them together.</summary>
        public IReadOnlyList<PosedShape> Shapes => _shapes;

        public bool Read(GameObject owner, bool isSolid, bool withTriggers)
        {
            _shapes.Clear();
            if (owner != _owner) _leftOut = null;
            _owner = owner;
            if (owner == null)
            {
                Problem = "There is no target.";
                return false;
            }

            Problem = null;
            Collect(owner);
            bool isAnyOn = false, isAnyRead = false;
            for (int i = 0; i < _colliders.Count; i++) isAnyOn |= IsOn(_colliders[i]);
            for (int i = 0; i < _colliders.Count; i++)
            {
                Collider collider = _colliders[i];
                if ((isAnyOn && !IsOn(collider)) || (collider.isTrigger && !withTriggers)) continue;
                isAnyRead = true;
                Add(collider, isSolid);
            }

            if (owner.TryGetComponent(out GjkHalfSpace halfSpace) && halfSpace.enabled)
            {
                isAnyRead = true;
                Add(halfSpace, isSolid);
            }

            if (!isAnyRead && owner.TryGetComponent(out MeshFilter filter)) Add(filter, isSolid);
            else if (!isAnyRead) Problem = "'" + owner.name + "' has no collider, half-space or mesh filter.";
            if (_shapes.Count > 0) Problem = null;
            return _shapes.Count > 0;
        }

        /// <summary>The distance, or minus the depth of the two shapes that overlap deepest; A is this.</summary>
        public ColliderDistance3D DistanceTo(ShapeSource other)
        {
            if (_shapes.Count == 1 && other._shapes.Count == 1)
                return GjkPhysics.Distance(_shapes[0], other._shapes[0]);
            DistanceResult best = default;
            bool isFound = false;
            for (int i = 0; i < _shapes.Count; i++)
            {
                for (int k = 0; k < other._shapes.Count; k++)
                {
                    PosedShape a = _shapes[i], b = other._shapes[k];
                    float most = isFound ? System.Math.Max(best.Distance, 0) : float.PositiveInfinity;
                    DistanceResult found = PairQueries.Distance(a, b, most);
                    if (found.IsOverlapping) found = PairQueries.Signed(a, b);
                    if (isFound && !(found.Distance < best.Distance)) continue;
                    best = found;
                    isFound = true;
                }
            }

            return new ColliderDistance3D(best);
        }

        /// <summary>Logs a problem once, not in every frame.</summary>
        public void Report(Object context)
        {
            string problem = Problem ?? _leftOut;
            if (problem == _reported) return;
            _reported = problem;
            if (problem != null) Debug.LogWarning(problem, context);
        }

        private static bool IsOn(Collider collider) => collider.enabled && collider.gameObject.activeInHierarchy;

        private void Collect(GameObject owner)
        {
            if (!owner.TryGetComponent(out Rigidbody body))
            {
                owner.GetComponents(_colliders);
                return;
            }

            owner.GetComponentsInChildren(_colliders);
            for (int i = _colliders.Count - 1; i >= 0; i--)
            {
                if (!BelongsTo(_colliders[i].transform, body)) _colliders.RemoveAt(i);
            }
        }

        /// <summary>Whether no other rigid body is between.</summary>
        private static bool BelongsTo(Transform child, Rigidbody body)
        {
            for (Transform t = child; t != null; t = t.parent)
            {
                if (t.TryGetComponent(out Rigidbody found)) return found == body;
            }

            return false;
        }

        private void Add(Component source, bool isSolid)
        {
            // What never has a shape, as a wheel, is left out beside others; it makes its text once.
            bool isHopeless = !ShapeReader.IsKnown(source);
            if (isHopeless && _leftOut != null)
            {
                Problem = _leftOut;
                return;
            }

            if (GjkShapes.TryFrom(source, out PosedShape posed, out string reason, isSolid)) _shapes.Add(posed);
            else Problem = reason;
            if (isHopeless) _leftOut = reason;
        }
    }
}
