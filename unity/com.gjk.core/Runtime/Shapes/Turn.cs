using Gjk.Core;
using UnityEngine;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>A rotation in double: a quaternion, and the three columns of its matrix.</summary>
    internal readonly struct Turn
    {
        public static readonly Turn None = new Turn(0, 0, 0, 1);

        /// <summary>The columns of the matrix: where the axes go.</summary>
        public readonly Double3 X, Y, Z;

        private readonly double _x, _y, _z, _w;

        /// <summary>Makes a rotation of a quaternion of any length but 0.</summary>
        /// <remarks>The diagonal is a difference of squares instead of 1 - 2 (...), so that quarter turns give exact
        /// zeros.</remarks>
        public Turn(double x, double y, double z, double w)
        {
            _x = x;
            _y = y;
            _z = z;
            _w = w;
            double xx = x * x, yy = y * y, zz = z * z, ww = w * w, inverse = 1 / (xx + yy + zz + ww);
            X = new Double3(ww + xx - yy - zz, 2 * (x * y + w * z), 2 * (x * z - w * y)) * inverse;
            Y = new Double3(2 * (x * y - w * z), ww + yy - xx - zz, 2 * (y * z + w * x)) * inverse;
            Z = new Double3(2 * (x * z + w * y), 2 * (y * z - w * x), ww + zz - xx - yy) * inverse;
        }

        public Turn(Quaternion q)
            : this(q.x, q.y, q.z, q.w)
        {
        }

        /// <summary>The rotation of unit length, rounded to float.</summary>
        public Numerics.Quaternion Rounded
        {
            get
            {
                double s = 1 / System.Math.Sqrt(_x * _x + _y * _y + _z * _z + _w * _w);
                return new Numerics.Quaternion((float)(_x * s), (float)(_y * s), (float)(_z * s), (float)(_w * s));
            }
        }

        /// <summary>First b, then this.</summary>
        public Turn Times(in Turn b) =>
            new Turn(
                _w * b._x + _x * b._w + _y * b._z - _z * b._y,
                _w * b._y + _y * b._w + _z * b._x - _x * b._z,
                _w * b._z + _z * b._w + _x * b._y - _y * b._x,
                _w * b._w - _x * b._x - _y * b._y - _z * b._z);

        /// <summary>S R S for a diagonal S of signs: the same turn, seen in mirrors.</summary>
        public Turn Mirrored(in Double3 signs) =>
            new Turn(signs.Y * signs.Z * _x, signs.X * signs.Z * _y, signs.X * signs.Y * _z, _w);

        public Double3 Rotate(in Double3 v) => X * v.X + Y * v.Y + Z * v.Z;

        public Double3 RotateBack(in Double3 v) =>
            new Double3(Double3.Dot(X, v), Double3.Dot(Y, v), Double3.Dot(Z, v));
    }
}
