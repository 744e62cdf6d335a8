using System;
using System.IO;

namespace Gjk.Demo;

/// <summary>
/// The input or the arguments are refused. The message is the whole line for the user and says what is wrong, where and
/// why.
/// </summary>
internal sealed class RefusedException : Exception
{
    public RefusedException(string message)
        : base(message)
    {
    }

    /// <summary>A file that cannot be used at all.</summary>
    /// <param name="file">As the user named it.</param>
    /// <param name="failed">What did not work, such as "cannot be read".</param>
    /// <param name="cause">The exception whose message gives the reason.</param>
    public RefusedException(string file, string failed, Exception cause)
        : base($"{file}: {failed}: {Reason(cause)}")
    {
    }

    /// <summary>
    /// True for the exceptions of the file system. It throws them if a path is bad, missing, protected or of the wrong
    /// kind, or if the disk is full.
    /// </summary>
    public static bool IsFileTrouble(Exception e) =>
        e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException
            or System.Security.SecurityException;

    private static string Reason(Exception cause) => cause switch
    {
        FileNotFoundException => "there is no such file",
        DirectoryNotFoundException => "there is no such directory",
        UnauthorizedAccessException => "access is denied, or it is a directory",
        ArgumentOutOfRangeException => "it would be larger than the file system or a limit allows",
        _ => cause.Message,
    };
}
