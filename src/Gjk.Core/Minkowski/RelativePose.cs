using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// Where B is, seen from A: B's centre and axes in A's frame, with A's centre as the origin. Composed once per query, in double, from
/// the differences: positions far from the world's origin cancel before anything is rounded, and shapes far from their own local origin
/// are measured from their centres.
/// </summary>
internal struct RelativePose
{
    /// <summary>
    /// When the centres lie further from the local origins than this many bounding radii, rotating them in double would cost more than the
    /// promised 1e-14 of the scale, so that is done in double-double. Pinned by OffsetMeshTests.
    /// </summary>
    private const double FarCenter = 4;

    /// <summary>B's axes in A's frame.</summary>
    public RotationD Rotation;

    /// <summary>A's axes in the world.</summary>
    public RotationD RotationA;

    /// <summary>From A's centre to B's, in A's frame.</summary>
    public Vector3D Translation;

    /// <summary>The shapes' centres in their own frames.</summary>
    public Vector3D CenterA, CenterB;

    /// <summary>The two bounding radii added: the size that rounding errors are measured by.</summary>
    public double Radius;

    /// <summary>Whether both poses are rotations and every number is finite.</summary>
    public bool IsValid;

    /// <summary>Composed where it is to be: a copy of its two hundred bytes would cost as much as the composition.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Compose(
        in RigidPose poseA, in RigidPose poseB, in Vector3D centerA, in Vector3D centerB, double radius, out RelativePose pose)
    {
        Quaternion a = poseA.Rotation, b = poseB.Rotation;
        double ax = a.X, ay = a.Y, az = a.Z, aw = a.W, bx = b.X, by = b.Y, bz = b.Z, bw = b.W;
        double normA = ax * ax + ay * ay + az * az + aw * aw, normB = bx * bx + by * by + bz * bz + bw * bw;
        double inverse = 1 / (normA * normB);
        RotationD.Set(out pose.RotationA, ax, ay, az, aw, 2 * normB * inverse);
        RotationD.Set(
            out pose.Rotation,
            aw * bx - ax * bw - ay * bz + az * by,
            aw * by - ay * bw - az * bx + ax * bz,
            aw * bz - az * bw - ax * by + ay * bx,
            aw * bw + ax * bx + ay * by + az * bz,
            2 * inverse);

        pose.CenterA = new Vector3D(centerA.X, centerA.Y, centerA.Z);
        pose.CenterB = new Vector3D(centerB.X, centerB.Y, centerB.Z);
        pose.Radius = radius;
        Vector3D between = (Vector3D)poseB.Position - poseA.Position;
        double offset = Math.Abs(centerA.X) + Math.Abs(centerA.Y) + Math.Abs(centerA.Z) + Math.Abs(centerB.X) + Math.Abs(centerB.Y) + Math.Abs(centerB.Z);
        if (!(offset > FarCenter * radius))
        {
            pose.Translation = pose.RotationA.InverseRotate(between);
            if (offset > 0) pose.Translation += pose.Rotation.Rotate(centerB) - centerA;
        }
        else
        {
            pose.Translation = pose.RotationA.InverseRotate(BetweenFarCenters(poseA, poseB, centerA, centerB));
        }

        pose.IsValid = RigidPose.IsUnit(normA) && RigidPose.IsUnit(normB) && radius + (pose.Translation.X + pose.Translation.Y + pose.Translation.Z) is var sum && sum - sum == 0;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Vector3D BetweenFarCenters(in RigidPose poseA, in RigidPose poseB, in Vector3D centerA, in Vector3D centerB)
    {
        VectorDD a = Place(poseA, centerA), b = Place(poseB, centerB);
        return (Vector3D)(b - a);
    }

    /// <summary>position + v + 2 u × (u × v + w v) / |q|², the quaternion's rotation without a matrix, in double-double.</summary>
    private static VectorDD Place(in RigidPose pose, in Vector3D v)
    {
        Quaternion q = pose.Rotation;
        VectorDD u = new Vector3D(q.X, q.Y, q.Z), vector = v;
        DoubleDouble w = (double)q.W;
        DoubleDouble norm = VectorDD.Dot(u, u) + w * w;
        VectorDD turned = VectorDD.Cross(u, VectorDD.Cross(u, vector) + vector * w) * (2.0 / norm);
        return (VectorDD)(Vector3D)pose.Position + vector + turned;
    }
}
