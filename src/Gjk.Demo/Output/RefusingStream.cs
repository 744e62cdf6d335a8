using System;
using System.IO;
using System.Threading;
using System.Threading.Tasks;

namespace Gjk.Demo.Output;

/// <summary>
/// An output whose failures are refusals that name it, and so cannot be taken for an error of the code that writes. If
/// its reader is slow, a cancelled command does not wait for it.
/// </summary>
internal sealed class RefusingStream : WriteOnlyStream
{
    /// <summary>A reader that is there has this long to take what a cancelled command still has to say.</summary>
    private static readonly TimeSpan Grace = TimeSpan.FromSeconds(1);

    private readonly string _name;
    private readonly Stream _inner;
    private readonly CancellationToken _cancel;

    /// <param name="name">What the user calls it.</param>
    /// <param name="inner">Is closed with this stream.</param>
    /// <param name="cancel">Ends the wait for a reader; none for a file, which has no reader to wait for.</param>
    public RefusingStream(string name, Stream inner, CancellationToken cancel)
    {
        _name = name;
        _inner = inner;
        _cancel = cancel;
    }

    /// <exception cref="OperationCanceledException">Cancelled, and the reader did not take it.</exception>
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

    /// <summary>Brings what was written to a file to its disk, where a lack of room may show only now.</summary>
    public void FlushToDisk()
    {
        if (_inner is FileStream file) Try(() => file.Flush(flushToDisk: true));
        else Flush();
    }

    /// <summary>Writes what is still in a buffer; <see cref="RefusedException"/> if that fails.</summary>
    protected override void Dispose(bool disposing)
    {
        if (disposing) Try(_inner.Dispose);
        base.Dispose(disposing);
    }

    /// <summary>
    /// No signal ends a blocked write; so another thread is blocked, and the process ends without it.
    /// </summary>
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
