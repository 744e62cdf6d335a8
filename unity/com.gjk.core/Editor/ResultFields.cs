using UnityEditor;

namespace Gjk.Unity.Editor
{
    /// <summary>A result as labels.</summary>
    internal static class ResultFields
    {
        public static void Draw(in ColliderDistance3D result, string problem)
        {
            if (problem != null)
            {
                EditorGUILayout.HelpBox(problem, MessageType.Warning);
                return;
            }

            if (!result.isValid) return;
            bool isOverlapped = result.isOverlapped;
            string length = (isOverlapped ? -result.distance : result.distance).ToString("G6");
            EditorGUILayout.LabelField(isOverlapped ? "Depth" : "Distance", length);
            EditorGUILayout.LabelField("Normal", result.normal.ToString("F4"));
            EditorGUILayout.LabelField("Point A", result.pointA.ToString("F4"));
            EditorGUILayout.LabelField("Point B", result.pointB.ToString("F4"));
            EditorGUILayout.LabelField("Iterations", result.iterations.ToString());
        }
    }
}
