using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity
{
    /// <summary>One collider, half-space or mesh filter of a <see cref="ColliderScene"/>.</summary>
    internal sealed class Watched
    {
        private const int Absent = -1;

        private readonly Collider _collider;
        private readonly GameObject _owner;
        private readonly bool _isStatic;
        private string _problem;

        public Watched(Component source)
        {
            Source = source;
            _collider = source as Collider;
            _owner = source.gameObject;
            _isStatic = _owner.isStatic;
        }

        public Component Source { get; }

        /// <summary>Its id in the library's scene; a negative number while it is not in it.</summary>
        public int Id { get; private set; } = Absent;

        /// <summary>Whether it has a shape now and is switched on.</summary>
        public bool IsPresent => Id >= 0;

        /// <summary>Where it is, and what.</summary>
        public PosedShape Posed { get; private set; }

        public int Layer { get; private set; }

        public bool IsTrigger { get; private set; }

        /// <summary>Whether the engine has destroyed it.</summary>
        public bool IsGone => Source == null;

        private bool IsSwitchedOff => (_collider is Collider && !_collider.enabled)
            || (Source is GjkHalfSpace halfSpace && !halfSpace.enabled);

        /// <summary>Brings the scene up to date. What does not move is read once.</summary>
        public void Update(CollisionScene scene, bool isSolid)
        {
            if (IsGone || !_owner.activeInHierarchy || IsSwitchedOff)
            {
                _problem = null;
                Leave(scene);
                return;
            }

            // What was refused is not tried again before it was switched off and on: a refusal makes a text.
            if (_problem != null || (IsPresent && _isStatic)) return;
            if (!GjkShapes.TryFrom(Source, out PosedShape posed, out string reason, isSolid))
            {
                Debug.LogWarning(reason, Source);
                _problem = reason;
                Leave(scene);
                return;
            }

            int layer = _owner.layer;
            bool isSame = Id >= 0 && posed.HasShapeOf(Posed);
            if (Id >= 0 && !isSame) Leave(scene);
            if (isSame) scene.Move(Id, posed.Pose);

            // Static in the scene's sense: these are never tested against each other.
            var settings = new ObjectSettings(isStatic: true, groups: 1u << layer);
            if (!isSame) Id = scene.Add(posed.Any, posed.Pose, settings);
            else if (isSame && layer != Layer) scene.SetSettings(Id, settings);
            IsTrigger = _collider is Collider && _collider.isTrigger;
            Posed = posed;
            Layer = layer;
        }

        public void Leave(CollisionScene scene)
        {
            if (Id >= 0) scene.Remove(Id);
            Id = Absent;
        }
    }
}
