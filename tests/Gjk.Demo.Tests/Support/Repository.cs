namespace Gjk.Demo.Tests.Support;

/// <summary>The files of the repository that the tests run in.</summary>
public static class Repository
{
    /// <summary>The path of a file or folder.</summary>
    /// <param name="path">From the root of the repository.</param>
    public static string File(string path) => Path.Combine(Root(), path);

    private static string Root()
    {
        string? at = AppContext.BaseDirectory;
        while (at is not null && !System.IO.File.Exists(Path.Combine(at, "Gjk.sln"))) at = Path.GetDirectoryName(at);
        return at ?? throw new DirectoryNotFoundException("The tests do not run inside the repository.");
    }
}
