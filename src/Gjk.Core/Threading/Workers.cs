using System.Runtime.ExceptionServices;

namespace Gjk.Core;

/// <summary>Threads that share the work of a scene or a batch with the thread that asks. Make one, keep it, pass it to
/// every call that should use it, and dispose of it.</summary>
/// <remarks>Thread-safe: calls from several threads take turns. The results do not depend on it: work is cut into the
/// same shares for any number of threads, and each share has its own place for what it finds. The threads are
/// background threads; they wait without using the processor but for a moment after each task. A call that has begun
/// its work ends when all threads have left it, whatever happens: <see cref="Thread.Interrupt"/> on the caller takes
/// effect where the caller waits next. While a call waits for its turn, it ends with the usual
/// <see cref="ThreadInterruptedException"/>, and nothing is done.</remarks>
public sealed partial class Workers : IDisposable
{
    /// <summary>Count of threads: more than any machine that shares memory makes use of here, and few enough to be
    /// started anywhere. Pinned by WorkerCountTests.</summary>
    private const int MostThreads = 1024;

    /// <summary>Count of pauses, some tens of microseconds, that a thread waits awake before it sleeps: the shares of
    /// one frame follow each other faster than threads wake. A matter of speed only.</summary>
    private const int PausesAwake = 200;

    /// <summary>Processor pauses between two looks at what is waited for.</summary>
    private const int PauseLength = 16;

    private readonly object _turn = new();
    private readonly object _gate = new();
    private readonly Thread[] _threads;

    /// <summary>One for each kind of job so far; they are few.</summary>
    private Task[] _tasks = [];
    private Task? _task;
    private Exception? _failure;
    private volatile int _round;
    private volatile int _inside;
    private volatile bool _disposed;

    /// <summary>Starts the threads, one less than there are processors.</summary>
    /// <exception cref="InvalidOperationException">The system refused a thread; those before it have ended
    /// again.</exception>
    public Workers()
        : this(Math.Min(Environment.ProcessorCount, MostThreads))
    {
    }

    /// <summary>Starts the threads.</summary>
    /// <param name="threadCount">How many threads work at once, the caller's included; from 1 to 1024.</param>
    /// <exception cref="ArgumentOutOfRangeException">The count is less than 1 or more than 1024.</exception>
    /// <exception cref="InvalidOperationException">The system refused a thread; those before it have ended
    /// again.</exception>
    public Workers(int threadCount)
        : this(threadCount, thread => thread.Start())
    {
    }

    /// <summary>As the other; tests start the threads in a way that fails.</summary>
    internal Workers(int threadCount, Action<Thread> start)
    {
        if (threadCount is < 1 or > MostThreads)
            throw new ArgumentOutOfRangeException(nameof(threadCount), threadCount, "Must be from 1 to 1024.");
        _threads = new Thread[threadCount - 1];
        int started = 0;
        try
        {
            for (; started < _threads.Length; started++)
            {
                _threads[started] = new Thread(Loop) { IsBackground = true, Name = "Gjk worker" };
                start(_threads[started]);
            }
        }
        catch (Exception e)
        {
            EndThreads(started);
            throw new InvalidOperationException(
                FormattableString.Invariant($"Thread {started + 1} of {_threads.Length} could not be started."), e);
        }
    }

    /// <summary>How many threads work at once, the caller's included.</summary>
    public int ThreadCount => _threads.Length + 1;

    /// <summary>Ends the threads after the task at hand. Calling it again does nothing.</summary>
    public void Dispose()
    {
        lock (_turn) EndThreads(_threads.Length);
    }

    /// <summary>Refuses workers that were disposed of, before a caller changes anything.</summary>
    internal static void Check(Workers? workers)
    {
        if (workers is { _disposed: true }) throw new ObjectDisposedException(nameof(Workers));
    }

    /// <summary>Runs every share of a job, on the caller's thread alone where there is no other.</summary>
    /// <param name="workers">The threads, or null.</param>
    /// <param name="job">The job; shares may run at the same time.</param>
    /// <param name="count">How many items the job has.</param>
    /// <param name="shareLength">How many of them make a share.</param>
    /// <param name="cancellation">Looked at between shares.</param>
    /// <exception cref="OperationCanceledException">Cancelled; an unknown number of shares was run.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    internal static void Run<TJob>(
        Workers? workers, in TJob job, int count, int shareLength, CancellationToken cancellation = default)
        where TJob : struct, IShareJob
    {
        if (workers is not null) workers.Run(job, count, shareLength, cancellation);
        else RunHere(job, count, shareLength, cancellation);
    }

    private static void RunHere<TJob>(TJob job, int count, int shareLength, CancellationToken cancellation)
        where TJob : struct, IShareJob
    {
        cancellation.ThrowIfCancellationRequested();
        for (int begin = 0; begin < count; begin += shareLength)
        {
            job.Run(begin, Math.Min(begin + shareLength, count));
            cancellation.ThrowIfCancellationRequested();
        }
    }

    private void Run<TJob>(in TJob job, int count, int shareLength, CancellationToken cancellation)
        where TJob : struct, IShareJob
    {
        Check(this);
        if (_threads.Length == 0 || count <= shareLength)
        {
            RunHere(job, count, shareLength, cancellation);
            return;
        }

        Exception? failure;
        bool wasInterrupted = false;
        lock (_turn)
        {
            Check(this);
            Task<TJob> task = TaskFor<TJob>();
            task.Begin(job, count, shareLength, cancellation);
            try
            {
                Open(task, ref wasInterrupted);
                Work(task, ref wasInterrupted);
            }
            finally
            {
                Close(ref wasInterrupted);
                task.End();
                (failure, _failure) = (_failure, null);
            }
        }

        // The caller's next wait throws, as it would have done here.
        if (wasInterrupted) Thread.CurrentThread.Interrupt();
        if (failure is not null) ExceptionDispatchInfo.Capture(failure).Throw();
        cancellation.ThrowIfCancellationRequested();
    }

    /// <summary>The object that carries a kind of job to the threads: made once for each kind.</summary>
    private Task<TJob> TaskFor<TJob>()
        where TJob : struct, IShareJob
    {
        foreach (Task known in _tasks)
            if (known is Task<TJob> of) return of;
        var task = new Task<TJob>();
        Array.Resize(ref _tasks, _tasks.Length + 1);
        _tasks[_tasks.Length - 1] = task;
        return task;
    }

    private void Open(Task task, ref bool wasInterrupted)
    {
        EnterGate(ref wasInterrupted);
        _task = task;
        _round++;
        Monitor.PulseAll(_gate);
        Monitor.Exit(_gate);
    }

    /// <summary>Lets nobody in any more and waits until all are out. A thread that did not wake in time is not waited
    /// for.</summary>
    private void Close(ref bool wasInterrupted)
    {
        EnterGate(ref wasInterrupted);
        _task = null;
        Monitor.Exit(_gate);
        for (int i = 0; i < PausesAwake && _inside > 0; i++) Thread.SpinWait(PauseLength);
        if (_inside == 0) return;
        EnterGate(ref wasInterrupted);
        while (_inside > 0)
        {
            try
            {
                Monitor.Wait(_gate);
            }
            catch (ThreadInterruptedException)
            {
                // The gate is entered again.
                wasInterrupted = true;
            }
        }

        Monitor.Exit(_gate);
    }

    /// <summary>Enters the gate, which nobody holds for long, although the caller may be interrupted
    /// meanwhile.</summary>
    private void EnterGate(ref bool wasInterrupted)
    {
        while (true)
        {
            try
            {
                Monitor.Enter(_gate);
                return;
            }
            catch (ThreadInterruptedException)
            {
                wasInterrupted = true;
            }
        }
    }

    /// <summary>Ends the first threads, and waits until they are gone.</summary>
    private void EndThreads(int count)
    {
        lock (_gate)
        {
            _disposed = true;
            Monitor.PulseAll(_gate);
        }

        for (int i = 0; i < count; i++) _threads[i].Join();
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
            bool wasInterrupted = false;
            Work(task, ref wasInterrupted);
            lock (_gate)
            {
                _inside--;
                if (_inside == 0) Monitor.PulseAll(_gate);
            }
        }
    }

    private void Work(Task task, ref bool wasInterrupted)
    {
        try
        {
            task.RunShares();
        }
        catch (Exception e)
        {
            task.Stop();
            EnterGate(ref wasInterrupted);
            _failure ??= e;
            Monitor.Exit(_gate);
        }
    }
}

/// <summary>Work on items 0 to n - 1 that may be done in shares, in any order and at the same time.</summary>
internal interface IShareJob
{
    /// <summary>Does the items from begin up to, not including, end. What it does to one item depends on no
    /// other.</summary>
    void Run(int begin, int end);
}
