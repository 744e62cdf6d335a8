using System;
using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity.Tests
{
    /// <summary>A transform's whole matrix in double, from the local values: what the adapters are held
    /// against.</summary>
    internal readonly struct Affine
    {
        private readonly Double3 _x, _y, _z, _position;

        private Affine(Double3 x, Double3 y, Double3 z, Double3 position)
        {
            _x = x;
            _y = y;
            _z = z;
            _position = position;
        }

        public static Affine Of(Transform transform)
        {
            Affine own = Local(transform);
            if (transform.parent == null) return own;
            Affine parent = Of(transform.parent);
            return new Affine(
                parent.Vector(own._x), parent.Vector(own._y), parent.Vector(own._z), parent.Point(own._position));
        }

        public Double3 Vector(Double3 v) => _x * v.X + _y * v.Y + _z * v.Z;

        public Double3 Point(Double3 v) => Vector(v) + _position;

        public Double3 Point(Vector3 v) => Point(new Double3(v.x, v.y, v.z));

        /// <summary>The largest difference to the engine's matrix, entry by entry.</summary>
        public double Difference(Matrix4x4 m)
        {
            double most = 0;
            for (int column = 0; column < 4; column++)
            {
                Double3 own = column == 0 ? _x : column == 1 ? _y : column == 2 ? _z : _position;
                most = Math.Max(most, Math.Abs(own.X - m[0, column]));
                most = Math.Max(most, Math.Abs(own.Y - m[1, column]));
                most = Math.Max(most, Math.Abs(own.Z - m[2, column]));
            }

            return most;
        }

        /// <summary>The cosine of the two axes that are furthest from a right angle; 0 where one has no
        /// length.</summary>
        public double Skew => Math.Max(Cosine(_x, _y), Math.Max(Cosine(_y, _z), Cosine(_x, _z)));

        /// <summary>The diagonal of inverse(rotation) * matrix, with the rotation that the engine's manual implies:
        /// each turn as the mirrors above it show it.</summary>
        public static Double3 LossyScale(Transform transform, out Affine rotation)
        {
            rotation = Rotation(transform);
            Affine whole = Of(transform);
            return new Double3(
                Double3.Dot(rotation._x, whole._x), Double3.Dot(rotation._y, whole._y),
                Double3.Dot(rotation._z, whole._z));
        }

        private static Affine Rotation(Transform transform)
        {
            // S1 S2 ... R ... S2 S1 for the signs S of the scales above.
            Affine turn = Turn(transform.localRotation);
            Transform parent = transform.parent;
            if (parent == null) return turn;
            double x = 1, y = 1, z = 1;
            for (Transform t = parent; t != null; t = t.parent)
            {
                x *= t.localScale.x < 0 ? -1 : 1;
                y *= t.localScale.y < 0 ? -1 : 1;
                z *= t.localScale.z < 0 ? -1 : 1;
            }

            var signs = new Double3(x, y, z);
            Affine outer = Rotation(parent);
            return new Affine(
                outer.Vector(Double3.Multiply(signs, turn._x) * x),
                outer.Vector(Double3.Multiply(signs, turn._y) * y),
                outer.Vector(Double3.Multiply(signs, turn._z) * z), default);
        }

        private static Affine Local(Transform t)
        {
            Affine turn = Turn(t.localRotation);
            Vector3 s = t.localScale, p = t.localPosition;
            return new Affine(turn._x * s.x, turn._y * s.y, turn._z * s.z, new Double3(p.x, p.y, p.z));
        }

        private static Affine Turn(Quaternion q)
        {
            double n = 2 / ((double)q.x * q.x + (double)q.y * q.y + (double)q.z * q.z + (double)q.w * q.w);
            double x = q.x, y = q.y, z = q.z, w = q.w;
            return new Affine(
                new Double3(1 - n * (y * y + z * z), n * (x * y + w * z), n * (x * z - w * y)),
                new Double3(n * (x * y - w * z), 1 - n * (x * x + z * z), n * (y * z + w * x)),
                new Double3(n * (x * z + w * y), n * (y * z - w * x), 1 - n * (x * x + y * y)), default);
        }

        private static double Cosine(Double3 a, Double3 b)
        {
            double lengths = a.Length * b.Length;
            return lengths > 0 ? Math.Abs(Double3.Dot(a, b)) / lengths : 0;
        }
    }
}
