using System;
using System.Collections.Generic;
using Gjk.Core;
using NUnit.Framework;
using UnityEngine;

namespace Gjk.Unity.Tests
{
    /// <summary>Over 1,000 random hierarchies of three levels each: the adapters against the whole matrix. The
    /// tolerance is a millionth of the largest coordinate. Each failure names its seed.</summary>
    public class AdapterTests
    {
        private const int Hierarchies = 1000;
        private const int Directions = 24;
        private const double Tolerance = 1e-6;

        /// <summary>The cosine above which axes count as skewed: far above the rounding of quaternions, far below what
        /// random scales give.</summary>
        private const double SkewedFrom = 1e-5;

        [Test]
        public void AMeshIsEachVertexThroughTheWholeMatrix()
        {
            int skewed = 0, flat = 0, mirrored = 0;
            Mesh mesh = TestMeshes.Block();
            for (int seed = 0; seed < Hierarchies; seed++)
            {
                using (var hierarchy = new RandomHierarchy(seed))
                {
                    var collider = hierarchy.Leaf.AddComponent<MeshCollider>();
                    collider.convex = true;
                    collider.sharedMesh = mesh;
                    Affine whole = Affine.Of(hierarchy.Leaf.transform);
                    PosedShape body = GjkShapes.From(collider);
                    Check(hierarchy, body, Through(whole, mesh.vertices), 0, 0, seed);
                    if (whole.Skew > SkewedFrom) skewed++;
                    if (hierarchy.IsFlat) flat++;
                    Double3 scale = Affine.LossyScale(hierarchy.Leaf.transform, out _);
                    if (scale.X * scale.Y * scale.Z < 0) mirrored++;
                }
            }

            Assert.IsTrue(skewed > 300 && skewed < 900, skewed + " were skewed");
            Assert.IsTrue(flat > 100, flat + " were flat");
            Assert.IsTrue(mirrored > 200, mirrored + " were mirrored");
        }

        [Test]
        public void ABoxWithoutSkewIsEachCornerThroughTheWholeMatrix()
        {
            for (int seed = 0; seed < Hierarchies; seed++)
            {
                using (var hierarchy = new RandomHierarchy(seed, isSkewAllowed: false))
                {
                    var box = hierarchy.Leaf.AddComponent<BoxCollider>();
                    box.center = hierarchy.Vector(-1, 1);
                    box.size = hierarchy.Vector(0, 2);
                    Affine whole = Affine.Of(hierarchy.Leaf.transform);
                    Assert.IsTrue(whole.Skew < SkewedFrom, "seed " + seed + " is skewed");
                    Check(hierarchy, GjkShapes.From(box), Through(whole, Corners(box)), 0, 0, seed);
                }
            }
        }

        [Test]
        public void ABoxUnderSkewKeepsItsRightAnglesAsInTheEngine()
        {
            for (int seed = 0; seed < Hierarchies; seed++)
            {
                using (var hierarchy = new RandomHierarchy(seed))
                {
                    var box = hierarchy.Leaf.AddComponent<BoxCollider>();
                    box.center = hierarchy.Vector(-1, 1);
                    box.size = hierarchy.Vector(0, 2);
                    Transform t = hierarchy.Leaf.transform;
                    Double3 scale = Affine.LossyScale(t, out Affine rotation);
                    Double3 center = Affine.Of(t).Point(box.center);
                    var corners = new List<Double3>();
                    foreach (Vector3 corner in Corners(box))
                    {
                        Vector3 arm = corner - box.center;
                        corners.Add(center
                            + rotation.Vector(Double3.Multiply(scale, new Double3(arm.x, arm.y, arm.z))));
                    }

                    Check(hierarchy, GjkShapes.From(box), corners, 0, 0, seed);
                }
            }
        }

        [Test]
        public void ASphereTakesTheLargestScale()
        {
            for (int seed = 0; seed < Hierarchies; seed++)
            {
                using (var hierarchy = new RandomHierarchy(seed))
                {
                    var sphere = hierarchy.Leaf.AddComponent<SphereCollider>();
                    sphere.center = hierarchy.Vector(-1, 1);
                    sphere.radius = hierarchy.Float(0, 2);
                    Transform t = hierarchy.Leaf.transform;
                    Double3 s = Affine.LossyScale(t, out _);
                    double radius = sphere.radius * Math.Max(Math.Abs(s.X), Math.Max(Math.Abs(s.Y), Math.Abs(s.Z)));
                    var center = new List<Double3> { Affine.Of(t).Point(sphere.center) };
                    Check(hierarchy, GjkShapes.From(sphere), center, radius, radius, seed);
                }
            }
        }

        [Test]
        public void ACapsuleFollowsItsDirectionAndTheLargerScaleAcross()
        {
            int balls = 0;
            for (int seed = 0; seed < Hierarchies; seed++)
            {
                using (var hierarchy = new RandomHierarchy(seed))
                {
                    var capsule = hierarchy.Leaf.AddComponent<CapsuleCollider>();
                    capsule.center = hierarchy.Vector(-1, 1);
                    capsule.radius = hierarchy.Float(0, 1);
                    capsule.height = hierarchy.Float(0, 4);
                    capsule.direction = seed % 3;
                    Transform t = hierarchy.Leaf.transform;
                    Double3 s = Affine.LossyScale(t, out Affine rotation);
                    double[] scale = { Math.Abs(s.X), Math.Abs(s.Y), Math.Abs(s.Z) };
                    int axis = capsule.direction;
                    double radius = capsule.radius * Math.Max(scale[(axis + 1) % 3], scale[(axis + 2) % 3]);
                    double half = Math.Max(capsule.height * scale[axis] / 2 - radius, 0);
                    if (half == 0) balls++;
                    Double3 along = rotation.Vector(
                        new Double3(axis == 0 ? half : 0, axis == 1 ? half : 0, axis == 2 ? half : 0));
                    Double3 center = Affine.Of(t).Point(capsule.center);
                    var ends = new List<Double3> { center + along, center - along };
                    Check(hierarchy, GjkShapes.From(capsule), ends, radius, radius, seed);
                }
            }

            Assert.IsTrue(balls > 200 && balls < 800, balls + " were balls");
        }

        /// <summary>In an Editor this holds the engine itself to what the adapters take it to do.</summary>
        [Test]
        public void TheEngineHasTheSameMatrixRotationAndScale()
        {
            const double rounding = 2e-5;
            for (int seed = 0; seed < Hierarchies; seed++)
            {
                using (var hierarchy = new RandomHierarchy(seed))
                {
                    Transform t = hierarchy.Leaf.transform;
                    TransformFrame.Of(t, out TransformFrame frame);
                    Double3 scale = frame.Stretch.Scale;
                    Assert.IsTrue(Affine.Of(t).Difference(t.localToWorldMatrix) < 5 * rounding, "matrix, seed " + seed);
                    Assert.IsTrue((scale.ToUnity() - t.lossyScale).magnitude < 5 * rounding, "scale, seed " + seed);
                    Vector3 x = t.rotation * Vector3.right, y = t.rotation * Vector3.up;
                    Assert.IsTrue((frame.Turn.X.ToUnity() - x).magnitude < rounding, "rotation, seed " + seed);
                    Assert.IsTrue((frame.Turn.Y.ToUnity() - y).magnitude < rounding, "rotation, seed " + seed);
                }
            }
        }

        [Test]
        public void AStretchKeepsItsBitsWhileTheRootMoves()
        {
            for (int seed = 0; seed < 100; seed++)
            {
                using (var hierarchy = new RandomHierarchy(seed))
                {
                    Transform leaf = hierarchy.Leaf.transform, root = leaf.parent.parent;
                    TransformFrame.Of(leaf, out TransformFrame before);
                    if (before.Stretch.Equals(Stretch.None)) continue;
                    root.localRotation = Quaternion.AngleAxis(hierarchy.Float(0, 360), hierarchy.Direction());
                    root.localPosition = hierarchy.Vector(-9, 9);
                    TransformFrame.Of(leaf, out TransformFrame after);
                    Assert.IsTrue(before.Stretch.Equals(after.Stretch), "seed " + seed);
                }
            }
        }

        [Test]
        public void ALittleNoiseIsNoSkew()
        {
            var scale = new Double3(1, 2, 3);
            Stretch uneven = Stretch.None.Child(Turn.None, Turn.None, scale);
            foreach (double angle in new[] { 1e-8, 1e-6 })
            {
                var turn = new Turn(0, 0, angle / 2, 1);
                Assert.AreEqual(angle < 1e-7, uneven.Child(turn, turn, new Double3(1, 1, 1)).IsDiagonal);
            }
        }

        private static List<Double3> Through(in Affine whole, Vector3[] points)
        {
            var found = new List<Double3>();
            foreach (Vector3 point in points) found.Add(whole.Point(point));
            return found;
        }

        private static Vector3[] Corners(BoxCollider box)
        {
            var corners = new Vector3[8];
            for (int i = 0; i < 8; i++)
            {
                var half = new Vector3((i & 1) - 0.5f, (i >> 1 & 1) - 0.5f, (i >> 2) - 0.5f);
                corners[i] = box.center + Vector3.Scale(box.size, half);
            }

            return corners;
        }

        private static void Check(
            RandomHierarchy hierarchy, in PosedShape body, List<Double3> points, double margin, double width, int seed)
        {
            double size = Reach.Size(points) + width;
            for (int k = 0; k < Directions; k++)
            {
                Vector3 direction = hierarchy.Direction();
                double error = Math.Abs(Reach.Of(body, direction) - Reach.Of(points, direction) - margin);
                Assert.IsTrue(error <= Tolerance * size, "seed " + seed + ": " + error + " off at size " + size);
            }
        }
    }
}
