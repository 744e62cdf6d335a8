namespace Gjk.Demo;

/// <summary>What the process says when it ends.</summary>
internal static class ExitCode
{
    public const int Done = 0;

    /// <summary>A check failed, or an internal error.</summary>
    public const int Failed = 1;

    /// <summary>Bad arguments, bad input, an unreadable or unwritable file.</summary>
    public const int Refused = 2;

    /// <summary>Ctrl-C, with the number that shells use for it.</summary>
    public const int Cancelled = 130;
}
