using System;
using Gjk.Core;
using NUnit.Framework;
using UnityEngine;

namespace Gjk.Unity.Tests
{
    /// <summary>The questions of <see cref="GjkPhysics"/>, on answers that can be worked out by hand.</summary>
    public class PhysicsTests
    {
        private GameObject _first, _second;
        private BoxCollider _box;
        private SphereCollider _sphere;

        /// <summary>A unit cube at the origin and a ball of radius 0.5 at (x, 0, 0).</summary>
        private void Place(float x)
        {
            CleanUp();
            _first = new GameObject("box");
            _second = new GameObject("sphere");
            _box = _first.AddComponent<BoxCollider>();
            _sphere = _second.AddComponent<SphereCollider>();
            _second.transform.localPosition = new Vector3(x, 0, 0);
        }

        [TearDown]
        public void CleanUp()
        {
            if (_first != null) UnityEngine.Object.DestroyImmediate(_first);
            if (_second != null) UnityEngine.Object.DestroyImmediate(_second);
        }

        [Test]
        public void ApartTheDistanceIsPositive()
        {
            Place(3);
            ColliderDistance3D d = GjkPhysics.Distance(_box, _sphere);
            Assert.IsTrue(d.isValid);
            Assert.IsFalse(d.isOverlapped);
            Assert.AreEqual(2, d.distance, 1e-6);
            Same(new Vector3(0.5f, 0, 0), d.pointA);
            Same(new Vector3(2.5f, 0, 0), d.pointB);
            Same(Vector3.right, d.normal);
            Same(d.pointB, d.pointA + d.normal * d.distance);
            Assert.IsFalse(GjkPhysics.Overlaps(_box, _sphere));
            Assert.IsFalse(default(ColliderDistance3D).isValid);
        }

        [Test]
        public void OverlappingTheDistanceIsMinusTheDepth()
        {
            Place(0.75f);
            ColliderDistance3D d = GjkPhysics.Distance(_box, _sphere);
            Assert.IsTrue(d.isValid && d.isOverlapped);
            Assert.AreEqual(-0.25, d.distance, 1e-6);
            Same(Vector3.right, d.normal);
            Same(d.pointB, d.pointA + d.normal * d.distance);
            Assert.IsTrue(GjkPhysics.Overlaps(_box, _sphere));

            // Moving A by normal * distance makes them touch.
            _first.transform.localPosition = d.normal * d.distance;
            Assert.AreEqual(0, GjkPhysics.Distance(_box, _sphere).distance, 1e-6);
        }

        [Test]
        public void SwappedIsTheOtherOrder()
        {
            Place(3);
            ColliderDistance3D there = GjkPhysics.Distance(_box, _sphere).swapped;
            ColliderDistance3D back = GjkPhysics.Distance(_sphere, _box);
            Assert.AreEqual(back.distance, there.distance, 1e-6);
            Same(back.pointA, there.pointA);
            Same(back.pointB, there.pointB);
            Same(back.normal, there.normal);
            Assert.AreEqual(back.isValid, there.isValid);
        }

        [Test]
        public void PenetrationMovesTheFirstOut()
        {
            Place(9);
            var at = new Vector3(0, 0, 0.75f);
            bool isFound = GjkPhysics.ComputePenetration(
                _box, Vector3.zero, Quaternion.identity, _sphere, at, Quaternion.identity, out Vector3 direction,
                out float distance);
            Assert.IsTrue(isFound);
            Same(-Vector3.forward, direction);
            Assert.AreEqual(0.25, distance, 1e-6);
            isFound = GjkPhysics.ComputePenetration(
                _box, Vector3.zero, Quaternion.identity, _sphere, at * 2, Quaternion.identity, out direction,
                out distance);
            Assert.IsFalse(isFound);
            Same(Vector3.zero, direction);
            Assert.AreEqual(0, distance, 0);
        }

        [Test]
        public void AGivenPoseReplacesTheTransformAndKeepsTheScale()
        {
            Place(9);
            _first.transform.localScale = new Vector3(4, 1, 1);
            _box.center = new Vector3(0.25f, 0, 0);
            Quaternion quarter = Quaternion.AngleAxis(90, Vector3.up);

            // The centre goes 1 along x by the scale, then to -z by the turn; the box reaches 2 further.
            Vector3 closest = GjkPhysics.ClosestPoint(new Vector3(10, 0, -10), _box, new Vector3(10, 0, 0), quarter);
            Same(new Vector3(10, 0, -3), closest);
        }

        [Test]
        public void TheClosestPointOfAPointInsideIsThePoint()
        {
            Place(3);
            Same(new Vector3(2.5f, 0, 0), GjkPhysics.ClosestPoint(Vector3.zero, _sphere));
            var inside = new Vector3(3.25f, 0.1f, 0);
            Same(inside, GjkPhysics.ClosestPoint(inside, _sphere));
        }

        [Test]
        public void ACastStopsWhereTheyTouch()
        {
            Place(4);
            Assert.IsTrue(GjkPhysics.Cast(_box, Vector3.right * 7, 10, _sphere, out ColliderCastHit hit));
            Assert.AreEqual(3, hit.distance, 1e-5);
            Assert.AreEqual(0.3, hit.fraction, 1e-6);
            Same(new Vector3(3.5f, 0, 0), hit.point);
            Same(-Vector3.right, hit.normal);
            Assert.IsFalse(hit.isOverlappedAtStart);
            Assert.IsFalse(GjkPhysics.Cast(_box, Vector3.right, 2.9f, _sphere, out _));
            Assert.IsFalse(GjkPhysics.Cast(_box, -Vector3.right, 10, _sphere, out _));
            _second.transform.localPosition = Vector3.zero;
            Assert.IsTrue(GjkPhysics.Cast(_box, Vector3.right, 1, _sphere, out hit));
            Assert.IsTrue(hit.isOverlappedAtStart);
            Assert.AreEqual(0, hit.distance, 0);
            Assert.AreEqual(1, hit.normal.magnitude, 1e-6);
            Assert.IsTrue(hit.depth > 0);
        }

        /// <summary>As the engine's casts, whose distance is Mathf.Infinity where none is given.</summary>
        [Test]
        public void ACastMayBeEndless()
        {
            Place(4);
            Assert.IsTrue(GjkPhysics.Cast(_box, Vector3.right * 7, Mathf.Infinity, _sphere, out ColliderCastHit hit));
            Assert.AreEqual(3, hit.distance, 1e-5);
            Same(new Vector3(3.5f, 0, 0), hit.point);
            Assert.AreEqual(0, hit.fraction, 0);
            Assert.AreSame(_sphere, hit.collider);
            Assert.IsFalse(GjkPhysics.Cast(_box, -Vector3.right, Mathf.Infinity, _sphere, out _));
            _second.transform.localPosition = new Vector3(1e6f, 0, 0);
            Assert.IsTrue(GjkPhysics.Cast(_box, Vector3.right, Mathf.Infinity, _sphere, out hit));
            Assert.AreEqual(1e6, hit.distance, 1.5);
        }

        [Test]
        public void ARayMeetsACollider()
        {
            Place(4);
            var ray = new Ray(Vector3.zero, Vector3.right * 2);
            Assert.IsTrue(GjkPhysics.Raycast(_sphere, ray, out ColliderRayHit hit, Mathf.Infinity));
            Assert.AreEqual(3.5, hit.distance, 1e-6);
            Same(new Vector3(3.5f, 0, 0), hit.point);
            Same(-Vector3.right, hit.normal);
            Assert.AreEqual(-1, hit.triangleIndex);
            Assert.IsFalse(GjkPhysics.Raycast(_sphere, ray, out _, 3));
            Assert.IsTrue(GjkPhysics.Raycast(_box, ray, out hit, 3));
            Assert.IsTrue(hit.isOverlappedAtStart);
        }

        [Test]
        public void ARayThatStartsInsideMayPass()
        {
            Place(4);
            var ray = new Ray(Vector3.zero, Vector3.right);
            Assert.IsTrue(GjkPhysics.Raycast(_box, ray, out _, 3));
            Assert.IsFalse(GjkPhysics.Raycast(_box, ray, out _, 3, RaySides.Hollow | RaySides.FrontOnly));
            Assert.IsTrue(GjkPhysics.Raycast(_sphere, ray, out _, 9, RaySides.Hollow | RaySides.FrontOnly));
            _second.transform.localPosition = Vector3.zero;
            var roof = _second.AddComponent<MeshCollider>();
            roof.sharedMesh = TestMeshes.Roof(-0.25f);
            var up = new Ray(new Vector3(0.2f, -0.3f, 0.1f), Vector3.up);
            Assert.IsTrue(GjkPhysics.Raycast(roof, up, out _, 9));
            Assert.IsFalse(GjkPhysics.Raycast(roof, up, out _, 9, RaySides.FrontOnly));
        }

        [Test]
        public void ListsAreFilledWithoutMemoryOfTheirOwn()
        {
            Place(3);
            var results = new ColliderDistance3D[3];
            Assert.AreEqual(2, GjkPhysics.Distances(_box, new Collider[] { _sphere, _box }, results));
            Assert.AreEqual(2, results[0].distance, 1e-6);
            Assert.AreEqual(-1, results[1].distance, 1e-6);
            Assert.AreEqual(1, GjkPhysics.Distances(_box, new Collider[] { _sphere, _box }, new ColliderDistance3D[1]));
            var contacts = new ColliderContact[8];
            Assert.AreEqual(0, GjkPhysics.Contacts(_box, _sphere, contacts));
            Assert.AreEqual(1, GjkPhysics.Contacts(_box, _sphere, contacts, 3));
            Assert.AreEqual(2, contacts[0].separation, 1e-6);
            var other = _second.AddComponent<BoxCollider>();
            _second.transform.localPosition = new Vector3(0, 0.75f, 0);
            Assert.AreEqual(4, GjkPhysics.Contacts(_box, other, contacts));
            Assert.AreEqual(-0.25, contacts[3].separation, 1e-6);
            Same(Vector3.up, contacts[3].normal);
            Assert.AreEqual(3, GjkPhysics.Contacts(_box, other, new ColliderContact[3]));
        }

        /// <summary>A box that stands over the ridge of a roof touches both sides; of two points the deeper ones are
        /// kept.</summary>
        [Test]
        public void ContactsOfASurfaceAreThoseOfAllItsTriangles()
        {
            Place(0);
            var surface = _second.AddComponent<MeshCollider>();
            surface.sharedMesh = TestMeshes.Roof(-0.25f);
            var all = new ColliderContact[16];
            int count = GjkPhysics.Contacts(_box, surface, all);
            Assert.IsTrue(count > 1, count.ToString());
            var one = new ColliderContact[1];
            Assert.AreEqual(1, GjkPhysics.Contacts(_box, surface, one));
            for (int i = 0; i < count; i++) Assert.IsTrue(one[0].separation <= all[i].separation);
            Assert.AreEqual(0, GjkPhysics.Contacts(_box, surface, new ColliderContact[0]));
        }

        /// <summary>A body that stands in a surface is lifted out of the triangle that is deepest in it.</summary>
        [Test]
        public void PenetrationOfASurfaceIsTheWayOutOfItsDeepestPart()
        {
            Place(0);
            Mesh mesh = TestMeshes.Roof(-0.25f);
            var surface = _first.AddComponent<MeshCollider>();
            surface.sharedMesh = mesh;
            bool isFound = GjkPhysics.ComputePenetration(
                _sphere, new Vector3(0.9f, 0, 0), Quaternion.identity, surface, Vector3.zero, Quaternion.identity,
                out Vector3 direction, out float distance);
            Assert.IsTrue(isFound);
            Assert.AreEqual(0.1, distance, 1e-6);
            Same(Vector3.right, direction);
        }

        /// <summary>Touching shares a point, which the engine's overlap queries count, too.</summary>
        [Test]
        public void TouchingIsOverlappedAtDistanceZero()
        {
            Place(1);
            ColliderDistance3D d = GjkPhysics.Distance(_box, _sphere);
            Assert.IsTrue(d.isOverlapped);
            Assert.AreEqual(0, d.distance, 0);
        }

        [Test]
        public void ResultsTellWhatTheyAre()
        {
            Place(3);
            StringAssert.Contains("apart, distance 2, (0.50, ", GjkPhysics.Distance(_box, _sphere).ToString());
            Assert.AreEqual("not valid", default(ColliderDistance3D).ToString());
            GjkPhysics.Cast(_box, Vector3.right, 9, _sphere, out ColliderCastHit cast);
            StringAssert.Contains("hit at 2, point (2.50, ", cast.ToString());
            GjkPhysics.Raycast(_sphere, new Ray(Vector3.zero, Vector3.right), out ColliderRayHit ray, 9);
            StringAssert.Contains("hit at 2.5, point (2.50, ", ray.ToString());
            var contacts = new ColliderContact[1];
            GjkPhysics.Contacts(_box, _sphere, contacts, 3);
            StringAssert.Contains("separation 2, (0.50, ", contacts[0].ToString());
        }

        [Test]
        public void ACastWithoutAWayIsRefused()
        {
            Place(4);
            Assert.AreEqual("direction", Refused(Vector3.zero, 1));
            Assert.AreEqual("direction", Refused(new Vector3(float.NaN, 0, 0), 1));
            Assert.AreEqual("maxDistance", Refused(Vector3.right, -1));
            Assert.AreEqual("maxDistance", Refused(Vector3.right, float.NaN));
        }

        private string Refused(Vector3 direction, float distance) =>
            Assert.Throws<ArgumentOutOfRangeException>(
                () => GjkPhysics.Cast(_box, direction, distance, _sphere, out _)).ParamName;

        private static void Same(Vector3 expected, Vector3 actual) =>
            Assert.IsTrue((expected - actual).magnitude < 2e-6f, "Expected: " + expected + ", but was: " + actual);
    }
}
