using System;
using System.Collections.Generic;
using System.IO;

namespace Gjk.Demo.Output;

/// <summary>
/// A path without links, as the operating system walks it: each link is replaced by where it points before ".." is
/// applied.
/// </summary>
internal static class RealPath
{
    /// <summary>Links. Linux follows as many before it gives up.</summary>
    private const int MostLinks = 40;

    /// <summary>The path of the file that opening <paramref name="path"/> for writing reaches or creates.</summary>
    /// <param name="path">Absolute, or relative to the working directory. Parts that do not exist are kept as they
    /// are.</param>
    /// <exception cref="IOException">The links form a circle.</exception>
    public static string Of(string path)
    {
        char[] separators = [Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar];
        string rooted = Path.IsPathFullyQualified(path) ? path : Path.Combine(Environment.CurrentDirectory, path);
        string real = Path.GetPathRoot(rooted)!;
        var ahead = new Stack<string>();
        Push(rooted[real.Length..]);
        int links = 0;
        while (ahead.TryPop(out string? part))
        {
            if (part == ".") continue;
            if (part == "..")
            {
                real = Path.GetDirectoryName(real) ?? real;
                continue;
            }

            string next = Path.Combine(real, part);
            string? link = new FileInfo(next).LinkTarget;
            if (link is null)
            {
                real = next;
                continue;
            }

            if (++links > MostLinks) throw new IOException("too many symbolic links");
            string root = Path.GetPathRoot(link) ?? "";
            if (root.Length > 0) real = Path.GetPathRoot(Path.GetFullPath(link, real))!;
            Push(link[root.Length..]);
        }

        return real;

        void Push(string relative)
        {
            string[] parts = relative.Split(separators, StringSplitOptions.RemoveEmptyEntries);
            for (int i = parts.Length - 1; i >= 0; i--) ahead.Push(parts[i]);
        }
    }
}
