using System;
using System.IO;

namespace Gjk.Demo.Output;

/// <summary>Where an output goes: the file that its name leads to, and what there is now.</summary>
/// <param name="Path">Without links, so that replacing the file leaves a link to it in place.</param>
/// <param name="Status">What is there now.</param>
/// <param name="IsStandardOutput">The name means this process's own standard output, which must go on where it
/// is.</param>
internal readonly record struct OutputTarget(string Path, FileStatus Status, bool IsStandardOutput)
{
    private static readonly string[] StandardOutputNames = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

    /// <param name="name">As the user wrote it.</param>
    /// <exception cref="IOException">It names nothing that can be written to.</exception>
    /// <exception cref="ArgumentException">It is no path.</exception>
    public static OutputTarget Of(string name)
    {
        string full = System.IO.Path.GetFullPath(name);
        if (!OperatingSystem.IsWindows() && Array.IndexOf(StandardOutputNames, full) >= 0)
            return new OutputTarget(full, FileStatus.Of(full), true);

        // On Unix ".." leads to the parent of what a link before it points to, which the full path does not know.
        FileStatus status = FileStatus.Of(OperatingSystem.IsWindows() ? full : name);
        if (status.Kind == FileKind.Directory || System.IO.Path.EndsInDirectorySeparator(name))
            throw new IOException("it is a directory");
        if (status.Kind == FileKind.Other) throw new IOException("it is neither a file nor a stream");
        string real = RealPath.Of(name);
        if (FileStatus.Of(real) == status) return new OutputTarget(real, status, false);

        // Links such as /dev/fd/3 name what is open, not a path. A pipe can be opened through them, but a file cannot
        // be replaced.
        if (status.Kind == FileKind.Stream) return new OutputTarget(full, status, false);
        throw new IOException("its path cannot be found");
    }
}
