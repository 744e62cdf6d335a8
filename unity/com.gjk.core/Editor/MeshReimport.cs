using UnityEditor;

namespace Gjk.Unity.Editor
{
    /// <summary>Forgets all hulls when assets were imported: a mesh may be another one under the same name.</summary>
    public sealed class MeshReimport : AssetPostprocessor
    {
        private static void OnPostprocessAllAssets(
            string[] importedAssets, string[] deletedAssets, string[] movedAssets, string[] movedFromAssetPaths)
        {
            if (importedAssets.Length > 0) MeshHulls.Reset();
        }
    }
}
