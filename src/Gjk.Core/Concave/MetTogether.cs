namespace Gjk.Core;

/// <summary>Which of several pairs of parts that are met at once gives the contact: where a corner lands on a corner,
/// each pair has a normal of its own, but only one that separates all of them holds for the bodies.</summary>
internal readonly ref struct MetTogether(ConcaveScratch scratch, in RigidMotion a, in RigidMotion b, float fraction)
{
    /// <summary>Ratio to the parts' radii: 2^-18, as <see cref="MetFeatures"/> has it; what rounding a normal to float
    /// lets parts reach past the plane. A facet of CornerLandingTests reaches ten thousand times further: four times
    /// more or less changes nothing.</summary>
    private const double Level = 1.0 / (1 << 18);

    /// <summary>Count: so many of them are tried; a bound of the cost where none separates. It is more than meet at one
    /// corner of most meshes.</summary>
    private const int MostTries = 64;

    private readonly RotationD _rotationA = new(PartAdvancement.PoseAt(a, fraction).Rotation);
    private readonly RotationD _rotationB = new(PartAdvancement.PoseAt(b, fraction).Rotation);
    private readonly Double3 _way = (Double3)b.Velocity - a.Velocity;

    /// <summary>Finds the contact whose normal separates best the pairs that are met at its point: of several the best
    /// feature, then the least numbers. Where none has such a normal, a triangle's own may be one.</summary>
    public CastHit Choose()
    {
        List<CastHit> met = scratch.Met;
        InPlaceSort.Sort(met);
        CastHit best = met[0];
        double least = double.PositiveInfinity;
        for (int i = 0; i < Math.Min(met.Count, MostTries) && least > 0; i++)
            Try(met[i], met[i].Result.Normal, ref best, ref least);
        for (int i = 0; i < Math.Min(met.Count, MostTries) && least > 0; i++)
        {
            if (TryFace(scratch.A, met[i].PartA, _rotationA, out Vector3 face)) Try(met[i], face, ref best, ref least);
            if (least > 0 && TryFace(scratch.B, met[i].PartB, _rotationB, out face))
                Try(met[i], face, ref best, ref least);
        }

        return best;
    }

    /// <summary>Takes a normal if less reaches past its plane.</summary>
    private void Try(in CastHit hit, Vector3 normal, ref CastHit best, ref double least)
    {
        Double3 inA = _rotationA.InverseRotate(normal), inB = _rotationB.InverseRotate(-(Double3)normal);
        double reach = Reach(hit, inA, inB, out double size), most = 0;
        foreach (CastHit other in scratch.Met)
        {
            double beyond = Reach(other, inA, inB, out double length) - reach, room = Level * (size + length);
            if (beyond > room && (other.Result.Point - hit.Result.Point).Length() <= room)
                most = Math.Max(most, beyond);
        }

        if (!(most < least)) return;
        least = most;
        CastResult found = hit.Result;
        found = found.With(found.Status, found.Point, normal, found.Iterations, found.Depth);
        best = new CastHit(found, hit.PartA, hit.PartB, hit.Feature);
    }

    /// <summary>How far two parts reach into each other along a normal, but for what all pairs have in common.</summary>
    private double Reach(in CastHit pair, in Double3 inA, in Double3 inB, out double size)
    {
        ConvexShape room = default;
        size = scratch.A.Part(pair.PartA, ref room).BoundingRadius;
        size += scratch.B.Part(pair.PartB, ref room).BoundingRadius;
        return PlaneProof.ReachOf(scratch.A, pair.PartA, inA) + PlaneProof.ReachOf(scratch.B, pair.PartB, inB);
    }

    /// <summary>A triangle's own normal, against B's way.</summary>
    private bool TryFace(PartSide side, int part, in RotationD rotation, out Vector3 normal)
    {
        normal = default;
        if (side.Mesh is null) return false;
        side.Mesh.GetCorners(part, out Double3 a, out Double3 b, out Double3 c);
        Double3 face = rotation.Rotate(Double3.Cross(b - a, c - a));
        double along = Double3.Dot(face, _way);
        if (!(face.Length > 0) || along == 0) return false;
        normal = (Vector3)(face * (-Math.Sign(along) / face.Length));
        return Guard.IsFinite(normal);
    }
}
