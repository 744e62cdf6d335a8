using System;
using System.IO;

namespace Gjk.Demo.Output;

/// <summary>
/// A file that appears whole or not at all: written beside its target under another name, and renamed at the end. Created before the work
/// starts, so that a target that cannot be written is refused then.
/// </summary>
internal sealed class AtomicFile : IDisposable
{
    private readonly string _name;
    private readonly string _target;
    private readonly string? _temporary;
    private readonly FileStream _stream;
    private bool _closed;

    /// <summary>Opens the temporary file.</summary>
    /// <param name="name">The target as the user named it; an existing file is replaced by <see cref="Commit"/>, a link is followed.</param>
    /// <exception cref="RefusedException">It cannot be written there.</exception>
    public AtomicFile(string name)
    {
        _name = name;
        try
        {
            string full = Path.GetFullPath(name);
            _target = IsDevice(full) ? full : FollowLinks(new FileInfo(full));
            if (Directory.Exists(_target) || Path.EndsInDirectorySeparator(_target)) throw new IOException("it is a directory");
            _temporary = IsDevice(_target) ? null : $"{_target}.{Guid.NewGuid():N}.tmp";
            _stream = new FileStream(_temporary ?? _target, _temporary is null ? FileMode.Open : FileMode.CreateNew, FileAccess.Write);
        }
        catch (Exception e) when (RefusedException.IsFileTrouble(e))
        {
            throw new RefusedException(name, "cannot be written", e);
        }
    }

    public Stream Stream => _stream;

    /// <summary>Makes what was written the target.</summary>
    /// <exception cref="RefusedException">The last bytes or the rename failed; the temporary file is removed.</exception>
    public void Commit()
    {
        try
        {
            _stream.Dispose();
            if (_temporary is not null) File.Move(_temporary, _target, overwrite: true);
            _closed = true;
        }
        catch (Exception e) when (RefusedException.IsFileTrouble(e))
        {
            throw new RefusedException(_name, "cannot be written", e);
        }
    }

    /// <summary>Removes the temporary file unless it was committed.</summary>
    public void Dispose()
    {
        if (_closed) return;
        _closed = true;
        try
        {
            _stream.Dispose();
        }
        catch (IOException)
        {
            // The bytes are to be thrown away, so it does not matter that they cannot be flushed.
        }

        if (_temporary is not null) File.Delete(_temporary);
    }

    private static string FollowLinks(FileInfo file) =>
        file.LinkTarget is null ? file.FullName : file.ResolveLinkTarget(returnFinalTarget: true)!.FullName;

    /// <summary>Renaming a file over a device such as /dev/null would replace the device.</summary>
    private static bool IsDevice(string path) => !OperatingSystem.IsWindows() && path.StartsWith("/dev/", StringComparison.Ordinal);
}
