namespace Gjk.Demo.Tests.Support;

/// <summary>Notices that a temporary file was created in a directory, even if it is already gone.</summary>
public sealed class TemporaryFileWatch : IDisposable
{
    private readonly FileSystemWatcher _watcher;
    private volatile bool _hasSeenOne;

    public TemporaryFileWatch(TempDirectory directory)
    {
        _watcher = new FileSystemWatcher(directory.Path);
        _watcher.Created += (_, change) => _hasSeenOne |= change.Name!.EndsWith(".tmp", StringComparison.Ordinal);
        _watcher.EnableRaisingEvents = true;
    }

    public bool HasSeenOne => _hasSeenOne;

    public void Dispose() => _watcher.Dispose();
}
