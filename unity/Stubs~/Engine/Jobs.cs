using System.Threading.Tasks;

namespace Unity.Jobs
{
    public interface IJobParallelFor
    {
        void Execute(int index);
    }

    public struct JobHandle
    {
        internal Task Task;

        public void Complete() => Task?.Wait();
    }

    public static class IJobParallelForExtensions
    {
        /// <summary>On other threads, as in the engine.</summary>
        public static JobHandle Schedule<T>(
            this T jobData, int arrayLength, int innerloopBatchCount, JobHandle dependsOn = default)
            where T : struct, IJobParallelFor =>
            new JobHandle { Task = Task.Run(() => Parallel.For(0, arrayLength, i => jobData.Execute(i))) };
    }
}
