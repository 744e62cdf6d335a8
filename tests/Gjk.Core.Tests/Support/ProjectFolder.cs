using System;
using System.IO;

namespace Gjk.Core.Tests.Support;

/// <summary>The project's folder, for tests that read the sources.</summary>
internal static class ProjectFolder
{
    /// <summary>The folder with the solution, above the one that the tests run in.</summary>
    public static string Root { get; } = Find();

    private static string Find()
    {
        string? folder = AppContext.BaseDirectory;
        while (folder is not null && !File.Exists(Path.Combine(folder, "Gjk.sln")))
            folder = Path.GetDirectoryName(folder);
        return folder ?? throw new InvalidOperationException("The tests do not run inside the project's folder.");
    }
}
