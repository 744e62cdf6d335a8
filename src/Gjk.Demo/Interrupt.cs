using System.Runtime.InteropServices;

namespace Gjk.Demo;

/// <summary>Handles Ctrl-C, a request to terminate, and a terminal that closes. The first signal asks the command to
/// stop, to finish its output and to end with <see cref="ExitCode.Cancelled"/>. A second signal ends the process at
/// once.</summary>
internal sealed class Interrupt : IDisposable
{
    private readonly CancellationTokenSource _source = new();
    private readonly PosixSignalRegistration _interrupt;
    private readonly PosixSignalRegistration _terminate;
    private readonly PosixSignalRegistration _hangUp;
    private bool _isDisposed;

    public Interrupt()
    {
        _interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, OnSignal);
        _terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, OnSignal);
        _hangUp = PosixSignalRegistration.Create(PosixSignal.SIGHUP, OnSignal);
    }

    public CancellationToken Token => _source.Token;

    public void Dispose()
    {
        _interrupt.Dispose();
        _terminate.Dispose();
        _hangUp.Dispose();
        lock (_source)
        {
            _isDisposed = true;
            _source.Dispose();
        }
    }

    private void OnSignal(PosixSignalContext context)
    {
        lock (_source)
        {
            // Once the work is done, the process ends at once anyway, with the exit code of the work.
            context.Cancel = _isDisposed || !_source.IsCancellationRequested;
            if (!_isDisposed) _source.Cancel();
        }
    }
}
