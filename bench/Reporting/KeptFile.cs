namespace Gjk.Bench.Reporting;

/// <summary>Files that are kept beside the code.</summary>
internal static class KeptFile
{
    /// <summary>Writes a file beside the target first, so that a run that ends early leaves the old file
    /// complete.</summary>
    public static void Write(string path, string text)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!);
        string temporary = path + ".tmp";
        File.WriteAllText(temporary, text);
        File.Move(temporary, path, overwrite: true);
    }
}
