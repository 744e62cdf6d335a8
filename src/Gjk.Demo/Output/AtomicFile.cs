using System.Threading.Tasks;

namespace Gjk.Demo.Output;

/// <summary>A file that appears as a whole or not at all. It is written under another name beside its target and
/// renamed at the end, so a command that is refused, interrupted or killed leaves the old file as it was. A link to the
/// target stays a link. The new file keeps the permissions of the old one; it belongs to the user who runs the command,
/// and other hard links keep the old content. A device or a pipe has no contents to protect, so it is written to
/// directly.</summary>
internal sealed class AtomicFile : IDisposable
{
    private const UnixFileMode OwnerOnly = UnixFileMode.UserRead | UnixFileMode.UserWrite;

    private const UnixFileMode SpecialBits = UnixFileMode.SetUser | UnixFileMode.SetGroup | UnixFileMode.StickyBit;

    /// <summary>Devices that take everything and have a position like files.</summary>
    private static readonly string[] NullDevices = ["/dev/null", "/dev/full"];

    private readonly string _name;
    private readonly OutputTarget _target;
    private readonly string? _temporary;
    private readonly RefusingStream _stream;
    private readonly CancellationToken _cancel;
    private readonly CancellationTokenRegistration _onCancel;
    private readonly Lock _ending = new();
    private bool _isComplete;
    private bool _isCommitted;

    /// <summary>Opens the temporary file. This happens before the work starts, so that a target that cannot be written
    /// is refused early.</summary>
    /// <param name="name">The target as the user named it.</param>
    /// <param name="cancel">Removes the temporary file at once, whatever the command is doing. The file cannot be
    /// committed after that.</param>
    /// <exception cref="RefusedException">The target cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Cancelled while the pipe had no reader.</exception>
    public AtomicFile(string name, CancellationToken cancel)
    {
        _name = name;
        _cancel = cancel;
        try
        {
            _target = OutputTarget.Of(name);
            if (_target.IsStandardOutput)
            {
                _stream = OutputConsole.OpenStream(cancel);
            }
            else if (_target.Exists && OpenIfStream(_target, cancel) is { } stream)
            {
                _stream = new RefusingStream(name, stream, cancel);
            }
            else
            {
                // The length of this name is fixed, because the target's name may already be as long as the file system
                // allows.
                ReplacesAFile = _target.Exists;
                _temporary = Path.Combine(Path.GetDirectoryName(_target.Path)!, $".gjk-demo.{Guid.NewGuid():N}.tmp");
                _stream = new RefusingStream(name, Create(_temporary, _target), CancellationToken.None);
            }
        }
        catch (Exception e) when (RefusedException.IsFileTrouble(e))
        {
            if (_temporary is not null) TryDelete(_temporary);
            throw new RefusedException(name, "cannot be written", e);
        }

        _onCancel = cancel.Register(OnCancel);
    }

    /// <summary>Refuses a target that could not be written now, and changes nothing. An empty target may be a pipe. It
    /// is not opened, because a pipe's reader would see an end of file.</summary>
    /// <exception cref="RefusedException">The target cannot be written.</exception>
    public static void Check(string name)
    {
        if (!TargetFiles.Resolve(name, "cannot be written", OutputTarget.Of).IsEmpty)
            new AtomicFile(name, CancellationToken.None).Dispose();
    }

    /// <summary>True if <see cref="Commit"/> would replace a file that exists now.</summary>
    public bool ReplacesAFile { get; }

    /// <summary>Takes the content. A write that fails throws <see cref="RefusedException"/>.</summary>
    public Stream Stream => _stream;

    /// <summary>Writes everything to the disk, where a lack of space shows. From here on a cancellation no longer
    /// removes the file. <see cref="Commit"/> calls this itself. A caller that commits several files completes all of
    /// them first.</summary>
    /// <exception cref="RefusedException">The last bytes could not be written.</exception>
    /// <exception cref="OperationCanceledException">Cancelled before the call.</exception>
    public void Complete()
    {
        if (_isComplete) return;
        if (_temporary is not null) _stream.FlushToDisk();
        _stream.Dispose();
        lock (_ending)
        {
            _cancel.ThrowIfCancellationRequested();
            _isComplete = true;
        }
    }

    /// <summary>Puts the written file in the target's place.</summary>
    /// <exception cref="RefusedException">The last bytes could not be written, or the rename failed. The old file
    /// stays.</exception>
    /// <exception cref="OperationCanceledException">Cancelled before the file was complete. The old file
    /// stays.</exception>
    public void Commit()
    {
        Complete();
        try
        {
            if (_temporary is not null) File.Move(_temporary, _target.Path, overwrite: true);
            _isCommitted = true;
        }
        catch (FileNotFoundException)
        {
            const string reason = "its directory or its temporary file was removed meanwhile";
            throw new RefusedException($"{_name}: cannot be written: {reason}");
        }
        catch (Exception e) when (RefusedException.IsFileTrouble(e))
        {
            throw new RefusedException(_name, "cannot be written", e);
        }
    }

    /// <summary>Removes the temporary file unless it was committed.</summary>
    public void Dispose()
    {
        _onCancel.Dispose();
        if (!_isCommitted && _temporary is not null) TryDelete(_temporary);
        try
        {
            _stream.Dispose();
        }
        catch (RefusedException)
        {
            // These bytes are thrown away anyway, so it does not matter that they cannot be flushed.
        }
    }

    /// <summary>Creates the temporary file with the permissions of the target.</summary>
    private static FileStream Create(string file, in OutputTarget target)
    {
        var options = new FileStreamOptions
        {
            Mode = FileMode.CreateNew,
            Access = FileAccess.Write,
            Share = FileShare.Read | FileShare.Delete,
        };
        if (OperatingSystem.IsWindows() || !target.Exists) return new FileStream(file, options);

        // A user who could not read the old file must not be able to read the new one, not even while it is written.
        // The new file may have another owner, so it does not get the special bits.
        options.UnixCreateMode = OwnerOnly;
        var stream = new FileStream(file, options);
        File.SetUnixFileMode(stream.SafeFileHandle, File.GetUnixFileMode(target.Path) & ~SpecialBits);
        return stream;
    }

    /// <summary>Opens the target for writing, which needs the permission that a rename does not need, and returns it if
    /// it is a pipe or a device. This happens on another thread, because opening a pipe waits for its reader and no
    /// signal ends that wait. The stream has no buffer. Closing it therefore writes nothing and cannot wait
    /// either.</summary>
    /// <returns>Null if it is a file with contents of its own.</returns>
    private static FileStream? OpenIfStream(OutputTarget target, CancellationToken cancel)
    {
        const FileShare share = FileShare.ReadWrite | FileShare.Delete;
        FileStream Open() => new(target.Path, FileMode.Open, FileAccess.Write, share, bufferSize: 0);
        Task<FileStream> open = Task.Run(Open, CancellationToken.None);
        Task.WaitAny([open], cancel);
        FileStream stream = open.GetAwaiter().GetResult();
        if (!stream.CanSeek || Array.IndexOf(NullDevices, target.Path) >= 0) return stream;
        stream.Dispose();
        return target.IsDevice ? throw new IOException("it is neither a file nor a stream") : null;
    }

    private static void TryDelete(string file)
    {
        try
        {
            File.Delete(file);
        }
        catch (Exception e) when (RefusedException.IsFileTrouble(e))
        {
            // The directory may be gone, and the file with it.
        }
    }

    /// <summary>Runs on the signal's thread.</summary>
    private void OnCancel()
    {
        lock (_ending)
        {
            if (!_isComplete && _temporary is not null) TryDelete(_temporary);
        }
    }
}
