using UnityEditor;

namespace Gjk.Unity.Editor
{
    /// <summary>Shows what a <see cref="ConvexDistance"/> measures, in play and outside of it.</summary>
    [CustomEditor(typeof(ConvexDistance))]
    [CanEditMultipleObjects]
    public sealed class ConvexDistanceEditor : UnityEditor.Editor
    {
        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            if (targets.Length > 1) return;
            var component = (ConvexDistance)target;
            if (!UnityEngine.Application.isPlaying) component.Measure();
            EditorGUILayout.Space();
            ResultFields.Draw(component.Result, component.Problem);
        }

        /// <inheritdoc/>
        public override bool RequiresConstantRepaint() => true;
    }
}
