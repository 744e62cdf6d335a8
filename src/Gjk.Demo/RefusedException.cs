using Gjk.Import;

namespace Gjk.Demo;

/// <summary>The input or the arguments are refused. The message is the whole line for the user and says what is wrong,
/// where and why.</summary>
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
        : base($"{file}: {failed}: {ImportException.Reason(cause)}")
    {
    }

    /// <summary>True for the exceptions of the file system.</summary>
    public static bool IsFileTrouble(Exception e) => ImportException.IsFileTrouble(e);
}
