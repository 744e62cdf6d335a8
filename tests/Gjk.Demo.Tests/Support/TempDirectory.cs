using System;
using System.IO;

namespace Gjk.Demo.Tests.Support;

/// <summary>An empty directory that goes with the test.</summary>
public sealed class TempDirectory : IDisposable
{
    public TempDirectory() => Path = Directory.CreateTempSubdirectory("gjk-demo-").FullName;

    public string Path { get; }

    public string[] Files => Directory.GetFileSystemEntries(Path);

    public string File(string name) => System.IO.Path.Combine(Path, name);

    /// <summary>Writes a file and returns its path.</summary>
    public string Write(string name, string text)
    {
        string file = File(name);
        System.IO.File.WriteAllText(file, text);
        return file;
    }

    public void Dispose() => Directory.Delete(Path, recursive: true);
}
