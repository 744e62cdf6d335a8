#if GJK_MATHEMATICS
using Unity.Mathematics;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>
    /// The types of com.unity.mathematics, from 1.0. Only compiled where the project has that package.
    /// </summary>
    public static class GjkMathematics
    {
        /// <summary>The same vector.</summary>
        public static Numerics.Vector3 ToNumerics(this float3 v) => new Numerics.Vector3(v.x, v.y, v.z);

        /// <summary>The same rotation.</summary>
        public static Numerics.Quaternion ToNumerics(this quaternion q) =>
            new Numerics.Quaternion(q.value.x, q.value.y, q.value.z, q.value.w);

        /// <summary>The same vector.</summary>
        public static float3 ToMathematics(this Numerics.Vector3 v) => new float3(v.X, v.Y, v.Z);

        /// <summary>The same rotation.</summary>
        public static quaternion ToMathematics(this Numerics.Quaternion q) => new quaternion(q.X, q.Y, q.Z, q.W);
    }
}
#endif
