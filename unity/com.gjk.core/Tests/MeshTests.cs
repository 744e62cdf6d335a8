using System;
using Gjk.Core;
using NUnit.Framework;
using UnityEngine;

namespace Gjk.Unity.Tests
{
    /// <summary>Which meshes are taken, which are refused and how, and that hulls are kept.</summary>
    public class MeshTests
    {
        private GameObject _owner;

        [TearDown]
        public void CleanUp()
        {
            if (_owner != null) UnityEngine.Object.DestroyImmediate(_owner);
        }

        [Test]
        public void AHullIsMadeOnceForAllScales()
        {
            Mesh mesh = TestMeshes.Block();
            MeshFilter filter = Filter(mesh);
            ConvexHull first = GjkShapes.From(filter).Shape.Hull;
            filter.transform.localScale = new Vector3(2, -3, 0.5f);
            PosedShape scaled = GjkShapes.From(filter);
            Assert.AreSame(first, scaled.Shape.Hull);
            Assert.AreEqual(new System.Numerics.Vector3(2, -3, 0.5f), scaled.Shape.Scale);
            GjkShapes.Forget(mesh);
            Assert.IsFalse(ReferenceEquals(first, GjkShapes.From(filter).Shape.Hull));
        }

        [Test]
        public void ASkewedHullIsMadeOnceWhileTheRootMoves()
        {
            using (var hierarchy = new RandomHierarchy(3))
            {
                Transform leaf = hierarchy.Leaf.transform, root = leaf.parent.parent;
                root.localScale = new Vector3(1, 2, 3);
                leaf.parent.localRotation = Quaternion.AngleAxis(30, hierarchy.Direction());
                leaf.localScale = Vector3.one;
                var filter = hierarchy.Leaf.AddComponent<MeshFilter>();
                filter.sharedMesh = TestMeshes.Cube();
                ConvexHull first = GjkShapes.From(filter).Shape.Hull;
                root.localRotation = Quaternion.AngleAxis(10, hierarchy.Direction());
                root.localPosition = hierarchy.Vector(-5, 5);
                Assert.AreSame(first, GjkShapes.From(filter).Shape.Hull);
                leaf.localRotation = Quaternion.AngleAxis(70, hierarchy.Direction());
                Assert.IsFalse(ReferenceEquals(first, GjkShapes.From(filter).Shape.Hull));
            }
        }

        [Test]
        public void AChangedNumberOfVerticesIsNoticed()
        {
            Mesh mesh = TestMeshes.Cube();
            MeshFilter filter = Filter(mesh);
            Assert.AreEqual(8, GjkShapes.From(filter).Shape.Hull.VertexCount);
            mesh.triangles = new[] { 0, 1, 2 };
            mesh.vertices = new[] { Vector3.zero, Vector3.right, Vector3.up };
            Assert.AreEqual(3, GjkShapes.From(filter).Shape.Hull.VertexCount);
        }

        [Test]
        public void AnUnreadableMeshIsNamed()
        {
            Mesh mesh = TestMeshes.Cube();
            mesh.name = "Rock";
            mesh.UploadMeshData(true);
            string message = Refusal(Filter(mesh));
            StringAssert.Contains("'rock owner' (MeshFilter)", message);
            StringAssert.Contains("the mesh 'Rock' is not readable: tick Read/Write", message);
        }

        [Test]
        public void AConcaveMeshIsNamedAndItsHullCanBeMeant()
        {
            Mesh mesh = TestMeshes.Roof(-0.25f);
            mesh.name = "Bowl";
            string message = Refusal(Filter(mesh));
            StringAssert.Contains("the mesh 'Bowl' is concave: its convex hull reaches 0.447 beyond a face", message);
            var collider = _owner.AddComponent<MeshCollider>();
            collider.sharedMesh = mesh;
            StringAssert.Contains("is concave", Refusal(collider));
            collider.convex = true;
            Assert.AreEqual(8, GjkShapes.From(collider).Shape.Hull.VertexCount);
        }

        [Test]
        public void AConvexMeshIsTaken()
        {
            Assert.AreEqual(9, GjkShapes.From(Filter(TestMeshes.Roof(0.25f))).Shape.Hull.VertexCount);
            CleanUp();
            Assert.AreEqual(8, GjkShapes.From(Filter(TestMeshes.Block())).Shape.Hull.VertexCount);
        }

        /// <summary>
        /// The hull reaches beyond a side of the roof by twice the dent; a thousandth of the size is allowed.
        /// </summary>
        [Test]
        public void ASmallDentIsNoConcavity()
        {
            GjkShapes.From(Filter(TestMeshes.Roof(-0.45e-3f)));
            CleanUp();
            StringAssert.Contains("is concave", Refusal(Filter(TestMeshes.Roof(-0.55e-3f))));
        }

        [Test]
        public void InsideOutFacesAreNoConcavity()
        {
            Mesh mesh = TestMeshes.Cube();
            int[] triangles = mesh.triangles;
            Array.Reverse(triangles);
            mesh.triangles = triangles;
            GjkShapes.From(Filter(mesh));
        }

        [Test]
        public void AZeroScaleFlattens()
        {
            MeshFilter filter = Filter(TestMeshes.Cube());
            filter.transform.localScale = new Vector3(2, 0, 2);
            Assert.AreEqual(2, GjkShapes.From(filter).Shape.Hull.Dimension);
            filter.transform.localScale = new Vector3(0, 0, 2);
            Assert.AreEqual(1, GjkShapes.From(filter).Shape.Hull.Dimension);
            filter.transform.localScale = Vector3.zero;
            Assert.AreEqual(0, GjkShapes.From(filter).Shape.Hull.Dimension);
        }

        [Test]
        public void WhatHasNoShapeIsNamed()
        {
            MeshFilter filter = Filter(null);
            StringAssert.Contains("'rock owner' (MeshFilter) has no mesh", Refusal(filter));
            filter.sharedMesh = new Mesh();
            StringAssert.Contains("has no vertices", Refusal(filter));
            StringAssert.Contains("is a TerrainCollider", Refusal(_owner.AddComponent<TerrainCollider>()));
            StringAssert.Contains("is a Transform", Refusal(_owner.transform));
            Assert.Throws<ArgumentNullException>(() => GjkShapes.From((Collider)null));
            Assert.Throws<ArgumentNullException>(
                () => GjkShapes.From((Component)null, Vector3.zero, Quaternion.identity));
        }

        [Test]
        public void WhatIsNotFiniteIsRefused()
        {
            _owner = new GameObject("rock owner");
            var box = _owner.AddComponent<BoxCollider>();
            box.size = new Vector3(1, float.NaN, 1);
            StringAssert.Contains("a size that is not finite", Refusal(box));
            box.size = Vector3.one;
            _owner.transform.localPosition = new Vector3(float.PositiveInfinity, 0, 0);
            StringAssert.Contains("'rock owner' is not at a finite position", Refusal(box));
        }

        private static string Refusal(Component source) =>
            Assert.Throws<ArgumentException>(() => GjkShapes.From(source)).Message;

        private MeshFilter Filter(Mesh mesh)
        {
            _owner = new GameObject("rock owner");
            var filter = _owner.AddComponent<MeshFilter>();
            filter.sharedMesh = mesh;
            return filter;
        }
    }
}
