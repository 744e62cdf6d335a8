using System.Collections.Generic;

namespace Gjk.Core;

/// <summary>Which of a scene's pairs overlap.</summary>
internal readonly struct SceneOverlapJob(SceneObjects objects, List<ObjectPair> pairs, bool[] overlaps) : IPartJob
{
    public void Run(int begin, int end)
    {
        ConvexShape[] shapes = objects.Shapes;
        RigidPose[] poses = objects.Poses;
        for (int i = begin; i < end; i++)
        {
            ObjectPair pair = pairs[i];
            if (i + Prefetch.PairsAhead < end) Prefetch.Objects(shapes, poses, pairs[i + Prefetch.PairsAhead]);
            overlaps[i] = ConvexQuery.Overlaps(shapes[pair.A], poses[pair.A], shapes[pair.B], poses[pair.B]);
        }
    }
}

/// <summary>How far apart a scene's pairs are, from where each was in the frame before.</summary>
internal readonly struct SceneDistanceJob(
    SceneObjects objects, List<ObjectPair> pairs, PairWarmStarts warmStarts, float maxDistance, DistanceResult[] results) : IPartJob
{
    public void Run(int begin, int end)
    {
        ConvexShape[] shapes = objects.Shapes;
        RigidPose[] poses = objects.Poses;
        int last = warmStarts.Seek(begin);
        for (int i = begin; i < end; i++)
        {
            ObjectPair pair = pairs[i];
            results[i] = ConvexQuery.Distance(
                shapes[pair.A], poses[pair.A], shapes[pair.B], poses[pair.B], ref warmStarts.Resume(i, ref last), maxDistance);
        }
    }
}
