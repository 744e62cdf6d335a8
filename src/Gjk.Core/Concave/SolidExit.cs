namespace Gjk.Core;

/// <summary>Finds how a body that begins inside a solid gets out, over the solid's outside.</summary>
/// <remarks>A solid's triangle has one side. A part whose middle is outside leaves by the depth of the two parts, if
/// that leads outward; the deepest one counts, as on a surface. A part whose middle is inside is lifted across the
/// plane of a face: a triangle across one that it overlaps or one nearest to its middle, what is convex across the one
/// that takes least of all those that lead out. Of several parts of the body the deepest counts. Of two solids, what is
/// behind that face without touching it leaves, too, and the shorter way out counts. In compounds, each solid, and what
/// is in none, is treated alone, and the deepest pair of these counts.</remarks>
internal static partial class SolidExit
{
    /// <summary>A cosine: 1e-6, some roundings of a normal. A way along a face does not lead out of it. Four times more
    /// or less only changes which of two faces at an edge is named.</summary>
    private const double Outward = 1e-6;

    /// <summary>Finds the way out of the scratch's two sides.</summary>
    /// <param name="scratch">With both sides set, which overlap.</param>
    /// <param name="found">Overlapping, with the depth and the parts.</param>
    /// <returns>False where no part is inside a solid.</returns>
    public static bool TryFind(ConcaveScratch scratch, out CastHit found)
    {
        PartSide a = scratch.A, b = scratch.B;
        found = default;
        if (a.IsEndless || b.IsEndless) return false;
        if (a.IsUnit && b.IsUnit) return TryFindOfUnits(scratch, out found);
        CompoundShape? wholeA = a.IsUnit ? null : a.Compound, wholeB = b.IsUnit ? null : b.Compound;
        bool isAny = false;
        for (int i = 0; i < (wholeA?.Units.Length ?? 1); i++)
        {
            if (wholeA is not null) a.SetCompound(wholeA.Units[i]);
            for (int j = 0; j < (wholeB?.Units.Length ?? 1); j++)
            {
                if (wholeB is not null) b.SetCompound(wholeB.Units[j]);
                if (!TryFindOfUnits(scratch, out CastHit way) && !TryFindDeepest(scratch, out way)) continue;
                if (isAny && !(way.Result.Depth > found.Result.Depth)) continue;
                isAny = true;
                found = new CastHit(
                    way.Result, wholeA is null ? way.PartA : a.Compound!.Numbers[way.PartA],
                    wholeB is null ? way.PartB : b.Compound!.Numbers[way.PartB]);
            }
        }

        if (wholeA is not null) a.SetCompound(wholeA);
        if (wholeB is not null) b.SetCompound(wholeB);
        return isAny;
    }

    /// <summary>The two parts that overlap deepest.</summary>
    private static bool TryFindDeepest(ConcaveScratch scratch, out CastHit found)
    {
        PartSide a = scratch.A, b = scratch.B;
        List<PairDistance> pairs = scratch.Pairs;
        PartPairSearch.Collect(scratch, 0, pairs);
        ConvexShape roomA = default, roomB = default;
        found = default;
        for (int i = 0; i < pairs.Count; i++)
        {
            (int partA, int partB) = (pairs[i].PartA, pairs[i].PartB);
            CastResult start = ConvexQuery.Cast(
                a.ShapeOf(partA, ref roomA), a.Pose, Vector3.Zero, b.ShapeOf(partB, ref roomB), b.Pose, Vector3.Zero);
            if (start.Status == CastStatus.OverlappingAtStart && !(found.IsHit && start.Depth <= found.Result.Depth))
                found = new CastHit(start, partA, partB);
        }

        return found.IsHit;
    }

    private static bool TryFindOfUnits(ConcaveScratch scratch, out CastHit found)
    {
        bool isFound = TryFind(scratch, scratch.A, scratch.B, out found);
        if (!TryFind(scratch, scratch.B, scratch.A, out CastHit other)) return isFound;
        other = new CastHit(other.Result.Swapped, other.PartB, other.PartA);
        if (!isFound || other.Result.Depth < found.Result.Depth) found = other;
        return true;
    }

    private static bool TryFind(ConcaveScratch scratch, PartSide outer, PartSide inner, out CastHit found)
    {
        found = default;
        if (!outer.HasInside) return false;
        List<PairDistance> pairs = scratch.Pairs;
        FindTouching(scratch, outer == scratch.B);
        Exit best = default;
        int next = 0;
        while (next < pairs.Count)
        {
            int first = next, part = pairs[first].PartB;
            while (next < pairs.Count && pairs[next].PartB == part) next++;
            Exit exit = ExitOfPart(scratch, outer, inner, part, first, next);
            if (exit.Depth > best.Depth) best = exit;
        }

        // A piece that touches no triangle is wholly inside or wholly outside.
        for (int piece = 0; piece < inner.PieceCount; piece++)
        {
            Double3 middle = inner.MiddleOf(piece, out int part);
            if ((inner.IsMesh && pairs.Count > 0) || IsTouching(pairs, part)) continue;
            Double3 world = inner.ToWorld(middle);
            if (!Containment.Holds(scratch, outer, world)) continue;
            Exit exit = default;
            KeepNearestFace(scratch, outer, inner, part, world, isWhole: inner.IsMesh, ref exit);
            if (!inner.IsTriangle(part)) exit = ShortestOf(scratch, outer, inner, part, world, exit);
            if (exit.Depth > best.Depth) best = exit;
        }

        if (!(best.Depth > 0)) return false;
        if (inner.HasInside && pairs.Count > 0) best = ExitOfSolids(outer, inner, best);
        found = new CastHit(
            new CastResult(
                CastStatus.OverlappingAtStart, 0, best.Point, (Vector3)best.Normal, 0, (float)best.Depth),
            best.Triangle, inner.NumberOf(best.Part));
        return true;
    }

    /// <summary>Finds all pairs that touch, each as the triangle of the solid and the part of the other side, sorted by
    /// the latter.</summary>
    public static void FindTouching(ConcaveScratch scratch, bool isSwapped)
    {
        List<PairDistance> pairs = scratch.Pairs;
        PartPairSearch.Collect(scratch, 0, pairs);
        for (int i = 0; i < pairs.Count; i++)
        {
            PairDistance pair = pairs[i];
            pairs[i] = isSwapped
                ? new PairDistance(pair.Result.Swapped, pair.PartA, pair.PartB)
                : new PairDistance(pair.Result, pair.PartB, pair.PartA);
        }

        InPlaceSort.Sort(pairs);
        for (int i = 0; i < pairs.Count; i++)
            pairs[i] = new PairDistance(pairs[i].Result, pairs[i].PartB, Math.Max(pairs[i].PartA, 0));
    }

    private static bool IsTouching(List<PairDistance> pairs, int part)
    {
        for (int i = 0; i < pairs.Count; i++)
            if (pairs[i].PartB == part) return true;
        return false;
    }

    /// <summary>The way out of a part that touches some triangles.</summary>
    private static Exit ExitOfPart(ConcaveScratch scratch, PartSide outer, PartSide inner, int part, int first, int end)
    {
        List<PairDistance> pairs = scratch.Pairs;
        Double3 middle = inner.CenterOf(part);
        bool isInside = Containment.Holds(scratch, outer, middle);
        bool isBefore = false;
        Exit deepest = default, least = default;
        for (int i = first; i < end; i++)
        {
            int triangle = pairs[i].PartA;
            if (!outer.TryGetOutward(triangle, out Double3 outward, out Double3 corner)) continue;
            DistanceResult depth = PartQuery.SignedDistance(outer, triangle, inner, part);
            if (!isInside && -depth.Distance > deepest.Depth && Double3.Dot(depth.Normal, outward) > Outward)
                deepest = new Exit(-depth.Distance, depth.Normal, depth.PointA, triangle, part);
            double lift = Double3.Dot(outward, corner) + Reach(inner, part, -outward, isWhole: false);
            isBefore |= !(lift > 0);
            KeepLess(new Exit(lift, outward, pairs[i].Result.PointA, triangle, part), ref least);
        }

        // What only touches a face and is before it as a whole is not in what that face bounds.
        if (deepest.Depth > 0) return deepest;
        if (isBefore && !isInside) return default;
        if (isInside) KeepNearestFace(scratch, outer, inner, part, middle, isWhole: false, ref least);
        KeepOwnFace(scratch, outer, inner, part, first, end, ref least);
        bool isLifted = isInside && !inner.IsTriangle(part);
        return isLifted ? ShortestOf(scratch, outer, inner, part, middle, least) : least;
    }

    /// <summary>Keeps the way across the triangle nearest to a point of a part, if that is shorter. Of several that are
    /// equally near, as at an edge, the shortest way counts.</summary>
    private static void KeepNearestFace(
        ConcaveScratch scratch, PartSide outer, PartSide inner, int part, in Double3 point, bool isWhole,
        ref Exit least)
    {
        ConcaveScratch other = scratch.Rent();
        var shared = (Vector3)point;
        AnyShape surface = outer.UnitShape(0), alone = AnyShape.Of(ConvexShape.Point());
        float distance = Math.Abs(ConcaveQuery.SignedDistance(surface, outer.Pose, shared, other).Distance);
        ConcaveQuery.FindPairsWithin(
            surface, outer.Pose, alone, new RigidPose(shared), distance, other, other.Pairs);
        for (int i = 0; i < other.Pairs.Count; i++)
        {
            int triangle = other.Pairs[i].PartA;
            if (!outer.TryGetOutward(triangle, out Double3 outward, out Double3 corner)) continue;
            double lift = Double3.Dot(outward, corner) + Reach(inner, part, -outward, isWhole);
            KeepLess(new Exit(lift, outward, shared, triangle, part), ref least);
        }

        scratch.Return(other);
    }

    /// <summary>Keeps the way across a triangle's own face, along which what is in that triangle leaves it, if that is
    /// shorter: a tip within a large triangle leaves by its own depth. A surface has two sides.</summary>
    private static void KeepOwnFace(
        ConcaveScratch scratch, PartSide outer, PartSide inner, int part, int first, int end, ref Exit least)
    {
        if (!inner.IsTriangle(part)) return;
        Double3 away = -inner.ToWorldDirection(ContactCone.NormalOf(inner, part));
        if (away == default) return;
        for (int side = inner.OutwardOf(part) == 0 ? 0 : 1; side < 2; side++, away = -away)
        {
            Exit deepest = default;
            for (int i = first; i < end; i++)
            {
                int triangle = scratch.Pairs[i].PartA;
                double depth = ReachAcross(outer, triangle, away) + Reach(inner, part, -away, isWhole: false);
                if (depth > deepest.Depth)
                    deepest = new Exit(depth, away, scratch.Pairs[i].Result.PointA, triangle, part);
            }

            KeepLess(deepest, ref least);
        }
    }

    /// <summary>Keeps a way out if it leads out, and is shorter than the one so far.</summary>
    private static void KeepLess(in Exit exit, ref Exit least)
    {
        if (exit.Depth > 0 && (least.Depth == 0 || exit.Depth < least.Depth)) least = exit;
    }

    /// <summary>The way out of two triangles of solids, for all that is connected to them: the shortest of the pair's
    /// own way, and those across the face of either.</summary>
    private static Exit ExitOfSolids(PartSide outer, PartSide inner, in Exit pair)
    {
        Exit least = new(double.PositiveInfinity, pair.Normal, pair.Point, pair.Triangle, pair.Part);
        outer.TryGetOutward(pair.Triangle, out Double3 front, out _);
        inner.TryGetOutward(pair.Part, out Double3 back, out _);
        for (int i = 0; i < 3; i++)
        {
            Double3 away = i == 0 ? pair.Normal : i == 1 ? front : -back;
            double depth = ReachAcross(outer, pair.Triangle, away) + ReachAcross(inner, pair.Part, -away);
            if (depth > 0 && depth < least.Depth)
                least = new Exit(depth, away, pair.Point, pair.Triangle, pair.Part);
        }

        return double.IsInfinity(least.Depth) ? pair : least;
    }

    /// <summary>How far the solid reaches from a triangle along a direction of the world: what is behind the other
    /// triangle's face leaves as a whole. A triangle that faces the direction is itself the furthest.</summary>
    /// <returns>Infinite where the tip is too many corners away.</returns>
    private static double ReachAcross(PartSide side, int triangle, in Double3 along)
    {
        Double3 local = side.ToLocalDirection(along);
        SolidInside solid = side.Solid!;
        int tip = triangle;
        if ((ContactCone.NormalOf(side, triangle) - local).LengthSquared > ContactCone.Slack * ContactCone.Slack)
        {
            if (!MeshClimb.TryFind(solid.Mesh, triangle, solid.AlongMesh(local), out int corner))
                return double.PositiveInfinity;
            tip = corner / 3;
        }

        return PlaneProof.ReachOf(side, tip, local) + Double3.Dot(along, side.Pose.Position);
    }

    /// <summary>How far a part, or a whole mesh, reaches along a direction of the world.</summary>
    private static double Reach(PartSide side, int part, in Double3 along, bool isWhole)
    {
        Double3 local = side.ToLocalDirection(along);
        double reach = PlaneProof.ReachOf(side, part, local);
        for (int i = 0; isWhole && i < side.PartCount; i++) reach = Math.Max(reach, PlaneProof.ReachOf(side, i, local));
        return reach + Double3.Dot(along, side.Pose.Position);
    }

    /// <summary>A way out: its length and direction, a point that both sides share, and the parts.</summary>
    private readonly struct Exit(double depth, in Double3 normal, Vector3 point, int triangle, int part)
    {
        public readonly double Depth = depth;
        public readonly Double3 Normal = normal;
        public readonly Vector3 Point = point;
        public readonly int Triangle = triangle, Part = part;
    }
}
