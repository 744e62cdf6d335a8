using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Gjk.Unity.Tests
{
    /// <summary>The shared scene: what is in it, and what it answers.</summary>
    public class WorldTests
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
        public void WhatIsSpawnedAndDestroyedIsFollowedWithoutAScan()
        {
            GameObject first = Box("first", 3);
            GjkWorld world = World();
            Assert.AreEqual(1, world.Count);
            GameObject later = Box("later", 5);
            later.AddComponent<GjkMember>();
            Assert.AreEqual(2, world.Count);
            world.Add(Box("by hand", 7));
            Assert.AreEqual(3, world.Count);
            UnityEngine.Object.DestroyImmediate(first);
            world.Refresh();
            Assert.AreEqual(2, world.Count);
            UnityEngine.Object.DestroyImmediate(later.GetComponent<GjkMember>());
            Assert.AreEqual(1, world.Count);
        }

        [Test]
        public void OnlyItsLayersBelongToIt()
        {
            GjkWorld world = World();
            world.Layers = 1 << 3;
            GameObject box = Box("box", 0);
            Assert.IsFalse(world.Add(box.GetComponent<BoxCollider>()));
            box.layer = 3;
            Assert.IsTrue(world.Add(box.GetComponent<BoxCollider>()));
            Assert.IsFalse(world.Add(box.GetComponent<BoxCollider>()));
            Assert.IsTrue(world.Remove(box.GetComponent<BoxCollider>()));
            Assert.IsFalse(world.Remove(box.GetComponent<BoxCollider>()));
            Assert.Throws<ArgumentNullException>(() => world.Add((GameObject)null));
            Assert.Throws<ArgumentNullException>(() => world.Add((Component)null));
        }

        /// <summary>Convex and concave shapes alike: boxes at 3 and 6, a dented roof at 9.</summary>
        [Test]
        public void ItAnswersForConvexAndConcaveShapes()
        {
            GameObject own = Box("own", 0), three = Box("three", 3), six = Box("six", 6), nine = Make("nine", 9);
            nine.AddComponent<MeshCollider>().sharedMesh = TestMeshes.Roof(-0.25f);
            GjkWorld world = World();
            var collider = own.GetComponent<BoxCollider>();
            var hits = new ProximityHit[8];
            Assert.AreEqual(1, world.WithinNonAlloc(collider, 4, hits));
            Assert.AreSame(three.GetComponent<BoxCollider>(), hits[0].Source);
            Assert.AreEqual(3, world.WithinNonAlloc(collider, 8, hits));
            Assert.AreEqual(3, world.WithinNonAlloc(collider, float.PositiveInfinity, hits));
            Assert.AreEqual(2, world.WithinNonAlloc(collider, 8, new ProximityHit[2]));
            Assert.AreEqual(0, world.WithinNonAlloc(collider, 8, hits, 1 << 4));
            Assert.IsTrue(world.TryGetNearest(collider, out ProximityHit nearest));
            Assert.AreEqual(2, nearest.Distance.distance, 1e-6);
            Assert.IsTrue(world.TryGetNearest(nine.GetComponent<MeshCollider>(), out nearest));
            Assert.AreSame(six.GetComponent<BoxCollider>(), nearest.Source);
            Assert.IsFalse(world.TryGetNearest(collider, out _, 1));

            Assert.IsTrue(world.Raycast(new Vector3(4, 0, 0), Vector3.right, out ColliderRayHit ray));
            Assert.AreSame(six.GetComponent<BoxCollider>(), ray.collider);
            Assert.AreEqual(1.5, ray.distance, 1e-6);
            Assert.IsTrue(world.Raycast(new Vector3(9, 5, 0), -Vector3.up, out ray));
            Assert.AreSame(nine.GetComponent<MeshCollider>(), ray.collider);
            Assert.AreEqual(4.75, ray.distance, 1e-6);
            Assert.IsTrue(ray.triangleIndex >= 0);
            Assert.IsFalse(world.Raycast(new Vector3(9, 5, 0), -Vector3.up, out _, 4));

            Assert.IsTrue(world.ColliderCast(collider, Vector3.right, out ColliderCastHit cast));
            Assert.AreSame(three.GetComponent<BoxCollider>(), cast.collider);
            Assert.AreEqual(2, cast.distance, 1e-5);
            own.transform.localPosition = new Vector3(9, 5, 0);
            own.transform.localScale = Vector3.one * 0.25f;
            Assert.IsTrue(world.ColliderCast(collider, -Vector3.up, out cast, 100));
            Assert.AreSame(nine.GetComponent<MeshCollider>(), cast.collider);
            Assert.AreEqual(4.875 - 0.3125, cast.distance, 1e-4);
            Assert.IsFalse(world.ColliderCast(collider, -Vector3.up, out _, 4));
        }

        /// <summary>A floor that leads up along x, whose scale counts for nothing.</summary>
        [Test]
        public void AHalfSpaceIsAFloorWithoutAnEnd()
        {
            GameObject box = Box("box", 3), ground = Make("ground", 1);
            ground.transform.localRotation = Quaternion.AngleAxis(-90, Vector3.forward);
            ground.transform.localScale = new Vector3(2, 5, -3);
            var floor = ground.AddComponent<GjkHalfSpace>();
            GjkWorld world = World();
            Assert.AreEqual(2, world.Count);
            var hits = new ProximityHit[2];
            var collider = box.GetComponent<BoxCollider>();
            Assert.AreEqual(1, world.WithinNonAlloc(collider, 2, hits));
            Assert.AreSame(floor, hits[0].Source);
            Assert.AreEqual(1.5, hits[0].Distance.distance, 1e-6);
            Assert.IsTrue(world.Raycast(new Vector3(9, 700, 900), -Vector3.right, out ColliderRayHit ray));
            Assert.AreEqual(8, ray.distance, 1e-6);
            Assert.IsTrue(ray.collider == null);
            Assert.IsTrue(world.ColliderCast(collider, -Vector3.right, out ColliderCastHit cast));
            Assert.AreEqual(1.5, cast.distance, 1e-6);
            Assert.AreEqual(1.5, GjkPhysics.Distance(box, ground).distance, 1e-6);
            box.transform.localPosition = new Vector3(1.25f, 40, 0);
            Assert.AreEqual(-0.25, GjkPhysics.Distance(ground, box).distance, 1e-6);
            Assert.AreEqual(-0.25, GjkPhysics.Distance(
                GjkShapes.From(floor), GjkShapes.From(collider)).distance, 1e-6);
            ground.transform.localPosition = new Vector3(-1, 0, 0);
            world.Refresh();
            Assert.AreEqual(0, world.WithinNonAlloc(collider, 1.5f, hits));
            Assert.AreEqual(1, world.WithinNonAlloc(collider, 2, hits));
            floor.enabled = false;
            world.Refresh();
            Assert.AreEqual(0, world.WithinNonAlloc(collider, 2, hits));
        }

        [Test]
        public void ASpawnedHalfSpaceJoinsAndLeaves()
        {
            GjkWorld world = World();
            GameObject ground = Make("ground", 0);
            ground.AddComponent<GjkHalfSpace>();
            ground.AddComponent<GjkMember>();
            Assert.AreEqual(1, world.Count);
            GameObject other = Make("other", 0);
            other.AddComponent<GjkHalfSpace>();
            Assert.IsFalse(GjkPhysics.Distance(ground, other).isValid);
            UnityEngine.Object.DestroyImmediate(ground.GetComponent<GjkMember>());
            Assert.AreEqual(0, world.Count);
        }

        /// <summary>What moves is read at the first question of a frame.</summary>
        [Test]
        public void SensorsShareAWorld()
        {
            GameObject other = Box("other", 9);
            GjkWorld world = World();
            var sensors = new ProximitySensor[2];
            for (int i = 0; i < 2; i++)
            {
                GameObject owner = Box("sensor " + i, 20 * i);
                owner.SetActive(false);
                sensors[i] = owner.AddComponent<ProximitySensor>();
                sensors[i].World = world;
                owner.SetActive(true);
                sensors[i].Sense();
                Assert.AreEqual(0, sensors[i].Near.Count);
                Assert.AreEqual(1, sensors[i].WatchedCount);
            }

            for (int i = 0; i < 2; i++)
            {
                other.transform.localPosition = new Vector3(20 * i + 1.5f, 0, 0);
                world.Refresh();
                foreach (ProximitySensor sensor in sensors) sensor.Sense();
                Assert.AreEqual(1, sensors[i].Near.Count);
                Assert.AreEqual(0, sensors[1 - i].Near.Count);
            }
        }

        private GjkWorld World() => Make("world", 0).AddComponent<GjkWorld>();

        private GameObject Box(string name, float x)
        {
            GameObject made = Make(name, x);
            made.AddComponent<BoxCollider>();
            return made;
        }

        private GameObject Make(string name, float x)
        {
            var made = new GameObject(name);
            made.transform.localPosition = new Vector3(x, 0, 0);
            _made.Add(made);
            return made;
        }
    }
}
