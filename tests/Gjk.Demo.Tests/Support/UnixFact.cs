namespace Gjk.Demo.Tests.Support;

/// <summary>A test of links, signals, permissions or pipes. Windows does not have these in this form, so the test is
/// skipped there.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class UnixFactAttribute : FactAttribute
{
    public UnixFactAttribute() => Skip = UnixSkip.Reason;
}

/// <summary>As <see cref="UnixFactAttribute"/>, with data.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class UnixTheoryAttribute : TheoryAttribute
{
    public UnixTheoryAttribute() => Skip = UnixSkip.Reason;
}

/// <summary>A test of a feature that only Linux has, such as /dev/shm.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class LinuxFactAttribute : FactAttribute
{
    public LinuxFactAttribute() => Skip = OperatingSystem.IsLinux() ? null : "Only Linux has what this tests.";
}

/// <summary>As <see cref="LinuxFactAttribute"/>, with data.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class LinuxTheoryAttribute : TheoryAttribute
{
    public LinuxTheoryAttribute() => Skip = OperatingSystem.IsLinux() ? null : "Only Linux has what this tests.";
}

/// <summary>A test in which root gives a file to another user.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class RootFactAttribute : FactAttribute
{
    public RootFactAttribute() =>
        Skip = UnixSkip.Reason ?? (Environment.IsPrivilegedProcess ? null : "Only root can give files away.");
}

/// <summary>A test of permissions, which do not restrict root. Root runs <see cref="DemoProcess.ShellAsUser"/> as
/// nobody, with a program that Linux has.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class UserFactAttribute : FactAttribute
{
    public UserFactAttribute() =>
        Skip = UnixSkip.Reason ?? (Environment.IsPrivilegedProcess && !OperatingSystem.IsLinux()
            ? "Permissions do not bind root; run the tests as a user."
            : null);
}

internal static class UnixSkip
{
    public static string? Reason => OperatingSystem.IsWindows() ? "Windows has no such files, links or signals." : null;
}
