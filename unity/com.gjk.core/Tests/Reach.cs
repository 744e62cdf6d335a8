using System;
using System.Collections.Generic;
using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity.Tests
{
    /// <summary>
    /// How far sets of points reach in a direction of the world: two convex bodies that always agree are equal.
    /// </summary>
    internal static class Reach
    {
        public static double Of(in PosedShape body, Vector3 direction)
        {
            var d = new Vector3D(direction.x, direction.y, direction.z);
            System.Numerics.Quaternion q = body.Pose.Rotation;
            var turn = new Turn(q.X, q.Y, q.Z, q.W);
            Vector3D inward = turn.RotateBack(d);
            body.Shape.Support(inward, out Vector3D point);
            return Vector3D.Dot(inward, point + body.Shape.Center) + body.Shape.Margin * d.Length
                + Vector3D.Dot(d, body.Pose.Position);
        }

        public static double Of(List<Vector3D> points, Vector3 direction)
        {
            double most = double.NegativeInfinity;
            var d = new Vector3D(direction.x, direction.y, direction.z);
            foreach (Vector3D point in points) most = Math.Max(most, Vector3D.Dot(d, point));
            return most;
        }

        /// <summary>The largest coordinate: what a float error of a thousand-thousandth is measured by.</summary>
        public static double Size(List<Vector3D> points)
        {
            double most = 0;
            foreach (Vector3D p in points)
                most = Math.Max(most, Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))));
            return most;
        }
    }
}
