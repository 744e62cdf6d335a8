using System;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>World = parent * TRS(local), in float. What is assumed about the engine stands in the README beside the
    /// project.</summary>
    public class Transform : Component
    {
        internal readonly List<Transform> Children = new List<Transform>();
        private Transform _parent;

        public Vector3 localPosition { get; set; }

        public Quaternion localRotation { get; set; } = Quaternion.identity;

        public Vector3 localScale { get; set; } = Vector3.one;

        public Transform parent => _parent;

        public bool IsChildOf(Transform parent)
        {
            Transform t = this;
            while (!(t is null) && !ReferenceEquals(t, parent)) t = t._parent;
            return !(t is null);
        }

        public Vector3 position
        {
            get => _parent is null ? localPosition : _parent.localToWorldMatrix.MultiplyPoint3x4(localPosition);
            set => localPosition = _parent is null ? value : Solve(_parent.localToWorldMatrix, value);
        }

        public Quaternion rotation
        {
            get
            {
                Quaternion q = localRotation;
                for (Transform t = _parent; !(t is null); t = t._parent)
                    q = t.localRotation * Mirrored(q, t.localScale);
                return q;
            }
            set
            {
                if (_parent is null) localRotation = value;
                else throw new NotSupportedException("The stub sets world rotations of roots only.");
            }
        }

        public Vector3 lossyScale
        {
            get
            {
                Matrix4x4 inner = Matrix4x4.Rotate(Quaternion.Inverse(rotation)) * localToWorldMatrix;
                return new Vector3(inner.m00, inner.m11, inner.m22);
            }
        }

        public Matrix4x4 localToWorldMatrix
        {
            get
            {
                Matrix4x4 own = Matrix4x4.TRS(localPosition, localRotation, localScale);
                return _parent is null ? own : _parent.localToWorldMatrix * own;
            }
        }

        public void SetParent(Transform parent, bool worldPositionStays)
        {
            if (worldPositionStays) throw new NotSupportedException("The stub keeps local values only.");
            _parent?.Children.Remove(this);
            _parent = parent;
            parent?.Children.Add(this);
        }

        public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
        {
            this.position = position;
            this.rotation = rotation;
        }

        public Vector3 TransformPoint(Vector3 position) => localToWorldMatrix.MultiplyPoint3x4(position);

        /// <summary>The point that the matrix maps to another one, by Cramer's rule.</summary>
        private static Vector3 Solve(in Matrix4x4 m, Vector3 p)
        {
            var x = new Vector3(m.m00, m.m10, m.m20);
            var y = new Vector3(m.m01, m.m11, m.m21);
            var z = new Vector3(m.m02, m.m12, m.m22);
            Vector3 v = p - new Vector3(m.m03, m.m13, m.m23);
            float whole = Volume(x, y, z);
            return new Vector3(Volume(v, y, z), Volume(x, v, z), Volume(x, y, v)) / whole;
        }

        private static float Volume(Vector3 a, Vector3 b, Vector3 c) =>
            a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);

        /// <summary>S R S, where S holds the signs of the scale: the rotation as the mirror shows it.</summary>
        private static Quaternion Mirrored(Quaternion q, Vector3 scale)
        {
            float x = scale.x < 0 ? -1 : 1, y = scale.y < 0 ? -1 : 1, z = scale.z < 0 ? -1 : 1;
            return new Quaternion(q.x * y * z, q.y * x * z, q.z * x * y, q.w);
        }
    }
}
