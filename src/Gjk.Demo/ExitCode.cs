namespace Gjk.Demo;

/// <summary>The exit codes of the process.</summary>
internal static class ExitCode
{
    public const int Done = 0;

    /// <summary>A check failed, something could not be imported, or an internal error.</summary>
    public const int Failed = 1;

    /// <summary>Bad arguments, bad input, or a file that cannot be read or written.</summary>
    public const int Refused = 2;

    /// <summary>Ended by Ctrl-C. Shells use the same number.</summary>
    public const int Cancelled = 130;
}
