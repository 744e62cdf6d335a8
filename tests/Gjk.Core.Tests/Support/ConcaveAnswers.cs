namespace Gjk.Core.Tests.Support;

/// <summary>What queries say of two shapes, as text that differs where a bit does.</summary>
internal static class ConcaveAnswers
{
    /// <summary>The nearest parts first, which depend on the tree where several are equally near; then what does
    /// not.</summary>
    public static string[] Of(
        ConcaveScratch scratch, in AnyShape shape, in RigidPose pose, in AnyShape other, in RigidPose at)
    {
        PairDistance distance = ConcaveQuery.Distance(shape, pose, other, at, scratch);
        CastHit cast = ConcaveQuery.Cast(shape, pose, default, other, at, pose.Position - at.Position, scratch);
        RayHit hit = ConcaveQuery.RayCast(shape, pose, at.Position, pose.Position - at.Position, scratch);
        List<PairContacts> contacts = [];
        ConcaveQuery.FindContacts(shape, pose, other, at, 0.05f, scratch, contacts);
        List<PairDistance> pairs = [];
        ConcaveQuery.FindPairsWithin(shape, pose, other, at, 0.05f, scratch, pairs);
        return
        [
            distance.ToString(), distance.Distance.ToString("R"), cast.ToString(), hit.ToString(),
            string.Join("; ", contacts), string.Join("; ", pairs),
        ];
    }
}
