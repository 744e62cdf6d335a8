using System;
using System.Collections.Generic;
using UnityEngine;

namespace UnityEditor
{
    public enum MessageType
    {
        None = 0,
        Info = 1,
        Warning = 2,
        Error = 3,
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class CustomEditor : Attribute
    {
        public CustomEditor(Type inspectedType) => InspectedType = inspectedType;

        internal Type InspectedType { get; }
    }

    [AttributeUsage(AttributeTargets.Class, Inherited = false)]
    public sealed class CanEditMultipleObjects : Attribute
    {
    }

    public class AssetPostprocessor
    {
    }

    [AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
    public sealed class MenuItem : Attribute
    {
        public string menuItem;

        public MenuItem(string itemName) => menuItem = itemName;
    }

    public class Editor : ScriptableObject
    {
        public UnityEngine.Object target
        {
            get => targets.Length > 0 ? targets[0] : null;
            set => targets = new[] { value };
        }

        /// <summary>The engine's has no setter.</summary>
        public UnityEngine.Object[] targets { get; set; } = new UnityEngine.Object[0];

        public virtual void OnInspectorGUI() => DrawDefaultInspector();

        public virtual bool RequiresConstantRepaint() => false;

        public bool DrawDefaultInspector() => false;
    }

    public class EditorWindow : ScriptableObject
    {
        public static T GetWindow<T>(string title) where T : EditorWindow => Activator.CreateInstance<T>();

        public void Repaint()
        {
        }
    }

    public sealed class EditorGUILayout
    {
        public static void Space()
        {
        }

        /// <summary>What was drawn, for tests.</summary>
        public static List<string> Drawn { get; } = new List<string>();

        public static void LabelField(string label, string label2, params GUILayoutOption[] options) =>
            Drawn.Add(label + ": " + label2);

        public static void HelpBox(string message, MessageType type) => Drawn.Add(type + ": " + message);
    }

    public sealed class Selection
    {
        public static GameObject[] gameObjects { get; set; } = new GameObject[0];
    }

    public class SceneView : EditorWindow
    {
        public static event Action<SceneView> duringSceneGui;

        /// <summary>What the engine does when it draws the view.</summary>
        public static void Draw() => duringSceneGui?.Invoke(new SceneView());
    }

    public sealed class Handles
    {
        public static Color color { get; set; }

        public static void DrawLine(Vector3 p1, Vector3 p2)
        {
        }

        public static void Label(Vector3 position, string text)
        {
        }
    }
}
