namespace Gjk.Demo.Output;

/// <summary>Checks that the files to be written are neither the command's input nor each other. Paths without links are
/// compared, because links and other spellings of a name lead to the same file. A hard link goes unnoticed and does no
/// harm. A file is replaced by a rename, which leaves its other names unchanged.</summary>
internal static class TargetFiles
{
    private const string StandardInputFile = "/dev/stdin", StandardOutputFile = "/dev/stdout";

    /// <param name="input">The file that is read, <see cref="InputFile.StandardInput"/>, or null.</param>
    /// <param name="outputs">The options and the files that they name. A file is null if its option was not
    /// given.</param>
    /// <exception cref="RefusedException">Two of them are the same file, or an output cannot be written.</exception>
    public static void Check(string? input, params (string Option, string? File)[] outputs) =>
        Check(input, "the scene", outputs);

    /// <inheritdoc cref="Check(string?, ValueTuple{string, string?}[])"/>
    /// <param name="input">The file that is read, <see cref="InputFile.StandardInput"/>, or null.</param>
    /// <param name="what">What the input is, for the message.</param>
    /// <param name="outputs">The options and the files that they name.</param>
    public static void Check(string? input, string what, params (string Option, string? File)[] outputs)
    {
        string? source = input == InputFile.StandardInput ? StandardInputFile : input;
        if (!string.IsNullOrEmpty(source)) source = Resolve(source, "cannot be read", RealPath.Of);
        var known = new List<(string Option, string Path)>();
        foreach ((string option, string? file) in outputs)
        {
            if (file is null) continue;
            OutputTarget target = Resolve(file, "cannot be written", OutputTarget.Of);

            // A device or a pipe can be read and written at the same time. A terminal is one example.
            if (!target.IsDevice && !string.IsNullOrEmpty(source) && target.IsAt(source))
                throw new RefusedException($"{file}: {option} would overwrite {what}");
            bool isFile = !OperatingSystem.IsWindows() && !target.IsDevice;
            if (isFile && target.IsAt(RealPath.Of(StandardOutputFile)))
                throw new RefusedException($"{file}: {option} would overwrite standard output");
            foreach ((string other, string path) in known)
            {
                if (target.IsAt(path))
                    throw new RefusedException($"{file}: {option} would overwrite what {other} writes");
            }

            known.Add((option, target.Path));
        }
    }

    /// <exception cref="RefusedException">The name leads nowhere.</exception>
    public static T Resolve<T>(string file, string failed, Func<string, T> resolve)
    {
        try
        {
            return resolve(file);
        }
        catch (Exception e) when (RefusedException.IsFileTrouble(e))
        {
            throw new RefusedException(file, failed, e);
        }
    }
}
