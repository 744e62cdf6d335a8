namespace Gjk.Core;

/// <summary>How a body that begins inside a solid gets out, over the solid's outside.</summary>
/// <remarks>A triangle of a solid has one side. A part of the body whose middle is outside leaves by the depth of the
/// two parts, where that leads outward: the deepest of them counts, as on a surface. One whose middle is inside leaves
/// over the face that takes least, of those that it overlaps and those that are nearest to its middle: it is lifted
/// across the face's plane. Of several parts of the body the deepest counts. Of two solids, what is behind that face
/// without touching it leaves, too, and the shorter way out counts. Of compounds with solids each solid, and what is in
/// none, is asked alone, and the deepest pair of these counts.</remarks>
internal static class SolidExit
{
    /// <summary>A cosine: 1e-6, some roundings of a normal; what leads along a face does not lead out of it. Four times
    /// more or less changes nothing but which of two faces of an edge is named.</summary>
    private const double Outward = 1e-6;

    /// <summary>Finds the way out of what the scratch holds.</summary>
    /// <param name="scratch">With both sides set, which overlap.</param>
    /// <param name="found">Overlapping, with the depth and the parts.</param>
    /// <returns>False where no part is inside a solid.</returns>
    public static bool TryFind(ConcaveScratch scratch, out CastHit found)
    {
        PartSide a = scratch.A, b = scratch.B;
        found = default;
        if (a.IsEndless || b.IsEndless) return false;
        if (a.IsUnit && b.IsUnit) return TryOfUnits(scratch, out found);
        CompoundShape? wholeA = a.IsUnit ? null : a.Compound, wholeB = b.IsUnit ? null : b.Compound;
        bool isAny = false;
        for (int i = 0; i < (wholeA?.Units.Length ?? 1); i++)
        {
            if (wholeA is not null) a.Take(wholeA.Units[i]);
            for (int j = 0; j < (wholeB?.Units.Length ?? 1); j++)
            {
                if (wholeB is not null) b.Take(wholeB.Units[j]);
                if (!TryOfUnits(scratch, out CastHit way) && !TryDeepest(scratch, out way)) continue;
                if (isAny && !(way.Result.Depth > found.Result.Depth)) continue;
                isAny = true;
                found = new CastHit(
                    way.Result, wholeA is null ? way.PartA : a.Compound!.Numbers[way.PartA],
                    wholeB is null ? way.PartB : b.Compound!.Numbers[way.PartB]);
            }
        }

        if (wholeA is not null) a.Take(wholeA);
        if (wholeB is not null) b.Take(wholeB);
        return isAny;
    }

    /// <summary>The two parts that overlap deepest.</summary>
    private static bool TryDeepest(ConcaveScratch scratch, out CastHit found)
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
                a.Part(partA, ref roomA), a.Pose, Vector3.Zero, b.Part(partB, ref roomB), b.Pose, Vector3.Zero);
            if (start.Status == CastStatus.OverlappingAtStart && !(found.IsHit && start.Depth <= found.Result.Depth))
                found = new CastHit(start, partA, partB);
        }

        return found.IsHit;
    }

    private static bool TryOfUnits(ConcaveScratch scratch, out CastHit found)
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
            Exit exit = OfPart(scratch, outer, inner, part, first, next);
            if (exit.Depth > best.Depth) best = exit;
        }

        // What touches no triangle is inside as a whole, or outside.
        for (int piece = 0; piece < inner.PieceCount; piece++)
        {
            Double3 middle = inner.MiddleOf(piece, out int part);
            if ((inner.IsMesh && pairs.Count > 0) || IsTouching(pairs, part)) continue;
            Double3 world = new RotationD(inner.Pose.Rotation).Rotate(middle) + inner.Pose.Position;
            if (!Containment.Holds(scratch, outer, world)) continue;
            Exit exit = default;
            TryNearest(scratch, outer, inner, part, world, isWhole: inner.IsMesh, ref exit);
            if (exit.Depth > best.Depth) best = exit;
        }

        if (!(best.Depth > 0)) return false;
        if (inner.HasInside && pairs.Count > 0) best = OfSolids(outer, inner, best);
        found = new CastHit(
            new CastResult(
                CastStatus.OverlappingAtStart, 0, best.Point, (Vector3)best.Normal, 0, (float)best.Depth),
            best.Triangle, inner.NumberOf(best.Part));
        return true;
    }

    /// <summary>All pairs that touch, as the triangle of the solid and the part of the other, sorted by that.</summary>
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
    private static Exit OfPart(ConcaveScratch scratch, PartSide outer, PartSide inner, int part, int first, int end)
    {
        List<PairDistance> pairs = scratch.Pairs;
        Double3 middle = inner.CenterOf(part);
        bool isInside = Containment.Holds(scratch, outer, middle);
        Exit deepest = default, least = default;
        for (int i = first; i < end; i++)
        {
            int triangle = pairs[i].PartA;
            if (!outer.TryGetOutward(triangle, out Double3 outward, out Double3 corner)) continue;
            DistanceResult depth = PartQuery.SignedDistance(outer, triangle, inner, part);
            if (!isInside && -depth.Distance > deepest.Depth && Double3.Dot(depth.Normal, outward) > Outward)
                deepest = new Exit(-depth.Distance, depth.Normal, depth.PointA, triangle, part);
            double lift = Double3.Dot(outward, corner) + Reach(inner, part, -outward, isWhole: false);
            if (lift > 0 && (least.Depth == 0 || lift < least.Depth))
                least = new Exit(lift, outward, pairs[i].Result.PointA, triangle, part);
        }

        if (deepest.Depth > 0) return deepest;
        if (isInside) TryNearest(scratch, outer, inner, part, middle, isWhole: false, ref least);
        TryOwnFace(scratch, outer, inner, part, first, end, ref least);
        return least;
    }

    /// <summary>Takes the way across the triangle that is nearest to a point of a part, if that is less; of several
    /// that are equally near, as at an edge, across that which takes least.</summary>
    private static void TryNearest(
        ConcaveScratch scratch, PartSide outer, PartSide inner, int part, in Double3 point, bool isWhole,
        ref Exit least)
    {
        ConcaveScratch other = scratch.Rent();
        var shared = (Vector3)point;
        AnyShape surface = outer.Unit(0), alone = AnyShape.Of(ConvexShape.Point());
        float distance = Math.Abs(ConcaveQuery.SignedDistance(surface, outer.Pose, shared, other).Distance);
        ConcaveQuery.FindPairsWithin(
            surface, outer.Pose, alone, new RigidPose(shared), distance, other, other.Pairs);
        for (int i = 0; i < other.Pairs.Count; i++)
        {
            int triangle = other.Pairs[i].PartA;
            if (!outer.TryGetOutward(triangle, out Double3 outward, out Double3 corner)) continue;
            double lift = Double3.Dot(outward, corner) + Reach(inner, part, -outward, isWhole);
            if (lift > 0 && (least.Depth == 0 || lift < least.Depth))
                least = new Exit(lift, outward, shared, triangle, part);
        }

        scratch.Return(other);
    }

    /// <summary>Takes the way on which what is in a triangle leaves it across the triangle's own face, if that is less:
    /// a tip that a large triangle holds leaves by its own depth. A surface has two sides.</summary>
    private static void TryOwnFace(
        ConcaveScratch scratch, PartSide outer, PartSide inner, int part, int first, int end, ref Exit least)
    {
        if (!inner.IsTriangle(part)) return;
        Double3 away = -new RotationD(inner.Pose.Rotation).Rotate(ContactCone.NormalOf(inner, part));
        if (away == default) return;
        for (int side = inner.OutwardOf(part) == 0 ? 0 : 1; side < 2; side++, away = -away)
        {
            Exit deepest = default;
            for (int i = first; i < end; i++)
            {
                int triangle = scratch.Pairs[i].PartA;
                double depth = Across(outer, triangle, away) + Reach(inner, part, -away, isWhole: false);
                if (depth > deepest.Depth)
                    deepest = new Exit(depth, away, scratch.Pairs[i].Result.PointA, triangle, part);
            }

            double most = least.Depth > 0 ? least.Depth : double.PositiveInfinity;
            if (deepest.Depth > 0 && deepest.Depth < most) least = deepest;
        }
    }

    /// <summary>The way out of two triangles of solids, for what hangs together with them: along the way out of the
    /// two, or across the face of either, whichever is less.</summary>
    private static Exit OfSolids(PartSide outer, PartSide inner, in Exit pair)
    {
        Exit least = new(double.PositiveInfinity, pair.Normal, pair.Point, pair.Triangle, pair.Part);
        outer.TryGetOutward(pair.Triangle, out Double3 front, out _);
        inner.TryGetOutward(pair.Part, out Double3 back, out _);
        for (int i = 0; i < 3; i++)
        {
            Double3 away = i == 0 ? pair.Normal : i == 1 ? front : -back;
            double depth = Across(outer, pair.Triangle, away) + Across(inner, pair.Part, -away);
            if (depth > 0 && depth < least.Depth)
                least = new Exit(depth, away, pair.Point, pair.Triangle, pair.Part);
        }

        return double.IsInfinity(least.Depth) ? pair : least;
    }

    /// <summary>How far along a direction of the world the solid reaches with a triangle: what is behind the other
    /// one's face leaves as a whole. A triangle that faces the way is that face.</summary>
    /// <returns>Infinite where the tip is further away than is looked.</returns>
    private static double Across(PartSide side, int triangle, in Double3 along)
    {
        Double3 local = new RotationD(side.Pose.Rotation).InverseRotate(along);
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
        Double3 local = new RotationD(side.Pose.Rotation).InverseRotate(along);
        double reach = PlaneProof.ReachOf(side, part, local);
        for (int i = 0; isWhole && i < side.PartCount; i++) reach = Math.Max(reach, PlaneProof.ReachOf(side, i, local));
        return reach + Double3.Dot(along, side.Pose.Position);
    }

    /// <summary>A way out: how far, where to, from which point that both share, and between which parts.</summary>
    private readonly struct Exit(double depth, in Double3 normal, Vector3 point, int triangle, int part)
    {
        public readonly double Depth = depth;
        public readonly Double3 Normal = normal;
        public readonly Vector3 Point = point;
        public readonly int Triangle = triangle, Part = part;
    }
}
