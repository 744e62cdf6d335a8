namespace Gjk.Import;

/// <summary>What an input may not exceed. Bad input must not be a way to fill the memory.</summary>
internal static class ImportLimits
{
    /// <summary>Bytes of one input file. An array in .NET ends at 2 GB.</summary>
    public const int FileBytes = 1 << 28;

    /// <summary>Prefabs within prefabs. Unity's own projects stay below ten.</summary>
    public const int PrefabDepth = 32;

    /// <summary>Lists and fields within each other in a Unity file.</summary>
    public const int YamlDepth = 256;

    /// <summary>Objects within objects, also of a glTF file.</summary>
    public const int HierarchyDepth = 4096;
}
