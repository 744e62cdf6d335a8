using Gjk.Core;

namespace Gjk.Exact.Fuzz.Concave;

/// <summary>Contacts against single queries of the parts: of compounds and convex shapes all of them, with their bits;
/// of triangles those that push along a face, and no others but such as the parts have.</summary>
internal static class ContactsOfParts
{
    /// <summary>Angle: what rounding to float may turn a direction by. More loses no find, less nearly all.</summary>
    private const double Straight = 1e-7;

    public static string? Broken(ConcavePair pair)
    {
        if (pair.IsUnknown) return null;
        float gap = pair.Least + 0.01f * (float)pair.ScaleOf(0, 0);
        if (!float.IsFinite(gap) || pair.All.Count(one => one.Distance <= gap) > 500) return null;
        var found = new List<PartContacts>();
        ConcaveQuery.FindContacts(pair.A, pair.PoseA, pair.B, pair.PoseB, gap, pair.Scratch, found);
        int next = 0;
        for (int i = 0; i < pair.PairCount; i++)
        {
            bool isFound = next < found.Count && pair.IndexOf(found[next].PartA, found[next].PartB) == i;
            if (!(pair.All[i].Distance <= gap))
            {
                if (isFound) return Say.Line($"{found[next]}, but {pair.All[i]} is beyond {gap:R}");
                continue;
            }

            int a = i / pair.PartsB.Length, b = i % pair.PartsB.Length;
            DistanceResult part = ConvexQuery.Contacts(
                pair.PartsA[a], pair.PoseA, pair.PartsB[b], pair.PoseB, gap, out ContactManifold manifold);
            bool isFace = Faces(pair, a, b, manifold.Normal);
            if (!isFound && manifold.Count > 0 && isFace) return Say.Line($"the contact of pair {i}, {part}, is lost");
            if (!isFound) continue;
            PartContacts one = found[next++];
            bool isPart = one.Manifold.Normal == manifold.Normal && one.Result.Distance == part.Distance;
            bool isTurned = !isFace && (Along(pair.RawA, a, pair.PoseA, one.Manifold.Normal)
                || Along(pair.RawB, b, pair.PoseB, one.Manifold.Normal));
            if (manifold.Count == 0 || !(isPart || isTurned))
                return Say.Line($"{one}, but the parts say {part}, {manifold.Count} points");
        }

        return next == found.Count ? null : Say.Line($"{found.Count} contacts, but {next} of them in their order");
    }

    /// <summary>Whether a direction is across both parts; across what is no triangle all are.</summary>
    private static bool Faces(ConcavePair pair, int a, int b, Vector3 normal) =>
        (pair.RawA.Triangles is null || Along(pair.RawA, a, pair.PoseA, normal))
            && (pair.RawB.Triangles is null || Along(pair.RawB, b, pair.PoseB, normal));

    /// <summary>Whether a direction is across a triangle.</summary>
    private static bool Along(RawShape shape, int part, in RigidPose pose, Vector3 normal)
    {
        if (shape.Triangles is null) return false;
        Double3[] corners = shape.CornersOf(part)!;
        Double3 across = Double3.Cross(corners[1] - corners[0], corners[2] - corners[0]);
        double length = across.Length;
        if (!(length > 0)) return false;
        Double3 world = new ApproximateRotation(pose.Rotation).Rotate(across * (1 / length));
        return Double3.Cross(world, normal).Length <= Straight;
    }
}
