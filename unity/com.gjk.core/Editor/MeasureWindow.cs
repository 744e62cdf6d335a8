using UnityEditor;
using UnityEngine;

namespace Gjk.Unity.Editor
{
    /// <summary>Measures the two selected objects, in play and outside of it, and draws the line between their closest
    /// points in the scene view.</summary>
    public sealed class MeasureWindow : EditorWindow
    {
        private readonly ShapeSource _first = new ShapeSource(), _second = new ShapeSource();
        private ColliderDistance3D _result;

        /// <summary>Opens the window.</summary>
        [MenuItem("Window/Gjk/Measure Selected")]
        public static void Open() => GetWindow<MeasureWindow>("Measure");

        private void OnEnable() => SceneView.duringSceneGui += DrawInScene;

        private void OnDisable() => SceneView.duringSceneGui -= DrawInScene;

        private void OnInspectorUpdate() => Repaint();

        private void OnGUI()
        {
            GameObject[] selected = Selection.gameObjects;
            _result = default;
            if (selected.Length != 2)
            {
                EditorGUILayout.HelpBox(
                    "Select two objects, each with a collider or a mesh filter.", MessageType.Info);
                return;
            }

            EditorGUILayout.LabelField("A", selected[0].name);
            EditorGUILayout.LabelField("B", selected[1].name);
            bool isReady = _first.Read(selected[0], false, false) & _second.Read(selected[1], false, false);
            if (isReady) _result = _first.DistanceTo(_second);
            ResultFields.Draw(_result, _first.Problem ?? _second.Problem);
        }

        private void DrawInScene(SceneView view)
        {
            if (!_result.isValid) return;
            Handles.color = _result.isOverlapped ? Color.red : Color.white;
            Handles.DrawLine(_result.pointA, _result.pointB);
            Handles.Label((_result.pointA + _result.pointB) * 0.5f, _result.distance.ToString("G6"));
        }
    }
}
