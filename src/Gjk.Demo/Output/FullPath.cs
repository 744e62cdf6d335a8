namespace Gjk.Demo.Output;

/// <summary>Makes paths absolute.</summary>
internal static class FullPath
{
    /// <summary>The absolute path of a name that may be relative to the working directory.</summary>
    /// <exception cref="IOException">The working directory was removed.</exception>
    /// <exception cref="System.ArgumentException">The name is not a path.</exception>
    public static string Of(string name)
    {
        try
        {
            return Path.GetFullPath(name);
        }
        catch (FileNotFoundException)
        {
            throw new IOException("the working directory was removed");
        }
    }
}
