namespace Gjk.Core;

/// <summary>Chooses the contact among several pairs of parts that are met at once. Where a corner lands on a corner,
/// each pair has a normal of its own, but only one that separates all pairs holds for the bodies.</summary>
internal static class SimultaneousHits
{
    /// <summary>Ratio to the parts' radii: 2^-18, as in <see cref="MetFeatures"/>: how far parts may reach past the
    /// plane when its normal is rounded to float. A facet of CornerLandingTests reaches ten thousand times further;
    /// four times more or less changes nothing.</summary>
    private const double Level = 1.0 / (1 << 18);

    /// <summary>Count: the most normals that are tried, where none separates. More meet at a corner of few
    /// meshes.</summary>
    private const int MostTries = 64;

    /// <summary>Gives the last search the contact whose normal separates all pairs met at its point. Of several, the
    /// one with the best feature, then the least numbers.</summary>
    public static void KeepSeparating(ConcaveScratch scratch, in PartMotion motion)
    {
        ref PartCastSearch search = ref scratch.CastSearch;
        List<CastHit> met = scratch.Met;
        if (search.PartA < 0 || search.Cast.Status != CastStatus.Hit || met.Count < 2) return;
        InPlaceSort.Sort(met);
        RotationD rotationA = new(PartAdvancement.PoseAt(motion.A, search.Cast.Fraction).Rotation);
        RotationD rotationB = new(PartAdvancement.PoseAt(motion.B, search.Cast.Fraction).Rotation);
        for (int i = 0; i < Math.Min(met.Count, MostTries); i++)
        {
            CastHit hit = met[i];
            Double3 normal = hit.Result.Normal;
            if (!Separates(scratch, hit, rotationA.InverseRotate(normal), rotationB.InverseRotate(-normal))) continue;
            (search.Cast, search.Feature, search.PartA, search.PartB) = (hit.Result, hit.Feature, hit.PartA, hit.PartB);
            return;
        }
    }

    /// <summary>Whether a shape reaches past the plane of a contact: then the side that was met there is no side of the
    /// two together.</summary>
    public static bool Covers(in ConvexShape shape, in RigidPose pose, Vector3 point, Vector3 normal) =>
        Double3.Dot(normal, FlushSides.Furthest(shape, pose, normal) - point) > Level * shape.BoundingRadius;

    private static bool Separates(ConcaveScratch scratch, in CastHit hit, in Double3 inA, in Double3 inB)
    {
        double reach = Reach(scratch, hit, inA, inB, out double size);
        foreach (CastHit other in scratch.Met)
        {
            double beyond = Reach(scratch, other, inA, inB, out double length) - reach, room = Level * (size + length);
            if (beyond > room && (other.Result.Point - hit.Result.Point).Length() <= room) return false;
        }

        return true;
    }

    /// <summary>How far two parts reach into each other along a normal, up to an offset that all pairs share.</summary>
    private static double Reach(
        ConcaveScratch scratch, in CastHit pair, in Double3 inA, in Double3 inB, out double size)
    {
        ConvexShape room = default;
        size = scratch.A.ShapeOf(pair.PartA, ref room).BoundingRadius;
        size += scratch.B.ShapeOf(pair.PartB, ref room).BoundingRadius;
        return PlaneProof.ReachOf(scratch.A, pair.PartA, inA) + PlaneProof.ReachOf(scratch.B, pair.PartB, inB);
    }
}
