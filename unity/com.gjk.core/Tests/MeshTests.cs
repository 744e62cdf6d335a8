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

        /// <summary>Moved, deformed and baked meshes keep the number of their vertices.</summary>
        [Test]
        public void AMovedVertexIsNoticed()
        {
            Mesh mesh = TestMeshes.Cube();
            var many = new Vector3[960];
            for (int i = 0; i < many.Length; i++) many[i] = mesh.vertices[i % 24];
            mesh.vertices = many;
            MeshCollider collider = Hull(mesh);
            Assert.AreEqual(8, GjkShapes.From(collider).Shape.Hull.VertexCount);
            many[many.Length - 1] += Vector3.right * 7;
            mesh.vertices = many;
            Assert.IsTrue(GjkShapes.From(collider).Shape.Hull.Bounds.LongestSide > 7);
            for (int i = 0; i < many.Length; i++) many[i] = new Vector3(many[i].x * 0.5f, many[i].y, many[i].z);
            mesh.vertices = many;
            Assert.IsTrue(GjkShapes.From(collider).Shape.Hull.Bounds.LongestSide < 4.5);
        }

        /// <summary>Of many vertices not all are compared; the bounds tell, too.</summary>
        [Test]
        public void OfAManyCorneredMeshTheBoundsAreCompared()
        {
            Mesh mesh = TestMeshes.Cube();
            var many = new Vector3[4800];
            for (int i = 0; i < many.Length; i++) many[i] = mesh.vertices[i % 24];
            mesh.vertices = many;
            MeshCollider collider = Hull(mesh);
            ConvexHull first = GjkShapes.From(collider).Shape.Hull;
            Assert.AreSame(first, GjkShapes.From(collider).Shape.Hull);
            many[1] += Vector3.right * 7;
            mesh.vertices = many;
            mesh.bounds = new Bounds(Vector3.right, Vector3.one);
            Assert.IsFalse(ReferenceEquals(first, GjkShapes.From(collider).Shape.Hull));
        }

        [Test]
        public void AConcaveMeshIsItsSurfaceAndItsHullCanBeMeant()
        {
            Mesh mesh = TestMeshes.Roof(-0.25f);
            PosedShape surface = GjkShapes.From(Filter(mesh));
            Assert.IsFalse(surface.IsConvex);
            Assert.AreEqual(AnyShapeKind.Surface, surface.Any.Kind);
            Assert.AreEqual(14, surface.Mesh.TriangleCount);
            Assert.AreEqual(AnyShapeKind.Solid, GjkShapes.From(_owner.GetComponent<MeshFilter>(), true).Any.Kind);
            Assert.AreSame(surface.Mesh, GjkShapes.From(_owner.GetComponent<MeshFilter>()).Mesh);
            var collider = _owner.AddComponent<MeshCollider>();
            collider.sharedMesh = mesh;
            Assert.AreSame(surface.Mesh, GjkShapes.From(collider).Mesh);
            collider.convex = true;
            Assert.AreEqual(8, GjkShapes.From(collider).Shape.Hull.VertexCount);
        }

        /// <summary>What is open has no inside, whatever is asked for.</summary>
        [Test]
        public void AnOpenMeshStaysASurface()
        {
            Mesh mesh = TestMeshes.Roof(-0.25f);
            int[] all = mesh.triangles;
            var open = new int[all.Length - 3];
            Array.Copy(all, open, open.Length);
            mesh.triangles = open;
            Assert.AreEqual(AnyShapeKind.Surface, GjkShapes.From(Filter(mesh), isSolid: true).Any.Kind);
        }

        /// <summary>The dent of the roof is 0.25 deep, and scaled and skewed as the mesh is.</summary>
        [Test]
        public void ABallInADentIsApart()
        {
            MeshFilter filter = Filter(TestMeshes.Roof(-0.25f));
            PosedShape ball = Ball(0.5f);
            double slope = Math.Sqrt(0.2);
            Assert.AreEqual(0.25 * 2 * slope - 0.125, GjkPhysics.Distance(GjkShapes.From(filter), ball).distance, 1e-6);
            filter.transform.localScale = new Vector3(1, 2, 1);
            ball = Ball(1);
            double steep = Math.Sqrt(0.5);
            Assert.AreEqual(0.5 * steep - 0.125, GjkPhysics.Distance(GjkShapes.From(filter), ball).distance, 1e-6);
            filter.transform.localScale = new Vector3(1, 0, 1);
            Assert.AreEqual(0.875, GjkPhysics.Distance(GjkShapes.From(filter), ball).distance, 1e-6);
        }

        [Test]
        public void ACharacterStandsUpright()
        {
            _owner = new GameObject("player");
            var character = _owner.AddComponent<CharacterController>();
            character.height = 4;
            character.center = new Vector3(0, 1, 0);
            _owner.transform.localScale = new Vector3(3, 2, 1);
            _owner.transform.localRotation = Quaternion.AngleAxis(90, Vector3.forward);
            _owner.transform.localPosition = new Vector3(5, 0, 0);
            PosedShape player = GjkShapes.From(character);

            // The centre turns with the object, to -x; the capsule does not.
            Assert.AreEqual(4, Reach.Of(player, Vector3.up), 1e-6);
            Assert.AreEqual(4.5, Reach.Of(player, Vector3.right), 1e-6);
            Assert.AreEqual(1.5, Reach.Of(player, Vector3.forward), 1e-6);
        }

        [Test]
        public void ATerrainIsItsHeights()
        {
            _owner = new GameObject("terrain");
            var data = new TerrainData { size = new Vector3(2, 10, 4) };
            data.SetHeights(0, 0, new[,] { { 0, 0, 0 }, { 0, 0.5f, 0 }, { 0, 0, 0 } });
            var terrain = _owner.AddComponent<TerrainCollider>();
            StringAssert.Contains("'terrain' (TerrainCollider) has no terrain data", Refusal(terrain));
            terrain.terrainData = data;
            _owner.transform.localPosition = new Vector3(10, 0, 0);
            _owner.transform.localScale = Vector3.one * 3;
            PosedShape ground = GjkShapes.From(terrain);
            Assert.AreEqual(8, ground.Mesh.TriangleCount);
            var point = new PosedShape(ConvexShape.Point(), new RigidPose(new System.Numerics.Vector3(11, 7, 2)));
            Assert.AreEqual(2, GjkPhysics.Distance(ground, point).distance, 1e-6);
            data.SetHoles(0, 0, new[,] { { true, false }, { false, false } });
            GjkShapes.Forget(data);
            Assert.AreEqual(2, GjkShapes.From(terrain).Mesh.TriangleCount);
            data.SetHoles(0, 0, new bool[2, 2]);
            GjkShapes.Forget(data);
            StringAssert.Contains("only holes", Refusal(terrain));
        }

        [Test]
        public void AConvexMeshIsTaken()
        {
            Assert.AreEqual(9, GjkShapes.From(Filter(TestMeshes.Roof(0.25f))).Shape.Hull.VertexCount);
            CleanUp();
            Assert.AreEqual(8, GjkShapes.From(Filter(TestMeshes.Block())).Shape.Hull.VertexCount);
        }

        /// <summary>The hull reaches beyond a side of the roof by twice the dent; a thousandth of the size is
        /// allowed.</summary>
        [Test]
        public void ASmallDentIsNoConcavity()
        {
            Assert.IsTrue(GjkShapes.From(Filter(TestMeshes.Roof(-0.45e-3f))).IsConvex);
            CleanUp();
            Assert.IsFalse(GjkShapes.From(Filter(TestMeshes.Roof(-0.55e-3f))).IsConvex);
        }

        [Test]
        public void InsideOutFacesAreNoConcavity()
        {
            Mesh mesh = TestMeshes.Cube();
            int[] triangles = mesh.triangles;
            Array.Reverse(triangles);
            mesh.triangles = triangles;
            Assert.IsTrue(GjkShapes.From(Filter(mesh)).IsConvex);
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
            StringAssert.Contains("is a WheelCollider", Refusal(_owner.AddComponent<WheelCollider>()));
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

        private static PosedShape Ball(float y) =>
            new PosedShape(ConvexShape.Sphere(0.125f), new RigidPose(new System.Numerics.Vector3(0, y, 0)));

        private static string Refusal(Component source) =>
            Assert.Throws<ArgumentException>(() => GjkShapes.From(source)).Message;

        private MeshCollider Hull(Mesh mesh)
        {
            Filter(mesh);
            var collider = _owner.AddComponent<MeshCollider>();
            collider.sharedMesh = mesh;
            collider.convex = true;
            return collider;
        }

        private MeshFilter Filter(Mesh mesh)
        {
            _owner = new GameObject("rock owner");
            var filter = _owner.AddComponent<MeshFilter>();
            filter.sharedMesh = mesh;
            return filter;
        }
    }
}
