using System;
using System.Collections.Generic;
using Gjk.Core;
using UnityEngine;

namespace Gjk.Unity.Tests
{
    /// <summary>How far sets of points reach in a direction of the world: two convex bodies that always agree are
    /// equal.</summary>
    internal static class Reach
    {
        public static double Of(in PosedShape body, Vector3 direction)
        {
            var d = new Double3(direction.x, direction.y, direction.z);
            System.Numerics.Quaternion q = body.Pose.Rotation;
            var turn = new Turn(q.X, q.Y, q.Z, q.W);
            Double3 inward = turn.RotateBack(d);
            body.Shape.Support(inward, out Double3 point);
            return Double3.Dot(inward, point + body.Shape.Center) + body.Shape.Margin * d.Length
                + Double3.Dot(d, body.Pose.Position);
        }

        public static double Of(List<Double3> points, Vector3 direction)
        {
            double most = double.NegativeInfinity;
            var d = new Double3(direction.x, direction.y, direction.z);
            foreach (Double3 point in points) most = Math.Max(most, Double3.Dot(d, point));
            return most;
        }

        /// <summary>The largest coordinate: what a float error of a thousand-thousandth is measured by.</summary>
        public static double Size(List<Double3> points)
        {
            double most = 0;
            foreach (Double3 p in points)
                most = Math.Max(most, Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))));
            return most;
        }
    }
}
