using Gjk.Demo.View;

namespace Gjk.Web;

/// <summary>The surface of A - B for drawing, margins included. With few corners it is the hull of all differences of
/// corners, otherwise the hull of support points in many directions.</summary>
internal static class Difference
{
    /// <summary>The most differences of corners of which all are hulled; fewer while a body turns, where each frame
    /// needs a new surface.</summary>
    private const int MostCorners = 4096, MostCornersCoarse = 256;

    /// <summary>Directions about an axis; from pole to pole there are half as many.</summary>
    private const int Meridians = 48, CoarseMeridians = 16;

    /// <summary>The surface in A's axes, as if both positions were the same.</summary>
    public static ShapeMesh Of(
        in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, bool isCoarse)
    {
        var bInA = new Turn(poseA.Rotation, poseB.Rotation);
        bool isCurved = SupportSamples.IsCurved(a) || SupportSamples.IsCurved(b);
        List<Vector3>? corners = isCurved ? null : Corners(a, b, bInA, isCoarse ? MostCornersCoarse : MostCorners);
        return ShapeMesh.Of(
            new ConvexHull(corners ?? Supports(a, b, bInA, isCoarse ? CoarseMeridians : Meridians)), isCurved);
    }

    private static List<Vector3>? Corners(in ConvexShape a, in ConvexShape b, in Turn bInA, int most)
    {
        List<Vector3> cornersA = SupportSamples.Of(a, isCoarse: true), cornersB = SupportSamples.Of(b, isCoarse: true);
        if (cornersA.Count * cornersB.Count > most) return null;
        var points = new List<Vector3>();
        foreach (Vector3 corner in cornersB)
        {
            var turned = (Vector3)bInA.Apply(corner);
            foreach (Vector3 other in cornersA) points.Add(other - turned);
        }

        return points;
    }

    private static List<Vector3> Supports(in ConvexShape a, in ConvexShape b, in Turn bInA, int meridians)
    {
        var points = new List<Vector3>();
        for (int row = 0; row <= meridians / 2; row++)
        {
            (double up, double outward) = Math.SinCos(2 * Math.PI * row / meridians - Math.PI / 2);
            for (int i = 0; i < meridians; i++)
            {
                (double z, double x) = Math.SinCos(2 * Math.PI * i / meridians);
                var direction = new Double3(outward * x, up, outward * z);
                Double3 onB = SupportSamples.Support(b, bInA.Inverse(-direction));
                points.Add((Vector3)(SupportSamples.Support(a, direction) - bInA.Apply(onB)));
            }
        }

        return points;
    }

    /// <summary>The rotation of B as A sees it.</summary>
    private readonly struct Turn
    {
        private readonly Quaternion _aInWorld, _bInWorld;

        public Turn(Quaternion aInWorld, Quaternion bInWorld) => (_aInWorld, _bInWorld) = (aInWorld, bInWorld);

        public Double3 Apply(in Double3 v) => Turned(Turned(v, _bInWorld, 1), _aInWorld, -1);

        public Double3 Inverse(in Double3 v) => Turned(Turned(v, _aInWorld, 1), _bInWorld, -1);

        /// <summary>The rotation v + 2 u × (u × v + w v) / |q|², or its inverse.</summary>
        private static Double3 Turned(in Double3 v, Quaternion q, double sign)
        {
            var u = new Double3(sign * q.X, sign * q.Y, sign * q.Z);
            double w = q.W;
            return v + Double3.Cross(u, Double3.Cross(u, v) + v * w) * (2 / (u.LengthSquared + w * w));
        }
    }
}
