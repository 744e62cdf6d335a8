namespace Gjk.Demo.Output;

/// <summary>The kinds of things that a path can lead to after all links are followed.</summary>
internal enum FileKind
{
    /// <summary>Nothing is there, or it cannot be reached.</summary>
    Missing,

    /// <summary>A file with contents of its own, which can be replaced.</summary>
    Regular,

    Directory,

    /// <summary>A character device such as /dev/null, a pipe or a socket. It passes bytes on and keeps none.</summary>
    Stream,

    /// <summary>Anything else, a disk for example. Results cannot be written to it.</summary>
    Other,
}

/// <summary>Describes what a path leads to.</summary>
/// <param name="Kind">Its kind.</param>
/// <param name="Device">The device that holds it. Together with <paramref name="Inode"/> it identifies the
/// file.</param>
/// <param name="Inode">Its number on the device, or 0 where the operating system cannot be asked.</param>
/// <param name="Owner">The user's number. Unix only.</param>
/// <param name="Group">The group's number. Unix only.</param>
/// <param name="Mode">The permissions. Unix only.</param>
internal readonly record struct FileStatus(
    FileKind Kind, ulong Device, ulong Inode, uint Owner, uint Group, UnixFileMode Mode)
{
    /// <summary>The beginning of every device path on Windows, as <see cref="Path.GetFullPath(string)"/> writes
    /// it.</summary>
    private const string WindowsDevice = @"\\.\";

    /// <summary>Looks up a path. Links are followed, as they are when the path is opened.</summary>
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

    /// <summary>True if both paths lead to the same file, or would create the same one. False if either path is
    /// empty.</summary>
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

        // Neither file exists, or only the paths are known. The same name in the same directory will be the same file.
        string? parentA = Path.GetDirectoryName(a), parentB = Path.GetDirectoryName(b);
        bool hasSameName = string.Equals(Path.GetFileName(a), Path.GetFileName(b), comparison);
        return hasSameName && parentA is not null && parentB is not null && IsSame(parentA, parentB);
    }
}
