using System.Threading;

namespace Gjk.Core.Tests.Regression;

/// <summary>An interrupt of the thread that waited for its workers ended the call while they went on writing into the
/// caller's results.</summary>
public class InterruptedCallerTests
{
    private const int Parts = 8;

    [Fact]
    public void TheCallEndsAfterTheLastWorkerAndTheInterruptComesAtTheNextWait()
    {
        using var workers = new Workers(3);
        using var release = new ManualResetEventSlim();
        var state = new State { Release = release };
        bool hasReturned = false, wasInterrupted = false;
        int doneAtReturn = 0;
        var caller = new Thread(() =>
        {
            state.Caller = Thread.CurrentThread;
            Workers.Run(workers, new SlowOnWorkers(state), Parts, 1, CancellationToken.None);
            doneAtReturn = Volatile.Read(ref state.Done);
            Volatile.Write(ref hasReturned, true);
            try
            {
                Thread.Sleep(1);
            }
            catch (ThreadInterruptedException)
            {
                wasInterrupted = true;
            }
        });
        caller.Start();

        // All parts but those that the workers hold are done, and the caller sleeps.
        WaitFor(() => state.Entered + state.Done >= Parts && state.Entered > 0 && IsWaiting(caller));
        for (int i = 0; i < 20; i++)
        {
            caller.Interrupt();
            Thread.Sleep(5);
            Assert.False(Volatile.Read(ref hasReturned), "the call ended before its workers");
        }

        release.Set();
        Assert.True(caller.Join(TimeSpan.FromSeconds(60)));
        Assert.Equal(Parts, doneAtReturn);
        Assert.True(wasInterrupted);
    }

    [Fact]
    public void AnInterruptedBatchIsWholeAndNobodyWritesAfterwards()
    {
        using var workers = new Workers(4);
        ConvexShape[] shapes = [ConvexShape.Box(System.Numerics.Vector3.One), ConvexShape.Cylinder(1, 1)];
        RigidPose[] poses = [RigidPose.Identity, new RigidPose(new System.Numerics.Vector3(3, 1, 2))];
        var pairs = new ObjectPair[3000];
        for (int i = 0; i < pairs.Length; i++) pairs[i] = new ObjectPair(0, 1);
        int batches = 0, interrupts = 0, unwritten = 0, writtenLater = 0;
        bool stop = false;
        var caller = new Thread(() =>
        {
            var results = new DistanceResult[pairs.Length];
            while (!Volatile.Read(ref stop))
            {
                Array.Clear(results, 0, results.Length);
                try
                {
                    PairBatch.Distance(shapes, poses, pairs, results, workers: workers);
                    foreach (DistanceResult result in results)
                        if (result.Iterations == 0) unwritten++;
                    Array.Clear(results, 0, results.Length);
                    Thread.Sleep(0);
                }
                catch (ThreadInterruptedException)
                {
                    interrupts++;
                }

                foreach (DistanceResult result in results)
                    if (result.Iterations != 0) writtenLater++;
                batches++;
            }
        });
        caller.Start();
        for (int i = 0; i < 60_000 && Volatile.Read(ref interrupts) < 30; i++)
        {
            Thread.Sleep(1);
            caller.Interrupt();
        }

        Volatile.Write(ref stop, true);
        Assert.True(caller.Join(TimeSpan.FromSeconds(60)));
        Assert.True(interrupts >= 30, $"{batches} batches, {interrupts} interrupts");
        Assert.Equal((0, 0), (unwritten, writtenLater));
    }

    private static bool IsWaiting(Thread thread) => (thread.ThreadState & ThreadState.WaitSleepJoin) != 0;

    private static void WaitFor(Func<bool> condition)
    {
        for (int i = 0; i < 6000 && !condition(); i++) Thread.Sleep(5);
        Assert.True(condition());
    }

    private sealed class State
    {
        public Thread? Caller;
        public ManualResetEventSlim? Release;
        public int Entered;
        public int Done;
    }

    /// <summary>A worker holds its part until it is released; the caller lets a worker in first.</summary>
    private readonly struct SlowOnWorkers(State state) : IShareJob
    {
        public void Run(int begin, int end)
        {
            if (Thread.CurrentThread == state.Caller)
            {
                while (Volatile.Read(ref state.Entered) == 0) Thread.Yield();
            }
            else
            {
                Interlocked.Increment(ref state.Entered);
                state.Release!.Wait();
            }

            Interlocked.Add(ref state.Done, end - begin);
        }
    }
}
