using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Gjk.Unity.Pack;

/// <summary>Where things are, given the folder with the solution.</summary>
public sealed class Layout
{
    /// <summary>The package's name, which its GUIDs are derived from. It never changes.</summary>
    public const string PackageName = "com.gjk.core";

    public Layout(string root) => Root = root;

    public string Root { get; }

    public string Package => Path.Combine(Root, "unity", PackageName);

    public string Plugins => Path.Combine(Package, "Runtime", "Plugins");

    public string GuidFile => Path.Combine(Root, "unity", "guids.txt");

    public string LockFile => Path.Combine(Root, "unity", "library.lock");

    /// <summary>Where the library's Release build is.</summary>
    public string Build => Path.Combine(Root, "src", "Gjk.Core", "bin", "Release", "netstandard2.1");

    /// <summary>What of the build goes into the package.</summary>
    public static IReadOnlyList<string> Library { get; } = ["Gjk.Core.dll", "Gjk.Core.xml"];

    /// <summary>The folder with the solution, at or above another one.</summary>
    public static Layout Above(string? folder)
    {
        while (folder is not null && !File.Exists(Path.Combine(folder, "Gjk.sln")))
            folder = Path.GetDirectoryName(folder);
        return folder is null
            ? throw new InvalidOperationException("There is no Gjk.sln here or above.")
            : new Layout(folder);
    }

    /// <summary>Every path of the package that needs a .meta file, with forward slashes, sorted. Unity ignores folders
    /// whose names end in ~; samples are copied into a project with theirs, so that scenes find their
    /// scripts.</summary>
    public IReadOnlyList<string> PathsWithMeta() =>
        [.. Directory.EnumerateFileSystemEntries(Package, "*", SearchOption.AllDirectories)
            .Select(p => Path.GetRelativePath(Package, p).Replace('\\', '/'))
            .Where(NeedsMeta)
            .Order(StringComparer.Ordinal)];

    private static bool NeedsMeta(string path)
    {
        string[] parts = path.Split('/');
        if (path.EndsWith(".meta", StringComparison.Ordinal) || parts.Any(p => p.StartsWith('.'))) return false;
        return parts[0] == "Samples~" ? parts.Length > 2 : !parts.Any(p => p.EndsWith('~'));
    }
}
