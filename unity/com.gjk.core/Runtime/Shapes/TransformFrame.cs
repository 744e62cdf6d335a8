using Gjk.Core;
using UnityEngine;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>A transform's matrix as a rigid pose times a stretch, in double.</summary>
    /// <remarks>It is computed from the local values of the transform and its parents, not from localToWorldMatrix:
    /// that way a stretch keeps its bits while the whole hierarchy turns and moves, so that a hull made for it can be
    /// kept, and nothing depends on how the engine rounds. The product is the same matrix. The rotation is the one that
    /// the engine's manual implies for <c>Transform.rotation</c>: without skew, rotation times lossyScale is the
    /// matrix, mirrored parents included.</remarks>
    internal struct TransformFrame
    {
        /// <summary>The rotation of the rigid pose.</summary>
        public Turn Turn;

        /// <summary>The position of the rigid pose.</summary>
        public Double3 Position;

        /// <summary>The rest of the matrix, applied before the pose.</summary>
        public Stretch Stretch;

        /// <summary>The signs of all scales so far, multiplied: 1 or -1 each.</summary>
        private Double3 _signs;

        /// <summary>The frame of a transform in the world.</summary>
        public static void Of(Transform transform, out TransformFrame frame)
        {
            Transform parent = transform.parent;
            if (parent == null)
            {
                frame.Turn = Turn.None;
                frame.Position = default;
                frame.Stretch = Stretch.None;
                frame._signs = new Double3(1, 1, 1);
            }
            else
            {
                Of(parent, out frame);
            }

            frame.Descend(transform.localPosition, transform.localRotation, transform.localScale);
        }

        /// <summary>The world pose of something placed in the rigid frame; false where it is not finite.</summary>
        public readonly bool TryPose(in LocalShape local, out RigidPose pose)
        {
            var position = (Numerics.Vector3)(Position + Turn.Rotate(local.Offset));
            Numerics.Quaternion rotation = (local.IsUpright ? local.Turn : Turn.Times(local.Turn)).Rounded;
            float check = position.X - position.X + (position.Y - position.Y) + (position.Z - position.Z)
                + (rotation.X - rotation.X);
            bool isFinite = check == 0;
            pose = isFinite ? new RigidPose(rotation, position) : default;
            return isFinite;
        }

        private void Descend(Vector3 position, Quaternion rotation, Vector3 scale)
        {
            var turn = new Turn(rotation);
            Turn seen = turn.Mirrored(_signs);
            var factors = new Double3(scale.x, scale.y, scale.z);
            Position += Turn.Rotate(Stretch.Apply(new Double3(position.x, position.y, position.z)));
            Stretch = Stretch.Child(seen, turn, factors);
            Turn = Turn.Times(seen);
            _signs = Double3.Multiply(_signs, new Double3(Sign(scale.x), Sign(scale.y), Sign(scale.z)));
        }

        private static double Sign(float scale) => scale < 0 ? -1 : 1;
    }
}
