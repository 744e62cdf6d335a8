using System;
using System.IO;
using System.Threading;
using Microsoft.Win32.SafeHandles;

namespace Gjk.Demo.Output;

/// <summary>
/// Standard output where it is a pipe. The console's own stream hides that the reader has gone, and work would go on
/// for nobody; here writing fails then.
/// </summary>
internal sealed class PipeStream : WriteOnlyStream
{
    /// <summary>
    /// Bytes. So many are written whole or not at all, even to a pipe that does not wait (PIPE_BUF: 4096 on Linux, 512
    /// elsewhere).
    /// </summary>
    private static readonly int AtomicBytes = OperatingSystem.IsLinux() ? 4096 : 512;

    /// <summary>EAGAIN: a pipe that does not wait is full.</summary>
    private static readonly int TryAgain = OperatingSystem.IsLinux() ? 11 : 35;

    private readonly FileStream _pipe;

    /// <param name="descriptor">The number that Unix gives to the open pipe. It stays open.</param>
    public PipeStream(int descriptor) =>
        _pipe = new FileStream(new SafeFileHandle(descriptor, ownsHandle: false), FileAccess.Write, bufferSize: 0);

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
        }
    }

    public override void Flush()
    {
    }
}
