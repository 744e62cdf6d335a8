using System;
using System.IO;

namespace Gjk.Demo.Output;

/// <summary>What there is at a path, after all links.</summary>
internal enum FileKind
{
    /// <summary>Nothing, or nothing that can be reached.</summary>
    Missing,

    /// <summary>A file with contents of its own, which can be replaced.</summary>
    Regular,

    Directory,

    /// <summary>A character device such as /dev/null, a pipe or a socket: it passes bytes on and keeps none.</summary>
    Stream,

    /// <summary>A disk, for example: nothing to write results to.</summary>
    Other,
}

/// <summary>What a path leads to.</summary>
/// <param name="Kind">Its kind.</param>
/// <param name="Device">The device that holds it; with <paramref name="Inode"/> the identity of the file.</param>
/// <param name="Inode">Its number there, or 0 where the operating system cannot be asked.</param>
/// <param name="Owner">The user's number, on Unix.</param>
/// <param name="Group">The group's number, on Unix.</param>
/// <param name="Mode">The permissions, on Unix.</param>
internal readonly record struct FileStatus(
    FileKind Kind, ulong Device, ulong Inode, uint Owner, uint Group, UnixFileMode Mode)
{
    /// <summary>
    /// Starts the path of every device on Windows, as <see cref="Path.GetFullPath(string)"/> writes it.
    /// </summary>
    private const string WindowsDevice = @"\\.\";

    /// <summary>Follows links, as opening the path does.</summary>
    public static FileStatus Of(string path)
    {
        if (NativeFileStatus.TryGet(path, out FileStatus status)) return status;
        FileKind kind = FileKind.Missing;
        string devices = OperatingSystem.IsWindows() ? WindowsDevice : "/dev/";
        if (path.StartsWith(devices, StringComparison.Ordinal)) kind = FileKind.Stream;
        else if (System.IO.Directory.Exists(path)) kind = FileKind.Directory;
        else if (File.Exists(path)) kind = FileKind.Regular;
        UnixFileMode mode = UnixFileMode.None;
        if (kind == FileKind.Regular && !OperatingSystem.IsWindows()) mode = File.GetUnixFileMode(path);
        return new FileStatus(kind, 0, 0, 0, 0, mode);
    }

    /// <summary>True if both paths lead to one file, or would create one; false if either is empty.</summary>
    public static bool IsSame(string a, string b)
    {
        if (a.Length == 0 || b.Length == 0) return false;
        FileStatus statusA = Of(a), statusB = Of(b);
        if (statusA.Inode != 0 && statusB.Inode != 0)
            return statusA.Device == statusB.Device && statusA.Inode == statusB.Inode;
        if (statusA.Kind != statusB.Kind) return false;
        bool ignoresCase = OperatingSystem.IsWindows() || OperatingSystem.IsMacOS();
        StringComparison comparison = ignoresCase ? StringComparison.OrdinalIgnoreCase : StringComparison.Ordinal;
        if (string.Equals(a, b, comparison)) return true;

        // Neither exists, or nothing is known but paths. The same name in the same directory will be the same file.
        string? parentA = Path.GetDirectoryName(a), parentB = Path.GetDirectoryName(b);
        bool hasSameName = string.Equals(Path.GetFileName(a), Path.GetFileName(b), comparison);
        return hasSameName && parentA is not null && parentB is not null && IsSame(parentA, parentB);
    }
}
