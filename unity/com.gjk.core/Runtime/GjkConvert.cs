using Gjk.Core;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>Vectors and rotations from the engine's types to those of the library, and back. The numbers stay as
    /// they are: left-handed coordinates do not matter to distances.</summary>
    public static class GjkConvert
    {
        /// <summary>The same vector.</summary>
        public static Numerics.Vector3 ToNumerics(this UnityEngine.Vector3 v) => new Numerics.Vector3(v.x, v.y, v.z);

        /// <summary>The same rotation.</summary>
        public static Numerics.Quaternion ToNumerics(this UnityEngine.Quaternion q) =>
            new Numerics.Quaternion(q.x, q.y, q.z, q.w);

        /// <summary>The same vector.</summary>
        public static UnityEngine.Vector3 ToUnity(this Numerics.Vector3 v) => new UnityEngine.Vector3(v.X, v.Y, v.Z);

        /// <summary>The same rotation.</summary>
        public static UnityEngine.Quaternion ToUnity(this Numerics.Quaternion q) =>
            new UnityEngine.Quaternion(q.X, q.Y, q.Z, q.W);

        /// <summary>The same vector, rounded to float.</summary>
        public static UnityEngine.Vector3 ToUnity(this Double3 v) =>
            new UnityEngine.Vector3((float)v.X, (float)v.Y, (float)v.Z);
    }
}
