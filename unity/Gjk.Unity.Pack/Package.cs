using System;
using System.Collections.Generic;
using System.Formats.Tar;
using System.IO;
using System.IO.Compression;
using System.Linq;

namespace Gjk.Unity.Pack;

/// <summary>The package in the repository: what is generated in it, and copies of it to give away.</summary>
public static class Package
{
    /// <summary>What the generated files should contain: everything but the library.</summary>
    public static IReadOnlyDictionary<string, string> GeneratedFiles(Layout layout, GuidList guids)
    {
        var files = new Dictionary<string, string>();
        foreach (string path in layout.PathsWithMeta())
        {
            string full = Path.Combine(layout.Package, path);
            files.Add(full + ".meta", MetaFile.Text(path, Directory.Exists(full), guids[path]));
        }

        foreach ((string path, string text) in SampleScenes.All(guids))
            files.Add(Path.Combine(layout.Package, path), text);
        return files;
    }

    /// <summary>Brings the generated files up to date; the library only where its sources have changed since it was
    /// taken, so that nothing is written in vain.</summary>
    /// <returns>What was done, for people to read.</returns>
    public static string Refresh(Layout layout, bool isForced)
    {
        Directory.CreateDirectory(layout.Plugins);
        bool isKept = !isForced && LibraryLock.IsCurrent(layout) && LibraryLock.NamesThePackagesFiles(layout);
        if (!isKept)
        {
            foreach (string file in Layout.Library)
                File.Copy(Path.Combine(layout.Build, file), Path.Combine(layout.Plugins, file), true);
            File.WriteAllText(layout.LockFile, LibraryLock.Text(layout, layout.Plugins));
        }

        // The scenes must exist before the paths are listed.
        foreach (string scene in SampleScenes.Paths) File.AppendAllText(Path.Combine(layout.Package, scene), "");
        GuidList guids = GuidList.Read(layout.GuidFile);
        guids.Update(layout.PathsWithMeta());
        File.WriteAllText(layout.GuidFile, guids.ToString());
        IReadOnlyDictionary<string, string> files = GeneratedFiles(layout, guids);
        foreach ((string path, string text) in files) File.WriteAllText(path, text);
        foreach (string stray in StrayMetas(layout, files)) File.Delete(stray);
        return isKept ? "the library was current" : "took the library from the build";
    }

    /// <summary>The .meta files of paths that are gone.</summary>
    public static IEnumerable<string> StrayMetas(Layout layout, IReadOnlyDictionary<string, string> files) =>
        Directory.EnumerateFiles(layout.Package, "*.meta", SearchOption.AllDirectories)
            .Where(m => !files.ContainsKey(m));

    /// <summary>Writes the package with the build's library: a folder to add from disk, and the tarball that a registry
    /// or the Package Manager takes. The same input gives the same bytes.</summary>
    /// <param name="layout">Where things are.</param>
    /// <param name="version">Of the package.</param>
    /// <param name="target">Where to write.</param>
    /// <param name="repository">The clone's remote, or nothing.</param>
    /// <returns>The tarball.</returns>
    public static string Export(Layout layout, string version, string target, string repository)
    {
        string folder = Path.Combine(target, Layout.PackageName);
        foreach (string file in Files(layout.Package))
        {
            string copy = Path.Combine(folder, file);
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(Path.Combine(layout.Package, file), copy, true);
        }

        foreach (string file in Layout.Library)
            File.Copy(Path.Combine(layout.Build, file), Path.Combine(folder, "Runtime", "Plugins", file), true);
        string manifest = Path.Combine(folder, "package.json");
        File.WriteAllText(manifest, Manifest.Text(File.ReadAllText(manifest), repository, version));
        string tarball = Path.Combine(target, $"{Layout.PackageName}-{version}.tgz");
        using var stream = new GZipStream(File.Create(tarball), CompressionLevel.SmallestSize);
        using var tar = new TarWriter(stream, TarEntryFormat.Ustar);
        foreach (string file in Files(folder))
        {
            using FileStream data = File.OpenRead(Path.Combine(folder, file));
            tar.WriteEntry(new UstarTarEntry(TarEntryType.RegularFile, "package/" + file)
            {
                DataStream = data,
                ModificationTime = DateTimeOffset.UnixEpoch,
                Mode = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead | UnixFileMode.OtherRead,
            });
        }

        return tarball;
    }

    private static string[] Files(string folder) =>
        [.. Directory.EnumerateFiles(folder, "*", SearchOption.AllDirectories)
            .Select(f => Path.GetRelativePath(folder, f).Replace('\\', '/'))
            .Order(StringComparer.Ordinal)];
}
