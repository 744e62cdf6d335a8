using System;
using Gjk.Core;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>What a transform's matrix does beside turning and moving: scale, mirroring and skew, as the columns of
    /// a 3 x 3 matrix in double. Immutable.</summary>
    internal readonly struct Stretch : IEquatable<Stretch>
    {
        /// <summary>Relative to the largest entry. An entry off the diagonal that is smaller moves a point by less than
        /// float rounds it. Pinned by AdapterTests.ALittleNoiseIsNoSkew.</summary>
        private const double SkewTolerance = 5e-8;

        public static readonly Stretch None =
            new Stretch(new Double3(1, 0, 0), new Double3(0, 1, 0), new Double3(0, 0, 1));

        private readonly Double3 _x, _y, _z;

        private Stretch(in Double3 x, in Double3 y, in Double3 z)
        {
            _x = x;
            _y = y;
            _z = z;
        }

        /// <summary>What the engine calls lossyScale: the diagonal.</summary>
        public Double3 Scale => new Double3(_x.X, _y.Y, _z.Z);

        /// <summary>The absolute scale along an axis: 0 x, 1 y, 2 z.</summary>
        public double Along(int axis) => Math.Abs(axis == 0 ? _x.X : axis == 1 ? _y.Y : _z.Z);

        /// <summary>Whether axes stay axes.</summary>
        public bool IsDiagonal
        {
            get
            {
                double limit = Math.Max(Largest(_x), Math.Max(Largest(_y), Largest(_z))) * SkewTolerance;
                return Math.Abs(_x.Y) <= limit && Math.Abs(_x.Z) <= limit && Math.Abs(_y.X) <= limit
                    && Math.Abs(_y.Z) <= limit && Math.Abs(_z.X) <= limit && Math.Abs(_z.Y) <= limit;
            }
        }

        /// <summary>Whether this scales all axes alike, but for mirroring, to the last bit.</summary>
        private bool IsEven =>
            _x.Y == 0 && _x.Z == 0 && _y.X == 0 && _y.Z == 0 && _z.X == 0 && _z.Y == 0
            && Math.Abs(_x.X) == Math.Abs(_y.Y) && Math.Abs(_x.X) == Math.Abs(_z.Z);

        public Double3 Apply(in Double3 v) => _x * v.X + _y * v.Y + _z * v.Z;

        /// <summary>That of a child: inverse(seen) * this * turn * scale, where seen is the child's turn as this
        /// mirrors it.</summary>
        public Stretch Child(in Turn seen, in Turn turn, in Double3 scale)
        {
            // Of an even stretch a rotation and the mirrored one cancel; without them the result has no rounding.
            if (IsEven) return new Stretch(_x * scale.X, _y * scale.Y, _z * scale.Z);
            return new Stretch(
                seen.RotateBack(Apply(turn.X)) * scale.X, seen.RotateBack(Apply(turn.Y)) * scale.Y,
                seen.RotateBack(Apply(turn.Z)) * scale.Z);
        }

        public Numerics.Vector3 Apply(Numerics.Vector3 v) => (Numerics.Vector3)Apply((Double3)v);

        public bool Equals(Stretch other) => _x == other._x && _y == other._y && _z == other._z;

        public override bool Equals(object obj) => obj is Stretch other && Equals(other);

        public override int GetHashCode() =>
            (_x.GetHashCode() * 397 ^ _y.GetHashCode()) * 397 ^ _z.GetHashCode();

        private static double Largest(in Double3 v) =>
            Math.Max(Math.Abs(v.X), Math.Max(Math.Abs(v.Y), Math.Abs(v.Z)));
    }
}
