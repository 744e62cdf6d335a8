#if GJK_MATHEMATICS
using Gjk.Core;
using Unity.Mathematics;
using UnityEngine;
using Numerics = System.Numerics;

namespace Gjk.Unity
{
    /// <summary>The types of com.unity.mathematics, from 1.0. Only compiled where the project has that
    /// package.</summary>
    public static class GjkMathematics
    {
        /// <summary>The same vector.</summary>
        public static Numerics.Vector3 ToNumerics(this float3 v) => new Numerics.Vector3(v.x, v.y, v.z);

        /// <summary>The same rotation.</summary>
        public static Numerics.Quaternion ToNumerics(this quaternion q) =>
            new Numerics.Quaternion(q.value.x, q.value.y, q.value.z, q.value.w);

        /// <summary>The same pose.</summary>
        public static RigidPose ToPose(this RigidTransform t) => new RigidPose(t.rot.ToNumerics(), t.pos.ToNumerics());

        /// <summary>The same pose.</summary>
        public static RigidTransform ToMathematics(this in RigidPose pose) =>
            new RigidTransform(pose.Rotation.ToMathematics(), pose.Position.ToMathematics());

        /// <summary>How far two shapes are apart, or how deep they overlap, wherever they are put.</summary>
        /// <remarks>May be called on any thread: shapes are immutable.</remarks>
        public static ColliderDistance3D Distance(
            in PosedShape a, RigidTransform transformA, in PosedShape b, RigidTransform transformB) =>
            GjkPhysics.Distance(a.At(transformA.ToPose()), b.At(transformB.ToPose()));

        /// <summary>Whether two shapes share a point, touching included, wherever they are put.</summary>
        public static bool Overlaps(
            in PosedShape a, RigidTransform transformA, in PosedShape b, RigidTransform transformB) =>
            GjkPhysics.Overlaps(a.At(transformA.ToPose()), b.At(transformB.ToPose()));

        /// <summary>The point of a collider closest to a point; the point itself where it is inside.</summary>
        public static float3 ClosestPoint(float3 point, Collider collider) =>
            GjkPhysics.ClosestPoint(point.ToNumerics().ToUnity(), collider).ToNumerics().ToMathematics();

        /// <summary>As the first, where its transform is taken to be.</summary>
        public static float3 ClosestPoint(float3 point, Collider collider, RigidTransform transform) =>
            GjkPhysics.ClosestPoint(
                point.ToNumerics().ToUnity(), collider, transform.pos.ToNumerics().ToUnity(),
                transform.rot.ToNumerics().ToUnity()).ToNumerics().ToMathematics();

        /// <summary>When a collider that moves along a straight line first touches another one.</summary>
        public static bool Cast(
            Collider colliderA, float3 direction, float maxDistance, Collider colliderB, out ColliderCastHit hit) =>
            GjkPhysics.Cast(colliderA, direction.ToNumerics().ToUnity(), maxDistance, colliderB, out hit);

        /// <summary>The same vector.</summary>
        public static float3 ToMathematics(this Numerics.Vector3 v) => new float3(v.X, v.Y, v.Z);

        /// <summary>The same rotation.</summary>
        public static quaternion ToMathematics(this Numerics.Quaternion q) => new quaternion(q.X, q.Y, q.Z, q.W);
    }
}
#endif
