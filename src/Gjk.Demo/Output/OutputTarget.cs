namespace Gjk.Demo.Output;

/// <summary>The target of an output: the file that its name leads to, and what is there now.</summary>
/// <param name="Path">The path without links. Replacing the file then leaves a link to it in place.</param>
/// <param name="Status">What is there now.</param>
/// <param name="IsStandardOutput">True if the name means this process's own standard output. Writing then continues at
/// its current position.</param>
internal readonly record struct OutputTarget(string Path, FileStatus Status, bool IsStandardOutput)
{
    private static readonly string[] StandardOutputNames = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

    /// <param name="name">As the user wrote it.</param>
    /// <exception cref="IOException">The name leads to nothing that can be written.</exception>
    /// <exception cref="ArgumentException">The name is not a path.</exception>
    public static OutputTarget Of(string name)
    {
        string full = FullPath.Of(name);
        if (!OperatingSystem.IsWindows() && Array.IndexOf(StandardOutputNames, full) >= 0)
            return new OutputTarget(full, FileStatus.Of(full), true);

        // On Unix ".." leads to the parent of the directory that a link before it points to. The full path does not
        // show that.
        FileStatus status = FileStatus.Of(OperatingSystem.IsWindows() ? full : name);
        if (status.Kind == FileKind.Directory || System.IO.Path.EndsInDirectorySeparator(name))
            throw new IOException("it is a directory");
        if (status.Kind == FileKind.Other) throw new IOException("it is neither a file nor a stream");
        string real = RealPath.Of(name);
        if (FileStatus.Of(real) == status) return new OutputTarget(real, status, false);

        // Links such as /dev/fd/3 name an open file, not a path. A pipe can be opened through them, but a file cannot
        // be replaced.
        if (status.Kind == FileKind.Stream) return new OutputTarget(full, status, false);
        throw new IOException("its path cannot be found");
    }
}
