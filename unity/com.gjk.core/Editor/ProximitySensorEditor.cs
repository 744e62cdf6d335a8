using UnityEditor;
using UnityEngine;

namespace Gjk.Unity.Editor
{
    /// <summary>Lists what a <see cref="ProximitySensor"/> finds while the game plays.</summary>
    [CustomEditor(typeof(ProximitySensor))]
    [CanEditMultipleObjects]
    public sealed class ProximitySensorEditor : UnityEditor.Editor
    {
        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            if (targets.Length > 1) return;
            var sensor = (ProximitySensor)target;
            EditorGUILayout.Space();
            if (!Application.isPlaying)
            {
                EditorGUILayout.HelpBox("The sensor looks around while the game plays.", MessageType.Info);
                return;
            }

            if (sensor.Problem != null) EditorGUILayout.HelpBox(sensor.Problem, MessageType.Warning);
            EditorGUILayout.LabelField("Watched", sensor.WatchedCount.ToString());
            EditorGUILayout.LabelField("Near", sensor.Near.Count.ToString());
            foreach (ProximityHit hit in sensor.Near)
            {
                // The list is that of the last frame; what was near may have been destroyed since.
                string name = hit.Source != null ? hit.Source.name : "destroyed";
                EditorGUILayout.LabelField(name, hit.Distance.distance.ToString("G6"));
            }
        }

        /// <inheritdoc/>
        public override bool RequiresConstantRepaint() => Application.isPlaying;
    }
}
