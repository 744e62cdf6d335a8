namespace Gjk.Core;

/// <summary>Which of several pairs of parts that are met at once gives the contact: where a corner lands on a corner,
/// each pair has a normal of its own, but only one that separates all of them holds for the bodies.</summary>
internal static class MetTogether
{
    /// <summary>Ratio to the parts' radii: 2^-18, as <see cref="MetFeatures"/> has it; what rounding a normal to float
    /// lets parts reach past the plane. A facet of CornerLandingTests reaches ten thousand times further: four times
    /// more or less changes nothing.</summary>
    private const double Level = 1.0 / (1 << 18);

    /// <summary>Count: so many of them are tried; a bound of the cost where none separates. It is more than meet at one
    /// corner of most meshes.</summary>
    private const int MostTries = 64;

    /// <summary>Gives the last search the contact whose normal separates the pairs that are met at its point: of
    /// several the best feature, then the least numbers.</summary>
    public static void Settle(ConcaveScratch scratch, in PartMotion motion)
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

    /// <summary>How far two parts reach into each other along a normal, but for what all pairs have in
    /// common.</summary>
    private static double Reach(
        ConcaveScratch scratch, in CastHit pair, in Double3 inA, in Double3 inB, out double size)
    {
        ConvexShape room = default;
        size = scratch.A.Part(pair.PartA, ref room).BoundingRadius;
        size += scratch.B.Part(pair.PartB, ref room).BoundingRadius;
        return PlaneProof.ReachOf(scratch.A, pair.PartA, inA) + PlaneProof.ReachOf(scratch.B, pair.PartB, inB);
    }
}
