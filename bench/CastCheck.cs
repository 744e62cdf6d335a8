namespace Gjk.Bench;

/// <summary>Makes sure that what is timed is the first touch. Of a hit, the plane across the normal separates the
/// shapes at the fraction, by their supports alone, and as it closes it did so before; and the point lies in both. Of a
/// miss, the least distance on the way, which is a convex function of the fraction, is found by thirds. What overlaps
/// at the start, and does not only touch, is what the boolean query says.</summary>
public static class CastCheck
{
    /// <summary>Length, as a fraction of the size and of the way: poses at a fraction are rounded to float here, and so
    /// are the normal and the point.</summary>
    private const double Rounding = 2e-6;

    /// <summary>Steps of the search by thirds: 1.5 to this power is beyond a float.</summary>
    private const int Thirds = 60;

    /// <param name="name">The set, for the message.</param>
    /// <param name="scene">The pairs.</param>
    /// <param name="least">The least share of pairs that meet.</param>
    /// <param name="most">The most share of them.</param>
    /// <exception cref="FactorCheckException">An answer is wrong, or the shares are.</exception>
    public static void Run(string name, CastScene scene, double least, double most)
    {
        int hits = 0;
        for (int i = 0; i < scene.Pairs.Length; i++)
        {
            (int a, int b) = (scene.Pairs[i].A, scene.Pairs[i].B);
            CastResult cast = Ask(scene, i);
            if (cast.IsHit) hits++;
            if (Problem(scene, i, cast) is { } problem)
            {
                throw new FactorCheckException(string.Create(
                    CultureInfo.InvariantCulture, $"{name}, pair {a}-{b}: {cast}; {problem}"));
            }
        }

        double share = (double)hits / scene.Pairs.Length;
        if (share >= least && share <= most) return;
        throw new FactorCheckException(string.Create(
            CultureInfo.InvariantCulture, $"{name}: {hits} of {scene.Pairs.Length} pairs meet"));
    }

    /// <summary>The answer to a pair; that of a ray as the cast that it stands for.</summary>
    private static CastResult Ask(CastScene scene, int pair)
    {
        (int a, int b) = (scene.Pairs[pair].A, scene.Pairs[pair].B);
        CastResult cast = ConvexQuery.Cast(
            scene.Shapes[a], scene.Poses[a], default, scene.Shapes[b], scene.Poses[b], scene.Motions[pair]);
        if (!scene.IsRays) return cast;
        RayCastResult ray = RayOf(scene, pair);
        double way = Rounding * (SizeOf(scene, pair) + scene.Motions[pair].Length());
        bool same = ray.Status == cast.Status && (!cast.IsHit
            || Math.Abs(ray.Distance - cast.Fraction * (double)scene.Motions[pair].Length()) <= way);
        return same
            ? cast
            : throw new FactorCheckException(FormattableString.Invariant($"ray {a}-{b}: {ray}, but the cast: {cast}"));
    }

    /// <summary>The pair as a ray.</summary>
    public static RayCastResult RayOf(CastScene scene, int pair)
    {
        (int a, int b) = (scene.Pairs[pair].A, scene.Pairs[pair].B);
        Vector3 way = scene.Motions[pair];
        return ConvexQuery.RayCast(scene.Shapes[a], scene.Poses[a], scene.Poses[b].Position, way, way.Length());
    }

    private static string? Problem(CastScene scene, int pair, in CastResult cast)
    {
        double size = SizeOf(scene, pair), way = scene.Motions[pair].Length();
        double band = Rounding * (size + way * cast.Fraction);
        (int a, int b) = (scene.Pairs[pair].A, scene.Pairs[pair].B);
        bool overlaps = ConvexQuery.Overlaps(scene.Shapes[a], scene.Poses[a], scene.Shapes[b], scene.Poses[b]);
        bool isAtStart = cast.Status == CastStatus.OverlappingAtStart;
        bool isWrong = isAtStart ? !overlaps : overlaps && SignedAt(scene, pair, 0) < -Rounding * size;
        if (isWrong) return $"Overlaps says {overlaps}";
        switch (cast.Status)
        {
            case CastStatus.Hit:
                double gap = GapAcross(scene, pair, cast);
                if (!(Math.Abs(gap) <= band)) return FormattableString.Invariant($"the plane leaves {gap}");
                if (Vector3.Dot(cast.Normal, scene.Motions[pair]) > band) return "the plane opens";
                bool isInA = IsIn(scene, a, default, cast, band);
                return isInA && IsIn(scene, b, Moved(scene, pair, cast.Fraction), cast, band)
                    ? null
                    : "the point is not in both";
            case CastStatus.Miss:
                double nearest = Nearest(scene, pair);
                return nearest >= -band ? null : FormattableString.Invariant($"they come to {nearest}");
            default:
                return isAtStart ? null : "it is no answer";
        }
    }

    /// <summary>How far apart the planes stand that touch the shapes across the normal, by their supports.</summary>
    private static double GapAcross(CastScene scene, int pair, in CastResult cast)
    {
        (int a, int b) = (scene.Pairs[pair].A, scene.Pairs[pair].B);
        Double3 normal = cast.Normal, toB = (Double3)scene.Poses[b].Position - scene.Poses[a].Position;
        toB += (Double3)scene.Motions[pair] * cast.Fraction;
        return Double3.Dot(normal, toB) - Height(scene, a, normal) - Height(scene, b, -normal);
    }

    /// <summary>How far a shape reaches beyond its position.</summary>
    private static double Height(CastScene scene, int index, in Double3 direction)
    {
        ref ConvexShape shape = ref scene.Shapes[index];
        Double3 local = new RotationD(scene.Poses[index].Rotation).InverseRotate(direction);
        shape.Support(local, out Double3 furthest);
        return Double3.Dot(local, shape.Center + furthest) + shape.Margin;
    }

    private static bool IsIn(CastScene scene, int index, Vector3 moved, in CastResult cast, double band)
    {
        RigidPose pose = scene.Poses[index];
        var now = new RigidPose(pose.Rotation, pose.Position + moved);
        float distance = ConvexQuery.Distance(
            scene.Shapes[index], now, default(PointShape), new RigidPose(cast.Point)).Distance;
        return distance <= band;
    }

    private static double Nearest(CastScene scene, int pair)
    {
        double from = 0, to = 1;
        for (int i = 0; i < Thirds; i++)
        {
            double third = (to - from) / 3;
            if (SignedAt(scene, pair, from + third) < SignedAt(scene, pair, to - third)) to -= third;
            else from += third;
        }

        return SignedAt(scene, pair, 0.5 * (from + to));
    }

    private static double SignedAt(CastScene scene, int pair, double fraction)
    {
        (int a, int b) = (scene.Pairs[pair].A, scene.Pairs[pair].B);
        RigidPose pose = scene.Poses[b];
        var moved = new RigidPose(pose.Rotation, pose.Position + Moved(scene, pair, fraction));
        return ConvexQuery.SignedDistance(scene.Shapes[a], scene.Poses[a], scene.Shapes[b], moved).Distance;
    }

    private static Vector3 Moved(CastScene scene, int pair, double fraction) =>
        (Vector3)((Double3)scene.Motions[pair] * fraction);

    private static double SizeOf(CastScene scene, int pair) =>
        Math.Max(Motion.Size(scene.Shapes[scene.Pairs[pair].A]), Motion.Size(scene.Shapes[scene.Pairs[pair].B]));
}
