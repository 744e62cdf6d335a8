using System;
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

        [Test]
        public void ACastWithoutAWayIsRefused()
        {
            Place(4);
            Assert.AreEqual("direction", Refused(Vector3.zero, 1));
            Assert.AreEqual("direction", Refused(new Vector3(float.NaN, 0, 0), 1));
            Assert.AreEqual("maxDistance", Refused(Vector3.right, -1));
            Assert.AreEqual("maxDistance", Refused(Vector3.right, float.PositiveInfinity));
        }

        private string Refused(Vector3 direction, float distance) =>
            Assert.Throws<ArgumentOutOfRangeException>(
                () => GjkPhysics.Cast(_box, direction, distance, _sphere, out _)).ParamName;

        private static void Same(Vector3 expected, Vector3 actual) =>
            Assert.IsTrue((expected - actual).magnitude < 2e-6f, "Expected: " + expected + ", but was: " + actual);
    }
}
