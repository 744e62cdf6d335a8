using System.Diagnostics;
using System.Text;
using System.Threading.Tasks;
using Gjk.Demo.Output;

namespace Gjk.Demo.Tests.Support;

/// <summary>The demo on a thread of this process, with streams of its own: all but the signals, the exit code of the
/// process and what kinds of streams it has. <see cref="DemoProcess"/> is for those.</summary>
public sealed class RunningDemo : IDisposable
{
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(90);

    private readonly CancellationTokenSource _cancel = new();
    private readonly Written _out = new(), _error = new();
    private readonly Task<int> _run;

    private RunningDemo(Stream input, Stream? output, Stream? error, string[] args)
    {
        var streams = new StandardStreams(input, output ?? _out, error ?? _error);
        _run = Task.Factory.StartNew(
            () => Program.Run(args, streams, _cancel.Token), CancellationToken.None, TaskCreationOptions.LongRunning,
            TaskScheduler.Default);
    }

    /// <summary>Starts the demo and returns at once. Its standard input is empty.</summary>
    public static RunningDemo Start(params string[] args) => new(Stream.Null, null, null, args);

    /// <summary>As the other one, with some streams of the caller's.</summary>
    public static RunningDemo Start(string[] args, Stream input, Stream? output = null, Stream? error = null) =>
        new(input, output, error, args);

    /// <summary>Does what Ctrl-C does.</summary>
    public void Interrupt() => _cancel.Cancel();

    /// <summary>Waits until a condition of standard output holds while the demo is running.</summary>
    public void WaitUntil(Func<string, bool> outputSoFar)
    {
        long start = Stopwatch.GetTimestamp();
        while (!outputSoFar(_out.ToString()))
        {
            Assert.False(_run.IsCompleted, $"The demo ended early: {_error}");
            Assert.True(Stopwatch.GetElapsedTime(start) < Patience, "The demo did not get there in time.");
            Thread.Sleep(5);
        }
    }

    public DemoRun Wait()
    {
        Assert.True(_run.Wait(Patience), "The demo did not end.");
        return new DemoRun(_run.Result, _out.ToString(), _error.ToString());
    }

    public void Dispose()
    {
        _cancel.Cancel();
        _run.Wait(Patience);
        _cancel.Dispose();
    }

    /// <summary>Keeps what is written, also while it is written.</summary>
    private sealed class Written : WriteOnlyStream
    {
        private readonly MemoryStream _bytes = new();

        public override void Write(ReadOnlySpan<byte> buffer)
        {
            lock (_bytes) _bytes.Write(buffer);
        }

        public override void Flush()
        {
        }

        public override string ToString()
        {
            lock (_bytes) return Encoding.UTF8.GetString(_bytes.GetBuffer(), 0, (int)_bytes.Length);
        }
    }
}

/// <summary>A stream on a disk without space.</summary>
public sealed class FullStream : MemoryStream
{
    public override void Write(byte[] buffer, int offset, int count) => throw Full();

    public override void Write(ReadOnlySpan<byte> buffer) => throw Full();

    private static IOException Full() => new("No space left on device");
}
