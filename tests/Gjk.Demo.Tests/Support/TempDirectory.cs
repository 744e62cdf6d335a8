namespace Gjk.Demo.Tests.Support;

/// <summary>An empty directory that is removed after the test.</summary>
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

    /// <summary>The contents of each file, by its name. A link has the contents of the file that it leads to. Anything
    /// else has none.</summary>
    public Dictionary<string, string> Contents()
    {
        static string Text(string file)
        {
            var info = new FileInfo(file);
            return info.Exists && info.Length > 0 ? System.IO.File.ReadAllText(file) : "";
        }

        return Files.ToDictionary(f => System.IO.Path.GetFileName(f), Text);
    }

    public void Dispose() => Directory.Delete(Path, recursive: true);
}
