namespace Gjk.Demo.Output;

/// <summary>The target of an output: what its name leads to.</summary>
/// <param name="Path">The path without links. Replacing the file then leaves a link to it in place.</param>
/// <param name="IsStandardOutput">True if the name means this process's own standard output. Writing then continues at
/// its current position.</param>
internal readonly record struct OutputTarget(string Path, bool IsStandardOutput)
{
    /// <summary>The beginning of every device path on Windows, as <see cref="System.IO.Path.GetFullPath(string)"/>
    /// writes it.</summary>
    private const string WindowsDevice = @"\\.\";

    private const UnixFileMode AnyWrite = UnixFileMode.UserWrite | UnixFileMode.GroupWrite | UnixFileMode.OtherWrite;

    private static readonly string[] StandardOutputNames = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

    private static readonly StringComparison ByName = OperatingSystem.IsWindows() || OperatingSystem.IsMacOS()
        ? StringComparison.OrdinalIgnoreCase
        : StringComparison.Ordinal;

    /// <summary>A file, a pipe or a device is there.</summary>
    public bool Exists => File.Exists(Path);

    /// <summary>The path is one of a device. /dev/shm holds files.</summary>
    public bool IsDevice => IsStandardOutput || IsDevicePath(Path);

    /// <summary>True if the file is empty. A pipe and a device are empty, too.</summary>
    public bool IsEmpty => new FileInfo(Path) is { Exists: true, Length: 0 };

    /// <param name="name">As the user wrote it.</param>
    /// <exception cref="IOException">The name leads to nothing that can be written.</exception>
    /// <exception cref="ArgumentException">The name is not a path.</exception>
    public static OutputTarget Of(string name)
    {
        string full = FullPath.Of(name);
        if (!OperatingSystem.IsWindows() && Array.IndexOf(StandardOutputNames, full) >= 0)
            return new OutputTarget(full, true);
        string real = RealPath.Of(name);
        if (Directory.Exists(real) || System.IO.Path.EndsInDirectorySeparator(name))
            throw new IOException("it is a directory");

        // Links such as /dev/fd/3 name an open pipe, which has no path.
        if (IsDevicePath(full) && (OperatingSystem.IsWindows() || !File.Exists(real)))
            return new OutputTarget(full, false);

        // A rename needs no permission to write the file that it replaces. Root may write everything, but a file that
        // nobody may write is refused to root as well.
        bool isProtected = !OperatingSystem.IsWindows() && File.Exists(real)
            && (File.GetUnixFileMode(real) & AnyWrite) == 0;
        if (isProtected) throw new IOException("it is read-only");
        return new OutputTarget(real, false);
    }

    /// <summary>True if the resolved path leads to the same file, or would create the same one.</summary>
    public bool IsAt(string realPath) => string.Equals(Path, realPath, ByName);

    private static bool IsDevicePath(string path) => OperatingSystem.IsWindows()
        ? path.StartsWith(WindowsDevice, StringComparison.Ordinal)
        : path.StartsWith("/dev/", StringComparison.Ordinal) && !path.StartsWith("/dev/shm/", StringComparison.Ordinal);
}
