namespace Gjk.Core;

public sealed partial class Workers
{
    /// <summary>What the threads see of a job at hand.</summary>
    private abstract class Task
    {
        public abstract void RunShares();

        public abstract void Stop();
    }

    /// <summary>Cuts a job into shares that any thread may take.</summary>
    private sealed class Task<TJob> : Task
        where TJob : struct, IShareJob
    {
        private TJob _job;
        private CancellationToken _cancellation;
        private int _count, _shareLength, _shares;

        /// <summary>The first share that nobody has taken.</summary>
        private int _next;

        public void Begin(in TJob job, int count, int shareLength, CancellationToken cancellation)
        {
            _job = job;
            _count = count;
            _shareLength = shareLength;
            _shares = (int)(((long)count + shareLength - 1) / shareLength);
            _cancellation = cancellation;
            _next = 0;
        }

        /// <summary>Holds on to nothing of the caller's.</summary>
        public void End()
        {
            _job = default;
            _cancellation = default;
        }

        public override void RunShares()
        {
            TJob job = _job;
            while (!_cancellation.IsCancellationRequested)
            {
                int share = Interlocked.Increment(ref _next) - 1;
                if (share >= _shares) return;
                int begin = share * _shareLength;
                job.Run(begin, Math.Min(begin + _shareLength, _count));
            }
        }

        public override void Stop() => Volatile.Write(ref _next, _shares);
    }
}
