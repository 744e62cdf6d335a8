namespace Gjk.Core;

/// <summary>Casts of a body that moves in a union of parts or objects.</summary>
internal interface IUnionCast
{
    /// <summary>1 where the body is B, -1 where it is A.</summary>
    float Sign { get; }

    /// <summary>Where the body is at a fraction.</summary>
    RigidPose PoseAt(float fraction);

    /// <summary>World units: the rounding of the poses, with the body at a pose at a fraction.</summary>
    float RoundingAt(float fraction, in RigidPose pose);

    /// <summary>The velocity of a point of the body, relative to the union.</summary>
    Double3 WayAt(in Double3 point, float fraction);

    /// <summary>The first contact of the body, at another pose at the start, along a way while the union rests. Without
    /// a way, the shortest way out of the union.</summary>
    CastResult CastAlong(in RigidPose pose, Vector3 way);

    /// <summary>The first contact of the rest of the motion after a fraction, with the body at another pose there. The
    /// result's fraction is counted from there.</summary>
    CastHit CastFrom(float fraction, in RigidPose pose, in CastOptions options);

    /// <summary>Whether one of the two shows a face where they meet.</summary>
    bool ShowsFace(in CastHit hit);
}

/// <summary>Casts that pass shallow contacts, of a body that begins inside a union of parts or objects. First the body
/// is moved out of the union, by one deepest way out after another. Contacts that get no deeper from there are passed.
/// So the body slides along the union as along a single body, and walls still stop it.</summary>
/// <remarks>A body that begins outside may enter parts that it passes. It leaves them before it is too deep, when the
/// seam of the next one stops it. The rest of its motion is cast from just outside of them: there it meets their
/// surface, or a wall. That tells a seam from a wall.</remarks>
internal static class UnionLift
{
    /// <summary>Count: a corner of a room takes three ways out; more are harmless.</summary>
    private const int MostLifts = 4;

    /// <summary>Ratio to the coordinates and the depth: 2^-20, some roundings of a position to float. Pinned by
    /// UnionSlideTests.</summary>
    private const float Rounding = 1f / (1 << 20);

    /// <summary>A cosine, of 2.5 degrees: normals that differ by less are of one surface. Walls differ by far more; a
    /// smaller bend is climbed as well as stopped at.</summary>
    private const float SameWay = 0.999f;

    /// <summary>Ratio: 2^-10, the square of a sine, of 1.8 degrees. Between two nearly parallel walls no way along one
    /// leads out of the other.</summary>
    private const double LeastAlong = 1.0 / (1 << 10);

    /// <summary>Moves the body out of the union, if it begins deeper in that than is allowed. What is inside may slide
    /// along the union, over the seams of its parts.</summary>
    /// <param name="union">With the body.</param>
    /// <param name="options">What is passed.</param>
    /// <param name="lifted">The pose.</param>
    /// <param name="lift">The translation, before the pose is rounded to float.</param>
    /// <returns>False where it is not lifted.</returns>
    public static bool TryLift<T>(ref T union, in CastOptions options, out RigidPose lifted, out Double3 lift)
        where T : struct, IUnionCast
    {
        lift = default;
        lifted = union.PoseAt(0);
        RigidPose start = lifted;
        if (!options.PassesShallow) return false;
        float allowed = options.AllowedDepth;
        Double3 last = default;
        for (int i = 0; i < MostLifts; i++)
        {
            CastResult found = union.CastAlong(lifted, Vector3.Zero);
            if (found.Status != CastStatus.OverlappingAtStart || !(found.Depth > allowed)) break;

            // Near a covered side of two parts, the way out of each leads into the other. So the second goes along the
            // first; that may take it over the surface, from where it could sink.
            Double3 leaving = (Double3)found.Normal * union.Sign, way = leaving;
            double back = Double3.Dot(leaving, last), along = 1 - back * back;
            bool isBent = back < 0 && along > LeastAlong;
            if (isBent) way = (leaving - last * back) * (1 / along);
            way *= found.Depth;

            // A depth below the rounding of the position lies on a seam as well as in it.
            if (!TryMove(way, ref lifted))
            {
                way = leaving * union.RoundingAt(0, lifted);
                if (!TryMove(way, ref lifted)) break;
            }

            lift += way;
            if (isBent && union.CastAlong(lifted, (Vector3)(-way)) is { IsHit: true } met
                && TryMove(-way * met.Fraction, ref lifted)) lift -= way * met.Fraction;
            (last, allowed) = (leaving, union.RoundingAt(0, lifted));
        }

        return lifted != start;
    }

    private static bool TryMove(in Double3 way, ref RigidPose pose)
    {
        var moved = (Vector3)((Double3)pose.Position + way);
        if (!Guard.IsFinite(moved) || moved == pose.Position) return false;
        pose = new RigidPose(pose.Rotation, moved);
        return true;
    }

    /// <summary>World units: how far a body may be from the pose that it was moved to.</summary>
    public static float RoundingOf(in RigidPose pose) =>
        (float)Math.Min(Rounding * ((Double3)pose.Position).SumOfMagnitudes, float.MaxValue);

    /// <summary>Whether a part's way out is that of the union, against which the body moves: then what gets deeper in
    /// the part gets deeper in the union, by however little. Beside a flat floor's deepest triangle, the way out of the
    /// next one leans to its edge, by what rounding hides. Along the floor the body only gets deeper in that
    /// one.</summary>
    /// <param name="part">The result of a cast at the part.</param>
    /// <param name="lifted">The body's pose outside the union.</param>
    /// <param name="lift">Its translation to there.</param>
    /// <param name="way">The body's velocity relative to the union; 0 where it turns, as its points move
    /// differently.</param>
    /// <param name="sign">1 where the body is B, -1 where it is A.</param>
    public static bool IsOutOf(
        in CastResult part, in RigidPose lifted, in Double3 lift, in Double3 way, float sign)
    {
        if (part.Status != CastStatus.OverlappingAtStart) return false;
        double against = -Double3.Dot(way, lift);
        if (way != default && !(against > ConvexQuery.AllowedSlope * (way.Length * lift.Length))) return false;
        return (lift - (Double3)part.Normal * (sign * part.Depth)).SumOfMagnitudes
            <= RoundingOf(lifted) + Rounding * part.Depth;
    }

    /// <summary>The first contact with the union, given the first one with its parts.</summary>
    /// <param name="union">With the body.</param>
    /// <param name="options">What is passed.</param>
    /// <param name="lifted">The body's pose outside the union, or the one where it begins.</param>
    /// <param name="touch">World units: the distance at which the bodies touch.</param>
    /// <param name="hit">The first contact of a part that counts from both poses.</param>
    public static CastHit FirstOfUnion<T>(
        ref T union, in CastOptions options, in RigidPose lifted, double touch, in CastHit hit)
        where T : struct, IUnionCast
    {
        RigidPose start = union.PoseAt(0);
        if (lifted != start)
        {
            // The part that the body comes down on may be passed from where it begins, if the body leaves that part by
            // another way: it would sink on. What is met at once is what it was lifted off.
            float rounding = union.RoundingAt(0, lifted);
            CastHit above = union.CastFrom(0, lifted, CastOptions.OnlyDeeper(rounding));
            CastResult met = above.Result;
            bool isBelow = union.Sign * Vector3.Dot(met.Normal, lifted.Position - start.Position) > 0
                || union.WayAt(met.Point, 0).Length * met.Fraction <= rounding;
            if (above.IsHit && isBelow && (!hit.Result.MayHit || above.CompareTo(hit) < 0)) return above;
        }

        return hit.IsHit && options.AllowedDepth > 0 ? ReplaceSeamHit(ref union, options, touch, hit) : hit;
    }

    /// <summary>Replaces a hit with the seam of a surface that the body has been passing by the contact with the
    /// surface: the first of all, as seams come later. The hit may be with a seam if the body goes deeper all the way
    /// into a face that it passes. The body is moved out of the face, and a little further. If it then meets that
    /// surface, or nothing, no wall was hit.</summary>
    private static CastHit ReplaceSeamHit<T>(ref T union, in CastOptions options, double touch, in CastHit hit)
        where T : struct, IUnionCast
    {
        CastHit surface = union.CastFrom(0, union.PoseAt(0), default);
        CastResult first = surface.Result;
        if (!first.IsHit || hit.Result.Normal == first.Normal || !union.ShowsFace(surface)) return hit;
        RigidPose at = union.PoseAt(hit.Fraction);
        double room = union.RoundingAt(hit.Fraction, at) + touch, between = (double)hit.Fraction - first.Fraction;
        double rate = -union.Sign * Double3.Dot(union.WayAt(first.Point, first.Fraction), first.Normal);
        double deep = first.Depth + rate * between + 2 * room;
        bool isIn = rate > 0 && between >= 0 && deep <= 2 * Math.Max(options.AllowedDepth, first.Depth) + 4 * room;
        if (!isIn || !TryMove((Double3)first.Normal * (union.Sign * deep), ref at)) return hit;
        CastResult above = union.CastFrom(hit.Fraction, at, default).Result;
        return !above.MayHit || Vector3.Dot(above.Normal, first.Normal) > SameWay ? surface : hit;
    }
}
