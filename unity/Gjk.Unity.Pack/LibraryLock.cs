using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;

namespace Gjk.Unity.Pack;

/// <summary>Which build of the library lies in the package: the hashes of its files, and of the sources that they were
/// built from.</summary>
/// <remarks>A Git URL installs what is in the repository, so the DLL must be in it. It is not built anew for every
/// change: it may be behind the sources between releases, and this says whether it is. At a release it must
/// not.</remarks>
public static class LibraryLock
{
    private const string SourcesLabel = "sources";

    private static readonly string[] SharedInputs = ["Directory.Build.props", "Directory.Packages.props"];

    /// <summary>What the lock has to say for the files and sources as they are now.</summary>
    public static string Text(Layout layout, string folder) =>
        string.Concat(Layout.Library.Select(f => $"{HashOf(Path.Combine(folder, f))} {f}\n"))
        + $"{SourcesHash(layout)} {SourcesLabel}\n";

    /// <summary>Whether the package's files are those that the lock names.</summary>
    public static bool NamesThePackagesFiles(Layout layout)
    {
        Dictionary<string, string> named = Read(layout);
        return Layout.Library.All(f => named.GetValueOrDefault(f) == HashOf(Path.Combine(layout.Plugins, f)));
    }

    /// <summary>Whether the package's DLL was built from the sources as they are now.</summary>
    public static bool IsCurrent(Layout layout) =>
        Read(layout).GetValueOrDefault(SourcesLabel) == SourcesHash(layout);

    /// <summary>Of all files that decide what the library's build is, with their paths; line ends do not
    /// count.</summary>
    public static string SourcesHash(Layout layout)
    {
        string library = Path.Combine(layout.Root, "src", "Gjk.Core");
        IEnumerable<string> inputs = Directory.EnumerateFiles(library, "*.cs*", SearchOption.AllDirectories)
            .Concat(SharedInputs.Select(f => Path.Combine(layout.Root, f)))
            .Select(f => Path.GetRelativePath(layout.Root, f).Replace('\\', '/'))
            .Where(f => !f.Split('/').Any(part => part is "obj" or "bin"))
            .Order(StringComparer.Ordinal);
        using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        foreach (string input in inputs)
        {
            string text = File.ReadAllText(Path.Combine(layout.Root, input)).ReplaceLineEndings("\n");
            hash.AppendData(Encoding.UTF8.GetBytes($"{input}\n{text}\n"));
        }

        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }

    private static string HashOf(string file) => Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(file)));

    private static Dictionary<string, string> Read(Layout layout) =>
        !File.Exists(layout.LockFile)
            ? []
            : File.ReadAllLines(layout.LockFile).Select(l => l.Split(' ')).ToDictionary(p => p[1], p => p[0]);
}
