namespace Gjk.Core;

public sealed partial class Workers
{
    /// <summary>What the threads see of a job at hand.</summary>
    private abstract class Task
    {
        public abstract void RunParts();

        public abstract void Stop();
    }

    /// <summary>Cuts a job into parts that any thread may take.</summary>
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
