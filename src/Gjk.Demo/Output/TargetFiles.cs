using System.Collections.Generic;
using System.IO;

namespace Gjk.Demo.Output;

/// <summary>
/// The files to be written must be neither the command's input nor each other. Files are compared, not paths: links,
/// hard links and other spellings of a name lead to the same file. Where the operating system does not tell (see <see
/// cref="NativeFileStatus"/>), paths without links are compared; a hard link that goes unnoticed then does no harm,
/// because a file is replaced by renaming, which leaves its other names as they are.
/// </summary>
internal static class TargetFiles
{
    private const string StandardInputFile = "/dev/stdin", StandardOutputFile = "/dev/stdout";

    /// <param name="input">The file that is read, <see cref="InputFile.StandardInput"/>, or null.</param>
    /// <param name="outputs">The options and the files that they name; null where one was not given.</param>
    /// <exception cref="RefusedException">Two are the same file, or a file to be written cannot be.</exception>
    public static void Check(string? input, params (string Option, string? File)[] outputs)
    {
        string? source = input == InputFile.StandardInput ? StandardInputFile : input;
        if (!string.IsNullOrEmpty(source)) source = Path.GetFullPath(source);
        var known = new List<(string Option, string Path)>();
        foreach ((string option, string? file) in outputs)
        {
            if (file is null) continue;
            OutputTarget target = Resolve(file);

            // A device or a pipe can be read and written at once: a terminal is both.
            if (source is not null && target.Status.Kind != FileKind.Stream && FileStatus.IsSame(source, target.Path))
                throw new RefusedException($"{file}: {option} would overwrite the scene");
            bool isFile = !target.IsStandardOutput && target.Status.Kind == FileKind.Regular;
            if (isFile && FileStatus.IsSame(StandardOutputFile, target.Path))
                throw new RefusedException($"{file}: {option} would overwrite standard output");
            foreach ((string what, string path) in known)
            {
                if (FileStatus.IsSame(path, target.Path))
                    throw new RefusedException($"{file}: {option} would overwrite what {what} writes");
            }

            known.Add((option, target.Path));
        }
    }

    private static OutputTarget Resolve(string file)
    {
        try
        {
            return OutputTarget.Of(file);
        }
        catch (System.Exception e) when (RefusedException.IsFileTrouble(e))
        {
            throw new RefusedException(file, "cannot be written", e);
        }
    }
}
