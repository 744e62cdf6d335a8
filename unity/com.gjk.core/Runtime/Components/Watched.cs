using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>One object of a sensor's scene.</summary>
    internal sealed class Watched
    {
        private const int Absent = -1;

        private readonly Component _source;
        private readonly Collider _collider;
        private readonly GameObject _owner;
        private readonly bool _isStatic;
        private ConvexShape _shape;
        private int _layer;

        public Watched(Component source)
        {
            _source = source;
            _collider = source as Collider;
            _owner = source.gameObject;
            _isStatic = _owner.isStatic;
        }

        public Component Source => _source;

        /// <summary>Its id in the scene, or a negative number.</summary>
        public int Id { get; private set; } = Absent;

        /// <summary>Whether it was within the radius in the last frame.</summary>
        public bool WasNear { get; set; }

        /// <summary>Whether it is within the radius in this one.</summary>
        public bool IsNear { get; set; }

        /// <summary>Null, or why it has no shape.</summary>
        public string Problem { get; private set; }

        /// <summary>Whether the engine has destroyed it.</summary>
        public bool IsGone => _source == null;

        /// <summary>Brings the scene up to date. What does not move is read once.</summary>
        public void Update(CollisionScene scene)
        {
            if (IsGone || !_owner.activeInHierarchy || (_collider is Collider && !_collider.enabled))
            {
                Problem = null;
                Leave(scene);
                return;
            }

            // What was refused is not tried again before it was switched off and on: a refusal makes a text.
            if (Problem != null || (Id >= 0 && _isStatic)) return;
            if (!GjkShapes.TryFrom(_source, out PosedShape posed, out string reason))
            {
                Debug.LogWarning(reason, _source);
                Problem = reason;
                Leave(scene);
                return;
            }

            if (Id >= 0 && posed.Shape != _shape) Leave(scene);
            if (Id >= 0) scene.Move(Id, posed.Pose);
            int layer = _owner.layer;
            if (Id >= 0 && layer == _layer) return;

            // Static in the scene's sense: nothing is tested against these but the sensor, which is not static.
            var settings = new ObjectSettings(isStatic: true, groups: 1u << layer);
            if (Id >= 0) scene.SetSettings(Id, settings);
            else Id = scene.Add(posed.Shape, posed.Pose, settings);
            _layer = layer;
            _shape = posed.Shape;
        }

        public void Leave(CollisionScene scene)
        {
            if (Id >= 0) scene.Remove(Id);
            Id = Absent;
        }
    }
}
