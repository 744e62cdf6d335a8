using Microsoft.Win32.SafeHandles;

namespace Gjk.Demo.Output;

/// <summary>Standard output if it is a pipe. The console's own stream hides that the reader has gone, so the work would
/// continue without a reader. This stream ends the work instead.</summary>
internal sealed class PipeStream : WriteOnlyStream
{
    /// <summary>Bytes. A pipe takes this many as a whole or not at all, even if it does not wait (PIPE_BUF, 4096 on
    /// Linux and 512 elsewhere).</summary>
    private static readonly int AtomicBytes = OperatingSystem.IsLinux() ? 4096 : 512;

    /// <summary>EPIPE. Nobody reads the pipe any more. The same number on every Unix.</summary>
    private const int NoReader = 32;

    /// <summary>EAGAIN. A pipe that does not wait is full.</summary>
    private static readonly int TryAgain = OperatingSystem.IsLinux() ? 11 : 35;

    private readonly FileStream _pipe;

    private PipeStream(FileStream pipe) => _pipe = pipe;

    /// <summary>The open pipe of a Unix file descriptor, or null if that is not a pipe. It stays open.</summary>
    public static PipeStream? TryOpen(int descriptor)
    {
        var handle = new SafeFileHandle(descriptor, ownsHandle: false);
        var stream = new FileStream(handle, FileAccess.Write, bufferSize: 0);
        return stream.CanSeek ? null : new PipeStream(stream);
    }

    /// <exception cref="ReaderGoneException">Nobody reads the pipe any more.</exception>
    public override void Write(ReadOnlySpan<byte> buffer)
    {
        while (buffer.Length > 0)
        {
            int count = Math.Min(buffer.Length, AtomicBytes);
            try
            {
                _pipe.Write(buffer[..count]);
                buffer = buffer[count..];
            }
            catch (IOException e) when (e.HResult == TryAgain)
            {
                Thread.Sleep(1);
            }
            catch (IOException e) when (e.HResult == NoReader)
            {
                throw new ReaderGoneException();
            }
        }
    }

    public override void Flush()
    {
    }
}

/// <summary>The reader of standard output has seen enough, as <c>head</c> has after ten lines. No mistake of
/// anybody.</summary>
internal sealed class ReaderGoneException : Exception;
