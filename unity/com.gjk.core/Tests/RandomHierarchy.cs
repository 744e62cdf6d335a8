using System;
using UnityEngine;

namespace Gjk.Unity.Tests
{
    /// <summary>Three transforms below each other, with every kind of scale.</summary>
    internal sealed class RandomHierarchy : IDisposable
    {
        private readonly System.Random _random;
        private readonly GameObject _root;

        public RandomHierarchy(int seed, bool isSkewAllowed = true)
        {
            _random = new System.Random(seed);
            _root = new GameObject("root of seed " + seed);
            GameObject middle = Child(_root, "middle"), leaf = Child(middle, "leaf of seed " + seed);
            foreach (GameObject level in new[] { _root, middle, leaf })
            {
                Transform t = level.transform;
                t.localPosition = Vector(-3, 3);
                t.localRotation = Rotation();
                t.localScale = Scale(isSkewAllowed || level == leaf);
            }

            Leaf = leaf;
        }

        /// <summary>The innermost object, where the colliders belong.</summary>
        public GameObject Leaf { get; }

        /// <summary>Whether one of the scales is 0.</summary>
        public bool IsFlat { get; private set; }

        public float Float(double low, double high) => (float)(low + (high - low) * _random.NextDouble());

        public int Below(int count) => _random.Next(count);

        public Vector3 Vector(double low, double high) =>
            new Vector3(Float(low, high), Float(low, high), Float(low, high));

        public Vector3 Direction()
        {
            while (true)
            {
                Vector3 v = Vector(-1, 1);
                float length = v.magnitude;
                if (length > 0.1f && length <= 1) return v / length;
            }
        }

        public void Dispose() => UnityEngine.Object.DestroyImmediate(_root);

        private static GameObject Child(GameObject parent, string name)
        {
            var child = new GameObject(name);
            child.transform.SetParent(parent.transform, false);
            return child;
        }

        private Quaternion Rotation()
        {
            switch (Below(8))
            {
                case 0: return Quaternion.identity;
                case 1: return Quaternion.AngleAxis(90 * (1 + Below(3)), Axis());
                default: return Quaternion.AngleAxis(Float(0, 360), Direction());
            }
        }

        private Vector3 Axis()
        {
            int axis = Below(3);
            return axis == 0 ? Vector3.right : axis == 1 ? Vector3.up : Vector3.forward;
        }

        private Vector3 Scale(bool isUnevenAllowed)
        {
            Vector3 scale = Vector3.one * Float(0.25, 4);
            if (isUnevenAllowed && Below(3) > 0) scale = Vector(0.25, 4);
            if (Below(3) == 0) scale.x = -scale.x;
            if (Below(5) == 0) scale.y = -scale.y;
            if (Below(5) == 0) scale.z = -scale.z;
            if (isUnevenAllowed && Below(12) == 0) scale.y = 0;
            if (isUnevenAllowed && Below(24) == 0) scale.z = 0;
            IsFlat |= scale.y == 0 || scale.z == 0;
            return scale;
        }
    }
}
