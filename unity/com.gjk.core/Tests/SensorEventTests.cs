using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Gjk.Unity.Tests
{
    /// <summary>Each enter has one exit, whatever listeners do.</summary>
    public class SensorEventTests
    {
        private readonly List<GameObject> _made = new List<GameObject>();
        private readonly List<string> _told = new List<string>();
        private GameObject _root, _owner;
        private ProximitySensor _sensor;

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
        public void AListenerMayDisableTheSensor()
        {
            Begin();
            _sensor.Entered.AddListener(c => UnityEngine.Object.DestroyImmediate(_sensor));
            _sensor.Sense();
            AssertPaired("in a, out a");
        }

        [Test]
        public void AListenerMayMakeTheSensorLookAgain()
        {
            Begin();
            int calls = 0;
            _sensor.Entered.AddListener(c =>
            {
                // The other one leaves before it was told of.
                if (calls++ > 0) return;
                _root.transform.localPosition = new Vector3(50, 0, 0);
                _sensor.Sense();
            });
            _sensor.Sense();
            AssertPaired("in a, out a");
            _root.transform.localPosition = Vector3.zero;
            _sensor.Sense();
            AssertPaired("in a, out a, in a, in b");
            _sensor.Sense();
            AssertPaired("in a, out a, in a, in b");
        }

        [Test]
        public void AListenerMayThrow()
        {
            Begin();
            _sensor.Entered.AddListener(c => throw new InvalidOperationException());
            _sensor.Exited.AddListener(c => throw new InvalidOperationException());
            _sensor.Sense();
            _sensor.Sense();
            AssertPaired("in a, in b");
            _root.transform.localPosition = new Vector3(50, 0, 0);
            _sensor.Sense();
            _sensor.Sense();
            Assert.AreEqual(4, _told.Count);
        }

        [Test]
        public void AListenerMayDestroyWhatCameNear()
        {
            Begin();
            _sensor.Entered.AddListener(c => UnityEngine.Object.DestroyImmediate(c.gameObject));
            _sensor.Sense();
            _sensor.Sense();
            AssertPaired("in a, in b, gone, gone");
            Assert.AreEqual(0, _sensor.WatchedCount);
        }

        private void AssertPaired(string expected) => Assert.AreEqual(expected, string.Join(", ", _told));

        private void Begin()
        {
            _told.Clear();
            _root = Make("root", null);
            Make("a", _root).AddComponent<BoxCollider>();
            Make("b", _root).AddComponent<BoxCollider>();
            _owner = Make("sensor", null);
            _owner.AddComponent<BoxCollider>();
            _owner.SetActive(false);
            _sensor = _owner.AddComponent<ProximitySensor>();
            _sensor.Root = _root;
            _owner.SetActive(true);
            _sensor.Rescan();
            _sensor.Entered.AddListener(c => _told.Add("in " + c.name));
            _sensor.Exited.AddListener(c => _told.Add(c == null ? "gone" : "out " + c.name));
        }

        private GameObject Make(string name, GameObject parent)
        {
            var made = new GameObject(name);
            if (parent != null) made.transform.SetParent(parent.transform, false);
            _made.Add(made);
            return made;
        }
    }
}
