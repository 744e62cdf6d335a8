using System.Runtime.InteropServices;

namespace Gjk.Demo.Output;

/// <summary>Asks the operating system what a path leads to. .NET does not tell whether two paths are hard links to one
/// file, or whether a path is a pipe or a device. Only calls with a documented and fixed layout are used: <c>statx</c>
/// on Linux, which has the same fields on every processor, and <c>stat</c> with 64-bit inodes on macOS. On other
/// systems, and where the call is missing, nothing is known and the caller compares resolved paths.</summary>
internal static class NativeFileStatus
{
    /// <summary>AT_FDCWD. Relative paths start at the working directory.</summary>
    private const int AtWorkingDirectory = -100;

    /// <summary>STATX_TYPE, STATX_MODE, STATX_UID, STATX_GID and STATX_INO.</summary>
    private const uint WantedFields = 0x1 | 0x2 | 0x8 | 0x10 | 0x100;

    /// <returns>False if this system cannot be asked. A file that cannot be reached is
    /// <see cref="FileKind.Missing"/>.</returns>
    public static bool TryGet(string path, out FileStatus status)
    {
        status = default;
        try
        {
            if (OperatingSystem.IsLinux())
            {
                if (Statx(AtWorkingDirectory, path, 0, WantedFields, out LinuxStatus linux) != 0) return true;
                ulong device = ((ulong)linux.DeviceMajor << 32) | linux.DeviceMinor;
                status = Make(linux.Mode, device, linux.Inode, linux.Owner, linux.Group);
                return true;
            }

            if (!OperatingSystem.IsMacOS()) return false;
            bool isArm = RuntimeInformation.ProcessArchitecture == Architecture.Arm64;
            if ((isArm ? StatArm(path, out MacStatus mac) : StatIntel(path, out mac)) == 0)
                status = Make(mac.Mode, (uint)mac.Device, mac.Inode, mac.Owner, mac.Group);
            return true;
        }
        catch (Exception e) when (e is EntryPointNotFoundException or DllNotFoundException)
        {
            return false;
        }
    }

    /// <summary>Gives an open file to a user and a group.</summary>
    /// <returns>False if the operating system does not allow it.</returns>
    public static bool TryChangeOwner(SafeHandle file, uint owner, uint group)
    {
        try
        {
            return ChangeOwner(file, owner, group) == 0;
        }
        catch (Exception e) when (e is EntryPointNotFoundException or DllNotFoundException)
        {
            return false;
        }
    }

    private static FileStatus Make(ushort mode, ulong device, ulong inode, uint owner, uint group)
    {
        const int typeBits = 0xF000, permissions = 0xFFF;
        const int fifo = 0x1000, character = 0x2000, directory = 0x4000, regular = 0x8000, socket = 0xC000;
        FileKind kind = (mode & typeBits) switch
        {
            regular => FileKind.Regular,
            directory => FileKind.Directory,
            character or fifo or socket => FileKind.Stream,
            _ => FileKind.Other,
        };
        return new FileStatus(kind, device, inode, owner, group, (System.IO.UnixFileMode)(mode & permissions));
    }

    [DllImport("libc", EntryPoint = "statx")]
    private static extern int Statx(
        int directory, [MarshalAs(UnmanagedType.LPUTF8Str)] string path, int flags, uint mask, out LinuxStatus status);

    [DllImport("libc", EntryPoint = "stat")]
    private static extern int StatArm([MarshalAs(UnmanagedType.LPUTF8Str)] string path, out MacStatus status);

    [DllImport("libc", EntryPoint = "stat$INODE64")]
    private static extern int StatIntel([MarshalAs(UnmanagedType.LPUTF8Str)] string path, out MacStatus status);

    [DllImport("libc", EntryPoint = "fchown")]
    private static extern int ChangeOwner(SafeHandle file, uint owner, uint group);

    /// <summary>struct statx, 256 bytes.</summary>
    [StructLayout(LayoutKind.Explicit, Size = 256)]
    private struct LinuxStatus
    {
        [FieldOffset(20)]
        public uint Owner;

        [FieldOffset(24)]
        public uint Group;

        [FieldOffset(28)]
        public ushort Mode;

        [FieldOffset(32)]
        public ulong Inode;

        [FieldOffset(136)]
        public uint DeviceMajor;

        [FieldOffset(140)]
        public uint DeviceMinor;
    }

    /// <summary>struct stat with 64-bit inodes, 144 bytes.</summary>
    [StructLayout(LayoutKind.Explicit, Size = 144)]
    private struct MacStatus
    {
        [FieldOffset(0)]
        public int Device;

        [FieldOffset(4)]
        public ushort Mode;

        [FieldOffset(8)]
        public ulong Inode;

        [FieldOffset(16)]
        public uint Owner;

        [FieldOffset(20)]
        public uint Group;
    }
}
