using System.Collections.Generic;
using System.Runtime.CompilerServices;
using Gjk.Core;
using UnityEngine;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>Colliders that are kept to be asked together, in a scene of the library.</summary>
    internal sealed class ColliderScene
    {
        /// <summary>Ratio to the radius by which what may be near is collected from a little further away, so that
        /// rounding loses nothing; the distance itself decides. Four times as much costs a few queries more, and no
        /// answer.</summary>
        private const float Reach = 1 + 1e-5f;

        private readonly CollisionScene _scene = new CollisionScene();
        private readonly List<Watched> _all = new List<Watched>();
        private readonly Dictionary<Component, int> _places = new Dictionary<Component, int>(ByReference.Comparer);
        private readonly Dictionary<int, Watched> _byId = new Dictionary<int, Watched>();
        private readonly List<int> _found = new List<int>();
        private readonly System.Predicate<int> _sees;
        private SceneFilter _filter;

        public ColliderScene() => _sees = id => _filter.Sees(_byId[id]);

        public int Count => _all.Count;

        /// <summary>Whether closed meshes are taken with what they enclose.</summary>
        public bool IsSolid { get; set; }

        /// <summary>False when it is there already.</summary>
        public bool Add(Component source)
        {
            if (_places.ContainsKey(source)) return false;
            _places.Add(source, _all.Count);
            _all.Add(new Watched(source));
            return true;
        }

        /// <summary>False when it is not there.</summary>
        public bool Remove(Component source)
        {
            if (!_places.TryGetValue(source, out int index)) return false;
            RemoveAt(index);
            return true;
        }

        /// <summary>Reads all again, and drops what is destroyed.</summary>
        public void Refresh()
        {
            for (int i = 0; i < _all.Count;)
            {
                Watched watched = _all[i];
                int before = watched.Id;
                watched.Update(_scene, IsSolid);
                if (watched.Id != before)
                {
                    _byId.Remove(before);
                    if (watched.Id >= 0) _byId.Add(watched.Id, watched);
                }

                if (watched.IsGone) RemoveAt(i);
                else i++;
            }
        }

        /// <summary>Appends what is within a radius of a shape, with its distance.</summary>
        public void CollectWithin(in PosedShape shape, float radius, in SceneFilter filter, List<ProximityHit> hits)
        {
            bool isAll = !shape.IsConvex || radius > float.MaxValue / 4;
            if (!isAll)
            {
                ConvexShape around = radius > 0 ? shape.Shape.Rounded(radius * Reach) : shape.Shape;
                _scene.FindObjectsOverlapping(around, shape.Pose, _found, Sees(filter));
                for (int i = 0; i < _found.Count; i++) Note(_byId[_found[i]], shape, radius, hits);
            }

            for (int i = 0; isAll && i < _all.Count; i++)
            {
                if (filter.Sees(_all[i])) Note(_all[i], shape, radius, hits);
            }
        }

        /// <summary>What a moving shape meets first.</summary>
        public bool TryCast(
            in PosedShape shape, Numerics.Vector3 way, float maxFraction, in SceneFilter filter, out CastResult result,
            out Component met)
        {
            result = default;
            met = null;
            if (shape.IsConvex)
            {
                bool isHit = _scene.TryFindCastHit(
                    shape.Shape, shape.Pose, way, out CastHit hit, maxFraction, Sees(filter));
                result = hit.Result;
                if (isHit) met = _byId[hit.Id].Source;
                return isHit;
            }

            for (int i = 0; i < _all.Count; i++)
            {
                if (!filter.Sees(_all[i])) continue;
                float most = met is null ? maxFraction : result.Fraction;
                CastResult found = PairQueries.Cast(shape, way, most, _all[i].Posed);
                bool mayHit = found.IsHit || found.Status == CastStatus.IterationLimit;
                if (!mayHit || (!(met is null) && found.Fraction >= result.Fraction)) continue;
                result = found;
                met = _all[i].Source;
            }

            return !(met is null);
        }

        /// <summary>What a ray meets first.</summary>
        public bool TryRayCast(
            in RayQuery ray, in SceneFilter filter, out RayCastResult result, out int triangle, out Component met)
        {
            bool isHit = _scene.TryFindRayHit(ray, out RayHit hit, Sees(filter));
            result = hit.Result;
            triangle = hit.Part;
            met = isHit ? _byId[hit.Id].Source : null;
            return isHit;
        }

        private QueryFilter Sees(in SceneFilter filter)
        {
            _filter = filter;
            return new QueryFilter(mask: (uint)filter.Layers, sees: _sees);
        }

        private static void Note(Watched watched, in PosedShape shape, float radius, List<ProximityHit> hits)
        {
            DistanceResult found = PairQueries.Distance(shape, watched.Posed, radius);
            bool isNear = found.IsOverlapping || (found.Status == GjkStatus.Separated && found.Distance <= radius);
            if (isNear) hits.Add(new ProximityHit(watched.Source, new ColliderDistance3D(found)));
        }

        /// <summary>The last takes its place.</summary>
        private void RemoveAt(int index)
        {
            Watched gone = _all[index], last = _all[_all.Count - 1];
            _byId.Remove(gone.Id);
            gone.Leave(_scene);
            _all[index] = last;
            _places[last.Source] = index;
            _all.RemoveAt(_all.Count - 1);
            _places.Remove(gone.Source);
        }

        /// <summary>A destroyed object equals null, and must be found nevertheless.</summary>
        internal sealed class ByReference : IEqualityComparer<Component>
        {
            public static readonly ByReference Comparer = new ByReference();

            public bool Equals(Component x, Component y) => ReferenceEquals(x, y);

            public int GetHashCode(Component obj) => RuntimeHelpers.GetHashCode(obj);
        }
    }

    /// <summary>What a question to a <see cref="ColliderScene"/> sees.</summary>
    internal readonly struct SceneFilter
    {
        private readonly Transform _own;
        private readonly bool _withTriggers;

        /// <param name="layers">One bit each.</param>
        /// <param name="own">An object that is not seen, nor are its children; null for none.</param>
        /// <param name="withTriggers">Whether triggers are seen.</param>
        public SceneFilter(int layers, Transform own, bool withTriggers)
        {
            Layers = layers;
            _own = own;
            _withTriggers = withTriggers;
        }

        public int Layers { get; }

        public bool Sees(Watched watched) =>
            watched.IsPresent && (Layers >> watched.Layer & 1) != 0 && (_withTriggers || !watched.IsTrigger)
            && (_own is null || !watched.Source.transform.IsChildOf(_own));
    }
}
