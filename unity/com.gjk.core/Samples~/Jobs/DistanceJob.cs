using System.Runtime.InteropServices;
using Gjk.Core;
using Gjk.Unity;
using Unity.Jobs;

namespace Gjk.Samples
{
    /// <summary>The distance of one pair. A job may hold no references, so the arrays travel by handles, which whoever
    /// schedules the job frees when it is complete. Burst compiles no job that uses managed objects, as hulls are: it
    /// must not have the attribute.</summary>
    internal struct DistanceJob : IJobParallelFor
    {
        /// <summary>Of an array of <see cref="PosedShape"/>.</summary>
        public GCHandle Shapes;

        /// <summary>Of an array of <see cref="ObjectPair"/>.</summary>
        public GCHandle Pairs;

        /// <summary>Of an array of <see cref="DistanceResult"/>, one for each pair.</summary>
        public GCHandle Results;

        public void Execute(int index)
        {
            var shapes = (PosedShape[])Shapes.Target;
            ObjectPair pair = ((ObjectPair[])Pairs.Target)[index];
            ref PosedShape a = ref shapes[pair.A], b = ref shapes[pair.B];
            ((DistanceResult[])Results.Target)[index] = ConvexQuery.Distance(a.Shape, a.Pose, b.Shape, b.Pose);
        }
    }
}
