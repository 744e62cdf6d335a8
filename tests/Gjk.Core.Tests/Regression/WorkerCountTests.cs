using System.Threading;

namespace Gjk.Core.Tests.Regression;

/// <summary>200,000 workers ended the process; the ninth kind of job ended in an index out of range.</summary>
public class WorkerCountTests
{
    [Theory]
    [InlineData(200_000)]
    [InlineData(1025)]
    [InlineData(int.MaxValue)]
    [InlineData(0)]
    [InlineData(int.MinValue)]
    public void ACountOutsideTheRangeIsRefused(int count) =>
        Assert.Equal("threadCount", Assert.Throws<ArgumentOutOfRangeException>(() => new Workers(count)).ParamName);

    [Fact]
    public void AThreadThatTheSystemRefusesIsOneClearExceptionAndTheOthersEnd()
    {
        var started = new Thread[5];
        int count = 0;
        var e = Assert.Throws<InvalidOperationException>(() => new Workers(10, thread =>
        {
            if (count == started.Length) throw new OutOfMemoryException("No more threads.");
            thread.Start();
            started[count++] = thread;
        }));
        Assert.Equal("Thread 6 of 9 could not be started.", e.Message);
        Assert.IsType<OutOfMemoryException>(e.InnerException);
        Assert.All(started, thread => Assert.False(thread.IsAlive));
    }

    [Fact]
    public void AnyNumberOfKindsOfJobsIsRun()
    {
        using var workers = new Workers(2);
        for (int round = 0; round < 2; round++)
        {
            Run<sbyte>(workers);
            Run<byte>(workers);
            Run<short>(workers);
            Run<ushort>(workers);
            Run<int>(workers);
            Run<uint>(workers);
            Run<long>(workers);
            Run<ulong>(workers);
            Run<float>(workers);
            Run<double>(workers);
            Run<decimal>(workers);
        }
    }

    private static void Run<T>(Workers workers)
    {
        int[] done = new int[100];
        Workers.Run(workers, new Job<T>(done), done.Length, 7, CancellationToken.None);
        Assert.All(done, d => Assert.Equal(1, d));
    }

    /// <summary>A kind of its own for each type.</summary>
    private readonly struct Job<T>(int[] done) : IShareJob
    {
        public void Run(int begin, int end)
        {
            for (int i = begin; i < end; i++) done[i]++;
        }
    }
}
