namespace Gjk.Import;

/// <summary>A file cannot be used at all. The message is one line that says which file, where in it (the line of a text
/// file, the element of a binary one) and why.</summary>
public sealed class ImportException : Exception
{
    internal ImportException(string message)
        : base(ImportProblem.OneLine(message))
    {
    }

    /// <summary>A file that cannot be read.</summary>
    internal ImportException(string file, Exception cause)
        : base(ImportProblem.OneLine($"{file}: cannot be read: {Reason(cause)}"), cause)
    {
    }

    /// <summary>True for the exceptions of the file system. It throws them if a path is bad, missing, protected or of
    /// the wrong kind, or if the disk is full.</summary>
    internal static bool IsFileTrouble(Exception e) =>
        e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException
            or System.Security.SecurityException;

    /// <summary>Why the file system threw, in words for the user.</summary>
    internal static string Reason(Exception cause) => cause switch
    {
        FileNotFoundException => "there is no such file",
        DirectoryNotFoundException => "there is no such directory",
        UnauthorizedAccessException => "access is denied, or it is a directory",
        ArgumentOutOfRangeException => "it would be larger than the file system or a limit allows",
        _ => cause.Message,
    };
}
