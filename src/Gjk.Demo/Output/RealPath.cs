namespace Gjk.Demo.Output;

/// <summary>Resolves all links of a path in the order of the operating system. Each link is replaced by its destination
/// before a following ".." is applied.</summary>
internal static class RealPath
{
    /// <summary>The most links that are followed. Linux has the same limit.</summary>
    private const int MostLinks = 40;

    /// <summary>The path of the file that is reached or created when <paramref name="path"/> is opened for
    /// writing.</summary>
    /// <param name="path">Absolute, or relative to the working directory. Parts that do not exist are kept
    /// unchanged.</param>
    /// <exception cref="IOException">The links form a circle.</exception>
    public static string Of(string path)
    {
        char[] separators = [Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar];
        string rooted = Path.IsPathFullyQualified(path) ? path : Path.Combine(FullPath.Of("."), path);
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
