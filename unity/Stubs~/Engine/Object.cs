using System;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine
{
    public enum FindObjectsSortMode
    {
        None = 0,
        InstanceID = 1,
    }

    /// <summary>As in the engine, a destroyed object equals null while the reference lives on.</summary>
    public class Object
    {
        private bool _isDestroyed;

        public string name { get; set; } = "";

        public static implicit operator bool(Object exists) => exists != null;

        public static bool operator ==(Object x, Object y)
        {
            bool isXGone = x is null || x._isDestroyed, isYGone = y is null || y._isDestroyed;
            return isXGone || isYGone ? isXGone && isYGone : ReferenceEquals(x, y);
        }

        public static bool operator !=(Object x, Object y) => !(x == y);

        public static void DestroyImmediate(Object obj)
        {
            if (obj is GameObject owner)
            {
                foreach (Transform child in owner.transform.Children) DestroyImmediate(child.gameObject);
                foreach (Component component in owner.Components) component.Destroyed();
                UnityStubs.World.Remove(owner);
            }

            if (obj is MonoBehaviour behaviour) UnityStubs.Messages.Send(behaviour, "OnDisable");
            obj.Destroyed();
        }

        public static void Destroy(Object obj) => DestroyImmediate(obj);

        public static T[] FindObjectsOfType<T>() where T : Object => UnityStubs.World.All<T>();

        public static T[] FindObjectsByType<T>(FindObjectsSortMode sortMode) where T : Object =>
            UnityStubs.World.All<T>();

        /// <summary>Of Unity 6.4 and later.</summary>
        public static T[] FindObjectsByType<T>() where T : Object => UnityStubs.World.All<T>();

        public override bool Equals(object other) => other is Object o ? this == o : other is null && this == null;

        public override int GetHashCode() => System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode(this);

        public override string ToString() => name;

        internal void Destroyed() => _isDestroyed = true;
    }

    public class ScriptableObject : Object
    {
    }

    public class Component : Object
    {
        public GameObject gameObject { get; internal set; }

        public Transform transform => gameObject.transform;

        public T GetComponent<T>() => gameObject.GetComponent<T>();

        public bool TryGetComponent<T>(out T component) => gameObject.TryGetComponent(out component);

        public T[] GetComponentsInChildren<T>() => gameObject.GetComponentsInChildren<T>();

        public T[] GetComponentsInChildren<T>(bool includeInactive) =>
            gameObject.GetComponentsInChildren<T>(includeInactive);

        public void GetComponents<T>(List<T> results) => gameObject.GetComponents(results);
    }

    public class Behaviour : Component
    {
        public bool enabled { get; set; } = true;

        public bool isActiveAndEnabled => enabled && gameObject.activeInHierarchy;
    }

    public class MonoBehaviour : Behaviour
    {
    }

    public sealed class GameObject : Object
    {
        internal readonly List<Component> Components = new List<Component>();
        private bool _isActive = true;

        public GameObject(string name)
        {
            this.name = name;
            transform = (Transform)Add(new Transform());
            UnityStubs.World.Add(this);
        }

        public GameObject()
            : this("New Game Object")
        {
        }

        public Transform transform { get; }

        public int layer { get; set; }

        public bool isStatic { get; set; }

        public bool activeSelf => _isActive;

        public bool activeInHierarchy =>
            _isActive && (transform.parent is null || transform.parent.gameObject.activeInHierarchy);

        public void SetActive(bool value) => _isActive = value;

        public T AddComponent<T>() where T : Component
        {
            var component = (T)Add(Activator.CreateInstance<T>());
            if (component is MonoBehaviour behaviour && activeInHierarchy)
                UnityStubs.Messages.Send(behaviour, "OnEnable");
            return component;
        }

        public T GetComponent<T>()
        {
            TryGetComponent(out T component);
            return component;
        }

        public bool TryGetComponent<T>(out T component)
        {
            foreach (Component candidate in Components)
            {
                if (!(candidate is T found)) continue;
                component = found;
                return true;
            }

            component = default;
            return false;
        }

        public T[] GetComponentsInChildren<T>()
        {
            var found = new List<T>();
            Collect(this, found);
            return found.ToArray();
        }

        public T[] GetComponentsInChildren<T>(bool includeInactive)
        {
            var found = new List<T>();
            Collect(this, found, includeInactive);
            return found.ToArray();
        }

        public void GetComponentsInChildren<T>(List<T> results)
        {
            results.Clear();
            Collect(this, results);
        }

        public void GetComponents<T>(List<T> results)
        {
            results.Clear();
            foreach (Component component in Components)
            {
                if (component is T hit) results.Add(hit);
            }
        }

        private static void Collect<T>(GameObject owner, List<T> found, bool includeInactive = false)
        {
            if (!includeInactive && !owner.activeInHierarchy) return;
            foreach (Component component in owner.Components)
            {
                if (component is T hit) found.Add(hit);
            }

            foreach (Transform child in owner.transform.Children) Collect(child.gameObject, found, includeInactive);
        }

        private Component Add(Component component)
        {
            component.gameObject = this;
            component.name = name;
            Components.Add(component);
            return component;
        }
    }
}

namespace UnityStubs
{
    /// <summary>Calls what the engine calls by name.</summary>
    public static class Messages
    {
        private const BindingFlags Any = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;

        /// <summary>The method as a delegate, so that calling it allocates nothing; null when there is none.</summary>
        public static Action Get(UnityEngine.MonoBehaviour behaviour, string name)
        {
            MethodInfo method = behaviour.GetType().GetMethod(name, Any, null, Type.EmptyTypes, null);
            return method is null ? null : (Action)Delegate.CreateDelegate(typeof(Action), behaviour, method);
        }

        public static void Send(UnityEngine.MonoBehaviour behaviour, string name) => Get(behaviour, name)?.Invoke();
    }

    /// <summary>All game objects there are.</summary>
    public static class World
    {
        private static readonly HashSet<UnityEngine.GameObject> Objects = new HashSet<UnityEngine.GameObject>();

        /// <summary>Forgets all of them: an empty scene.</summary>
        public static void Clear() => Objects.Clear();

        internal static void Add(UnityEngine.GameObject owner) => Objects.Add(owner);

        internal static void Remove(UnityEngine.GameObject owner) => Objects.Remove(owner);

        internal static T[] All<T>() where T : UnityEngine.Object
        {
            var found = new List<T>();
            foreach (UnityEngine.GameObject owner in Objects)
            {
                if (owner == null || !owner.activeInHierarchy) continue;
                foreach (UnityEngine.Component component in owner.Components)
                {
                    if (component is T hit && hit != null) found.Add(hit);
                }
            }

            return found.ToArray();
        }
    }
}
