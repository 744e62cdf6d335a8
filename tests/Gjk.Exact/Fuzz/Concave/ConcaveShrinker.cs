using System.Diagnostics;
using System.Threading;
using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Exact.Fuzz.Concave;

/// <summary>Leaves out what a pair does not need to break a promise: parts, poses, motions.</summary>
internal static class ConcaveShrinker
{
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(20);

    public static ConcavePair Shrink(ConcavePair pair, Promise<ConcavePair> promise, CancellationToken cancel)
    {
        long start = Stopwatch.GetTimestamp();
        bool IsOver() => cancel.IsCancellationRequested || Stopwatch.GetElapsedTime(start) > s_patience;
        for (bool found = true; found && !IsOver();)
        {
            found = false;
            foreach (ConcavePair simpler in Simpler(pair))
            {
                if (IsOver()) break;
                if (promise.Broken(simpler) is null) continue;
                (pair, found) = (simpler, true);
                break;
            }
        }

        return pair;
    }

    private static IEnumerable<ConcavePair> Simpler(ConcavePair pair)
    {
        foreach (RawShape a in Fewer(pair.RawA)) yield return pair.Of(a, pair.RawB);
        foreach (RawShape b in Fewer(pair.RawB)) yield return pair.Of(pair.RawA, b);
        if (pair.RawA.Scale != Vector3.One) yield return pair.Of(pair.RawA.Scaled(Vector3.One), pair.RawB);
        if (pair.RawB.Scale != Vector3.One) yield return pair.Of(pair.RawA, pair.RawB.Scaled(Vector3.One));
        if (pair.Motion != default) yield return pair.At(pair.PoseA, pair.PoseB, default);
        if (pair.PoseA != RigidPose.Identity) yield return pair.At(RigidPose.Identity, pair.PoseB, pair.Motion);
        if (pair.PoseB.Rotation != Quaternion.Identity)
            yield return pair.At(pair.PoseA, new RigidPose(pair.PoseB.Position), pair.Motion);
    }

    /// <summary>Without the first half, the second half, each quarter and so on, down to single parts.</summary>
    private static IEnumerable<RawShape> Fewer(RawShape shape)
    {
        if (shape.IsConvex) yield break;
        for (int size = shape.PartCount / 2; size >= 1; size /= 2)
            for (int start = 0; start + size <= shape.PartCount; start += size)
                yield return shape.Without(start, size);
    }
}
