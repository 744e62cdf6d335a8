using System;
using System.IO;

namespace Gjk.Demo.Output;

/// <summary>
/// An output whose failures are refusals that name it, and so cannot be taken for an error of the code that writes.
/// </summary>
internal sealed class RefusingStream : Stream
{
    private readonly string _name;
    private readonly Stream _inner;

    /// <param name="name">What the user calls it.</param>
    /// <param name="inner">Is closed with this stream.</param>
    public RefusingStream(string name, Stream inner)
    {
        _name = name;
        _inner = inner;
    }

    public override bool CanRead => false;

    public override bool CanSeek => false;

    public override bool CanWrite => true;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    public override void Write(ReadOnlySpan<byte> buffer)
    {
        try
        {
            _inner.Write(buffer);
        }
        catch (Exception e) when (RefusedException.IsFileTrouble(e))
        {
            throw new RefusedException(_name, "cannot be written", e);
        }
    }

    public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

    public override void Flush() => Try(_inner.Flush);

    /// <summary>Brings what was written to a file to its disk, where a lack of room may show only now.</summary>
    public void FlushToDisk()
    {
        if (_inner is FileStream file) Try(() => file.Flush(flushToDisk: true));
        else Flush();
    }

    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    /// <summary>Writes what is still in a buffer; <see cref="RefusedException"/> if that fails.</summary>
    protected override void Dispose(bool disposing)
    {
        if (disposing) Try(_inner.Dispose);
        base.Dispose(disposing);
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
