using System.Threading.Tasks;

namespace Gjk.Demo.Output;

/// <summary>An output whose failures are refusals that name the output. They cannot be mistaken for an error in the
/// code that writes. A cancelled command does not wait for a slow reader.</summary>
internal sealed class RefusingStream : WriteOnlyStream
{
    /// <summary>How long a reader may take to accept the last output of a cancelled command.</summary>
    private static readonly TimeSpan Grace = TimeSpan.FromSeconds(1);

    private readonly string _name;
    private readonly Stream _inner;
    private readonly CancellationToken _cancel;

    /// <param name="name">The name that the user knows it by.</param>
    /// <param name="inner">The stream to write to. It is closed with this stream.</param>
    /// <param name="cancel">Ends the wait for a reader. A file has no reader and needs none.</param>
    public RefusingStream(string name, Stream inner, CancellationToken cancel)
    {
        _name = name;
        _inner = inner;
        _cancel = cancel;
    }

    /// <exception cref="OperationCanceledException">Cancelled before the reader took the bytes.</exception>
    public override void Write(ReadOnlySpan<byte> buffer)
    {
        try
        {
            if (_cancel.CanBeCanceled) WriteWhileNotCancelled(buffer.ToArray());
            else _inner.Write(buffer);
        }
        catch (Exception e) when (RefusedException.IsFileTrouble(e))
        {
            throw new RefusedException(_name, "cannot be written", e);
        }
    }

    public override void Flush() => Try(_inner.Flush);

    /// <summary>Writes the contents of a file to its disk. A lack of space may only show at this point.</summary>
    public void FlushToDisk()
    {
        if (_inner is FileStream file) Try(() => file.Flush(flushToDisk: true));
        else Flush();
    }

    /// <summary>Writes what is left in a buffer. If that fails, it throws <see cref="RefusedException"/>.</summary>
    protected override void Dispose(bool disposing)
    {
        if (disposing) Try(_inner.Dispose);
        base.Dispose(disposing);
    }

    /// <summary>Writes on another thread, because no signal ends a blocked write. The process can then end while that
    /// thread is still blocked.</summary>
    private void WriteWhileNotCancelled(byte[] bytes)
    {
        var write = Task.Run(() => _inner.Write(bytes), CancellationToken.None);
        try
        {
            Task.WaitAny([write], _cancel);
        }
        catch (OperationCanceledException)
        {
            if (Task.WaitAny([write], Grace) < 0) throw;
        }

        write.GetAwaiter().GetResult();
    }

    private void Try(Action action)
    {
        try
        {
            action();
        }
        catch (Exception e) when (RefusedException.IsFileTrouble(e))
        {
            throw new RefusedException(_name, "cannot be written", e);
        }
    }
}
