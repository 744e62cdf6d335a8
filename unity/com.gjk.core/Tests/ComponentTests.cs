using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Gjk.Unity.Tests
{
    /// <summary>The two components, driven by hand instead of by frames.</summary>
    public class ComponentTests
    {
        private readonly List<GameObject> _made = new List<GameObject>();

        [TearDown]
        public void CleanUp()
        {
            foreach (GameObject made in _made)
            {
                if (made != null) UnityEngine.Object.DestroyImmediate(made);
            }

            _made.Clear();
        }

        [Test]
        public void ADistanceIsMeasuredBetweenAColliderAndAMesh()
        {
            GameObject box = Box("box", Vector3.zero), mesh = Make("mesh", new Vector3(3, 0, 0));
            mesh.AddComponent<MeshFilter>().sharedMesh = TestMeshes.Cube();
            var component = box.AddComponent<ConvexDistance>();
            component.Target = mesh;
            Assert.AreEqual(2, component.Measure().distance, 1e-6);
            Assert.IsTrue(component.Problem == null);
            component.Target = box;
            Assert.IsTrue(component.Measure().isOverlapped);
        }

        [Test]
        public void AMissingTargetIsAProblemAndNoResult()
        {
            GameObject box = Box("box", Vector3.zero), other = Make("nothing", Vector3.zero);
            var component = box.AddComponent<ConvexDistance>();
            Assert.IsFalse(component.Measure().isValid);
            Assert.AreEqual("There is no target.", component.Problem);
            component.Target = other;
            Assert.IsFalse(component.Measure().isValid);
            Assert.AreEqual("'nothing' has no collider, half-space or mesh filter.", component.Problem);
            other.AddComponent<SphereCollider>();
            Assert.IsTrue(component.Measure().isValid);
            UnityEngine.Object.DestroyImmediate(other);
            Assert.IsFalse(component.Measure().isValid);
            Assert.AreEqual("There is no target.", component.Problem);
        }

        [Test]
        public void ASensorFindsWhatIsWithinItsRadius()
        {
            GameObject root = Make("root", Vector3.zero), own = Box("sensor", Vector3.zero);
            GameObject near = Box("near", new Vector3(1.5f, 0, 0), root), far = Box("far", new Vector3(5, 0, 0), root);
            ProximitySensor sensor = Sensor(own, root);
            sensor.Sense();
            Assert.AreEqual(2, sensor.WatchedCount);
            Assert.AreEqual(1, sensor.Near.Count);
            Assert.AreSame(near.GetComponent<BoxCollider>(), sensor.Near[0].Source);
            Assert.AreEqual(0.5, sensor.Near[0].Distance.distance, 1e-6);
            Assert.AreEqual(0.5, sensor.Near[0].Distance.pointA.x, 1e-6);

            far.transform.localPosition = new Vector3(0, 1.25f, 0);
            sensor.Sense();
            Assert.AreEqual(2, sensor.Near.Count);
            Assert.IsTrue(sensor.TryGetNearest(out ProximityHit nearest));
            Assert.AreSame(far.GetComponent<BoxCollider>(), nearest.Source);
            sensor.Radius = 0.1f;
            sensor.Sense();
            Assert.IsFalse(sensor.TryGetNearest(out _));
            Assert.Throws<ArgumentOutOfRangeException>(() => sensor.Radius = -1);
        }

        [Test]
        public void ASensorTellsWhoComesAndGoes()
        {
            GameObject root = Make("root", Vector3.zero), own = Box("sensor", Vector3.zero);
            GameObject other = Box("other", new Vector3(5, 0, 0), root);
            ProximitySensor sensor = Sensor(own, root);
            var told = new List<string>();
            sensor.Entered.AddListener(c => told.Add("in " + c.name));
            sensor.Exited.AddListener(c => told.Add(c == null ? "gone" : "out " + c.name));
            var collider = other.GetComponent<BoxCollider>();

            sensor.Sense();
            other.transform.localPosition = new Vector3(1.5f, 0, 0);
            sensor.Sense();
            sensor.Sense();
            other.transform.localPosition = new Vector3(5, 0, 0);
            sensor.Sense();
            other.transform.localPosition = Vector3.zero;
            sensor.Sense();
            collider.enabled = false;
            sensor.Sense();
            collider.enabled = true;
            sensor.Sense();
            other.SetActive(false);
            sensor.Sense();
            other.SetActive(true);
            sensor.Sense();
            UnityEngine.Object.DestroyImmediate(other);
            sensor.Sense();
            Assert.AreEqual(
                "in other, out other, in other, out other, in other, out other, in other, gone",
                string.Join(", ", told));
            Assert.AreEqual(0, sensor.WatchedCount);
        }

        [Test]
        public void ASensorSeesItsLayersOnly()
        {
            GameObject root = Make("root", Vector3.zero), own = Box("sensor", Vector3.zero);
            GameObject other = Box("other", Vector3.zero, root);
            ProximitySensor sensor = Sensor(own, root);
            foreach (int layer in new[] { 0, 5, 31 })
            {
                other.layer = layer;
                sensor.Layers = ~(1 << layer);
                sensor.Sense();
                Assert.AreEqual(0, sensor.Near.Count);
                sensor.Layers = 1 << layer;
                sensor.Sense();
                Assert.AreEqual(1, sensor.Near.Count);
            }
        }

        [Test]
        public void AStaticObjectIsReadOnceAndAScaledOneAnew()
        {
            GameObject root = Make("root", Vector3.zero), own = Box("sensor", Vector3.zero);
            GameObject wall = Box("wall", new Vector3(1.5f, 0, 0), root), ball = Box("b", new Vector3(-9, 0, 0), root);
            wall.isStatic = true;
            ProximitySensor sensor = Sensor(own, root);
            sensor.Sense();
            wall.transform.localPosition = new Vector3(9, 0, 0);
            ball.transform.localScale = Vector3.one * 16;
            sensor.Sense();
            Assert.AreEqual(2, sensor.Near.Count);
            own.transform.localScale = Vector3.one * 0.1f;
            own.transform.localPosition = new Vector3(20, 0, 0);
            sensor.Sense();
            Assert.AreEqual(0, sensor.Near.Count);
        }

        [Test]
        public void ASensorWatchesWhatItIsGiven()
        {
            GameObject root = Make("root", Vector3.zero), own = Box("sensor", Vector3.zero);
            GameObject other = Box("other", Vector3.zero);
            ProximitySensor sensor = Sensor(own, root);
            var collider = other.GetComponent<BoxCollider>();
            Assert.IsTrue(sensor.Watch(collider));
            Assert.IsFalse(sensor.Watch(collider));
            Assert.IsFalse(sensor.Watch(own.GetComponent<BoxCollider>()));
            Assert.Throws<ArgumentNullException>(() => sensor.Watch(null));
            sensor.Sense();
            Assert.AreEqual(1, sensor.Near.Count);
            Assert.IsTrue(sensor.Unwatch(collider));
            Assert.IsFalse(sensor.Unwatch(collider));
            sensor.Sense();
            Assert.AreEqual(0, sensor.Near.Count);
        }

        [Test]
        public void WhatIsRefusedIsLeftOutUntilItIsSwitchedOffAndOn()
        {
            GameObject root = Make("root", Vector3.zero), own = Box("sensor", Vector3.zero);
            GameObject other = Make("other", Vector3.zero, root);
            var collider = other.AddComponent<MeshCollider>();
            ProximitySensor sensor = Sensor(own, root);
            sensor.Sense();
            Assert.AreEqual(0, sensor.Near.Count);
            collider.sharedMesh = TestMeshes.Roof(-0.25f);
            sensor.Sense();
            Assert.AreEqual(0, sensor.Near.Count);
            collider.enabled = false;
            sensor.Sense();
            collider.enabled = true;
            sensor.Sense();
            Assert.AreEqual(1, sensor.Near.Count);
        }

        [Test]
        public void ADisabledDistanceHasNoResult()
        {
            GameObject box = Box("box", Vector3.zero), other = Box("other", new Vector3(3, 0, 0));
            var component = box.AddComponent<ConvexDistance>();
            component.Target = other;
            Assert.IsTrue(component.Measure().isValid);
            UnityEngine.Object.DestroyImmediate(component);
            Assert.IsFalse(component.Result.isValid);
        }

        /// <summary>An object is all its colliders, and a Rigidbody those of its children, too.</summary>
        [Test]
        public void AllCollidersOfAnObjectAreMeasured()
        {
            GameObject far = Box("far", new Vector3(10, 0, 0)), two = Box("two", Vector3.zero);
            two.AddComponent<SphereCollider>().center = new Vector3(3, 0, 0);
            Assert.AreEqual(6, GjkPhysics.Distance(two, far).distance, 1e-6);
            GameObject child = Box("child", new Vector3(5, 0, 0), two);
            Assert.AreEqual(6, GjkPhysics.Distance(two, far).distance, 1e-6);
            two.AddComponent<Rigidbody>();
            Assert.AreEqual(4, GjkPhysics.Distance(two, far).distance, 1e-6);
            Assert.AreEqual(4, GjkPhysics.Distance(far, two).distance, 1e-6);
            child.GetComponent<BoxCollider>().isTrigger = true;
            Assert.AreEqual(6, GjkPhysics.Distance(two, far).distance, 1e-6);
            Assert.AreEqual(4, GjkPhysics.Distance(two, far, withTriggers: true).distance, 1e-6);
            child.GetComponent<BoxCollider>().isTrigger = false;
            child.AddComponent<Rigidbody>();
            Assert.AreEqual(6, GjkPhysics.Distance(two, far).distance, 1e-6);
            two.GetComponent<SphereCollider>().enabled = false;
            Assert.AreEqual(9, GjkPhysics.Distance(two, far).distance, 1e-6);
            far.transform.localPosition = new Vector3(0.75f, 0, 0);
            ColliderDistance3D deep = GjkPhysics.Distance(two, far);
            Assert.IsTrue(deep.isOverlapped);
            Assert.AreEqual(-0.25, deep.distance, 1e-6);
        }

        /// <summary>A wheel has no shape; the car has. The wheel is told of once.</summary>
        [Test]
        public void WhatNeverHasAShapeIsLeftOutBesideOthers()
        {
            GameObject car = Box("car", Vector3.zero), other = Box("other", new Vector3(3, 0, 0));
            car.AddComponent<WheelCollider>();
            car.AddComponent<WheelCollider>();
            var component = car.AddComponent<ConvexDistance>();
            component.Target = other;
            for (int i = 0; i < 3; i++) Assert.AreEqual(2, component.Measure().distance, 1e-6);
            Assert.IsTrue(component.Problem == null);

            var wheel = Make("wheel", Vector3.zero).AddComponent<WheelCollider>();
            string message = Assert.Throws<ArgumentException>(
                () => GjkPhysics.Distance(wheel.gameObject, other)).Message;
            StringAssert.Contains("'wheel' (WheelCollider) is a WheelCollider, which has no shape", message);
        }

        [Test]
        public void ASensorLeavesItsOwnChildrenOutAndTriggersUnlessAsked()
        {
            GameObject root = Make("root", Vector3.zero), own = Box("sensor", Vector3.zero, root);
            Box("hand", new Vector3(1, 0, 0), own);
            GameObject trigger = Box("trigger", new Vector3(1, 0, 0), root);
            trigger.GetComponent<BoxCollider>().isTrigger = true;
            ProximitySensor sensor = Sensor(own, root);
            Assert.AreEqual(1, sensor.WatchedCount);
            sensor.Sense();
            Assert.AreEqual(0, sensor.Near.Count);
            sensor.IncludeTriggers = true;
            sensor.Sense();
            Assert.AreEqual(1, sensor.Near.Count);
        }

        /// <summary>Two shapes of the sensor find one collider: once, at the nearer distance.</summary>
        [Test]
        public void ASensorOfTwoShapesFindsAColliderOnce()
        {
            GameObject root = Make("root", Vector3.zero), own = Box("sensor", Vector3.zero);
            own.AddComponent<SphereCollider>().center = new Vector3(1, 0, 0);
            Box("one", new Vector3(2.25f, 0, 0), root);
            Box("two", new Vector3(0, 1.25f, 0), root);
            ProximitySensor sensor = Sensor(own, root);
            sensor.Radius = 2;
            sensor.Sense();
            Assert.AreEqual(2, sensor.Near.Count);
            foreach (ProximityHit hit in sensor.Near) Assert.AreEqual(0.25, hit.Distance.distance, 1e-6);
        }

        private GameObject Make(string name, Vector3 position, GameObject parent = null)
        {
            var made = new GameObject(name);
            if (parent != null) made.transform.SetParent(parent.transform, false);
            made.transform.localPosition = position;
            _made.Add(made);
            return made;
        }

        private GameObject Box(string name, Vector3 position, GameObject parent = null)
        {
            GameObject made = Make(name, position, parent);
            made.AddComponent<BoxCollider>();
            return made;
        }

        private static ProximitySensor Sensor(GameObject owner, GameObject root)
        {
            var sensor = owner.AddComponent<ProximitySensor>();
            foreach (Collider found in UnityEngine.Object.FindObjectsOfType<Collider>()) sensor.Unwatch(found);
            sensor.Root = root;
            sensor.Rescan();
            return sensor;
        }
    }
}
