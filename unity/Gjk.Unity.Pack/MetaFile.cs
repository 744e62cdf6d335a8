using System.IO;

namespace Gjk.Unity.Pack;

/// <summary>The text of a .meta file, as an Editor writes it for the kind of asset.</summary>
public static class MetaFile
{
    private const string Head = "fileFormatVersion: 2\nguid: ";

    private const string Tail = "  userData: \n  assetBundleName: \n  assetBundleVariant: \n";

    /// <summary>Any platform, found by scripts without an assembly definition too, not preloaded.</summary>
    private const string Plugin =
        "  serializedVersion: 2\n  iconMap: {}\n  executionOrder: {}\n  defineConstraints: []\n  isPreloaded: 0\n"
        + "  isOverridable: 0\n  isExplicitlyReferenced: 0\n  validateReferences: 1\n  platformData:\n"
        + "  - first:\n      Any: \n    second:\n      enabled: 1\n      settings: {}\n"
        + "  - first:\n      Editor: Editor\n    second:\n      enabled: 0\n      settings:\n"
        + "        DefaultValueInitialized: true\n"
        + "  - first:\n      Windows Store Apps: WindowsStoreApps\n    second:\n      enabled: 0\n      settings:\n"
        + "        CPU: AnyCPU\n";

    private const string Script =
        "  serializedVersion: 2\n  defaultReferences: []\n  executionOrder: 0\n  icon: {instanceID: 0}\n";

    public static string Text(string path, bool isFolder, string guid)
    {
        if (isFolder) return $"{Head}{guid}\nfolderAsset: yes\n{Importer("DefaultImporter")}";
        if (path == "package.json") return $"{Head}{guid}\n{Importer("PackageManifestImporter")}";
        return $"{Head}{guid}\n" + Path.GetExtension(path) switch
        {
            ".cs" => Importer("MonoImporter", Script),
            ".dll" => Importer("PluginImporter", Plugin),
            ".asmdef" => Importer("AssemblyDefinitionImporter"),
            ".unity" => Importer("DefaultImporter"),
            _ => Importer("TextScriptImporter"),
        };
    }

    private static string Importer(string name, string settings = "") =>
        $"{name}:\n  externalObjects: {{}}\n{settings}{Tail}";
}
