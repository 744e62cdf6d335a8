using UnityEditor;
using UnityEngine;

namespace Gjk.Unity.Editor
{
    /// <summary>Lists what a <see cref="ProximitySensor"/> finds while the game plays.</summary>
    [CustomEditor(typeof(ProximitySensor))]
    public sealed class ProximitySensorEditor : UnityEditor.Editor
    {
        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
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
                EditorGUILayout.LabelField(hit.Source.name, hit.Distance.distance.ToString("G6"));
        }

        /// <inheritdoc/>
        public override bool RequiresConstantRepaint() => Application.isPlaying;
    }
}
