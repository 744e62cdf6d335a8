using System;
using System.Runtime.ExceptionServices;
using System.Threading;

namespace Gjk.Core;

/// <summary>
/// Threads that share the work of a scene or a batch with the thread that asks. Make one, keep it, pass it to every call that should use it, and dispose of it.
/// </summary>
/// <remarks>
/// Thread-safe: calls from several threads take turns. The results do not depend on it: work is cut into the same parts for any number of threads, and each part
/// has its own place for what it finds. The threads are background threads; they wait without using the processor but for a moment after each task.
/// </remarks>
public sealed class Workers : IDisposable
{
    /// <summary>Count of pauses, some tens of microseconds, that a thread waits awake before it sleeps: the parts of one frame follow each other faster than threads wake. A matter of speed only.</summary>
    private const int PausesAwake = 200;

    /// <summary>Processor pauses between two looks at what is waited for.</summary>
    private const int PauseLength = 16;

    private readonly object _turn = new();
    private readonly object _gate = new();
    private readonly Thread[] _threads;
    private readonly Task[] _tasks = new Task[8];
    private Task? _task;
    private Exception? _failure;
    private volatile int _round;
    private volatile int _inside;
    private volatile bool _disposed;

    /// <summary>Starts the threads, one less than there are processors.</summary>
    public Workers()
        : this(Environment.ProcessorCount)
    {
    }

    /// <summary>Starts the threads.</summary>
    /// <param name="threadCount">How many threads work at once, the caller's included; at least 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">The count is less than 1.</exception>
    public Workers(int threadCount)
    {
        if (threadCount < 1) throw new ArgumentOutOfRangeException(nameof(threadCount), threadCount, "Must be at least 1.");
        _threads = new Thread[threadCount - 1];
        for (int i = 0; i < _threads.Length; i++)
        {
            _threads[i] = new Thread(Loop) { IsBackground = true, Name = "Gjk worker" };
            _threads[i].Start();
        }
    }

    /// <summary>How many threads work at once, the caller's included.</summary>
    public int ThreadCount => _threads.Length + 1;

    /// <summary>Ends the threads after the task at hand. Calling it again does nothing.</summary>
    public void Dispose()
    {
        lock (_turn)
        {
            lock (_gate)
            {
                _disposed = true;
                Monitor.PulseAll(_gate);
            }

            foreach (Thread thread in _threads) thread.Join();
        }
    }

    /// <summary>Refuses workers that were disposed of, before a caller changes anything.</summary>
    internal static void Check(Workers? workers)
    {
        if (workers is { _disposed: true }) throw new ObjectDisposedException(nameof(Workers));
    }

    /// <summary>Runs every part of a job, on the caller's thread alone where there is no other.</summary>
    /// <param name="workers">The threads, or null.</param>
    /// <param name="job">The job; parts may run at the same time.</param>
    /// <param name="count">How many items the job has.</param>
    /// <param name="partLength">How many of them make a part.</param>
    /// <param name="cancellation">Looked at between parts.</param>
    /// <exception cref="OperationCanceledException">Cancelled; an unknown number of parts was run.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    internal static void Run<TJob>(Workers? workers, in TJob job, int count, int partLength, CancellationToken cancellation)
        where TJob : struct, IPartJob
    {
        if (workers is not null) workers.Run(job, count, partLength, cancellation);
        else RunHere(job, count, partLength, cancellation);
    }

    private static void RunHere<TJob>(TJob job, int count, int partLength, CancellationToken cancellation)
        where TJob : struct, IPartJob
    {
        cancellation.ThrowIfCancellationRequested();
        for (int begin = 0; begin < count; begin += partLength)
        {
            job.Run(begin, Math.Min(begin + partLength, count));
            cancellation.ThrowIfCancellationRequested();
        }
    }

    private void Run<TJob>(in TJob job, int count, int partLength, CancellationToken cancellation)
        where TJob : struct, IPartJob
    {
        Check(this);
        if (_threads.Length == 0 || count <= partLength)
        {
            RunHere(job, count, partLength, cancellation);
            return;
        }

        lock (_turn)
        {
            Check(this);
            Task<TJob> task = TaskFor<TJob>();
            task.Begin(job, count, partLength, cancellation);
            Open(task);
            Work(task);
            Close();
            task.End();
            Exception? failure = _failure;
            _failure = null;
            if (failure is not null) ExceptionDispatchInfo.Capture(failure).Throw();
        }

        cancellation.ThrowIfCancellationRequested();
    }

    /// <summary>The object that carries a kind of job to the threads: made once for each kind.</summary>
    private Task<TJob> TaskFor<TJob>()
        where TJob : struct, IPartJob
    {
        int i = 0;
        for (; _tasks[i] is not null; i++)
            if (_tasks[i] is Task<TJob> known) return known;
        var task = new Task<TJob>();
        _tasks[i] = task;
        return task;
    }

    private void Open(Task task)
    {
        lock (_gate)
        {
            _task = task;
            _round++;
            Monitor.PulseAll(_gate);
        }
    }

    /// <summary>Lets nobody in any more and waits until all are out. A thread that did not wake in time is not waited for.</summary>
    private void Close()
    {
        lock (_gate) _task = null;
        for (int i = 0; i < PausesAwake && _inside > 0; i++) Thread.SpinWait(PauseLength);
        if (_inside == 0) return;
        lock (_gate)
            while (_inside > 0) Monitor.Wait(_gate);
    }

    private void Loop()
    {
        int seen = 0;
        while (true)
        {
            for (int i = 0; i < PausesAwake && _round == seen && !_disposed; i++) Thread.SpinWait(PauseLength);
            Task? task;
            lock (_gate)
            {
                while (_round == seen && !_disposed) Monitor.Wait(_gate);
                if (_disposed) return;
                seen = _round;
                task = _task;
                if (task is not null) _inside++;
            }

            if (task is null) continue;
            Work(task);
            lock (_gate)
            {
                _inside--;
                if (_inside == 0) Monitor.PulseAll(_gate);
            }
        }
    }

    private void Work(Task task)
    {
        try
        {
            task.RunParts();
        }
        catch (Exception e)
        {
            task.Stop();
            lock (_gate) _failure ??= e;
        }
    }

    private abstract class Task
    {
        public abstract void RunParts();

        public abstract void Stop();
    }

    private sealed class Task<TJob> : Task
        where TJob : struct, IPartJob
    {
        private TJob _job;
        private CancellationToken _cancellation;
        private int _count, _partLength, _parts;

        /// <summary>The first part that nobody has taken.</summary>
        private int _next;

        public void Begin(in TJob job, int count, int partLength, CancellationToken cancellation)
        {
            _job = job;
            _count = count;
            _partLength = partLength;
            _parts = (int)(((long)count + partLength - 1) / partLength);
            _cancellation = cancellation;
            _next = 0;
        }

        /// <summary>Holds on to nothing of the caller's.</summary>
        public void End()
        {
            _job = default;
            _cancellation = default;
        }

        public override void RunParts()
        {
            TJob job = _job;
            while (!_cancellation.IsCancellationRequested)
            {
                int part = Interlocked.Increment(ref _next) - 1;
                if (part >= _parts) return;
                int begin = part * _partLength;
                job.Run(begin, Math.Min(begin + _partLength, _count));
            }
        }

        public override void Stop() => Volatile.Write(ref _next, _parts);
    }
}
