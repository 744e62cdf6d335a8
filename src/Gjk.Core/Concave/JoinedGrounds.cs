namespace Gjk.Core;

/// <summary>Static objects of a scene that a body touches, such as the tiles of a floor. They count as one body, whose
/// parts are joined like those of a compound.</summary>
internal static class JoinedGrounds
{
    /// <summary>Adds a static object, unless it is further away than a gap.</summary>
    public static void Add(
        ConcaveScratch scratch, in AnyShape shape, in RigidPose pose, in Aabb box, int pairIndex, float maxGap)
    {
        if (scratch.GroundCount == scratch.Grounds.Count) scratch.Grounds.Add(new PartSide());
        PartSide ground = scratch.Grounds[scratch.GroundCount], own = scratch.A;
        ground.TrySet(shape, pose);
        scratch.A = ground;
        PartPairSearch.Collect(scratch, maxGap, scratch.Near);
        scratch.A = own;
        if (scratch.Near.Count == 0) return;
        InPlaceSort.Sort(scratch.Near);
        foreach (PairDistance near in scratch.Near)
            scratch.Pairs.Add(near.WithPair(new ObjectPair(scratch.GroundCount, PartSide.NoPart)));
        (ground.PairIndex, ground.PairsEnd) = (pairIndex, scratch.Pairs.Count);
        ground.JoinOthers(box);
        scratch.GroundCount++;
    }

    /// <summary>Finds the contacts of the body with all of them.</summary>
    /// <param name="scratch">With the grounds, at least one.</param>
    /// <param name="gap">In world units.</param>
    /// <param name="near">See <see cref="ConcaveQuery.FindPairContacts"/>.</param>
    /// <param name="contacts">Cleared, then the contacts. A of a pair is the number of the static object in the
    /// scratch.</param>
    public static void FindContacts(ConcaveScratch scratch, float gap, float near, List<PairContacts> contacts)
    {
        PartSide own = scratch.A;
        scratch.A = scratch.Grounds[0];
        ConcaveQuery.FindPairContacts(scratch, gap, near, contacts);
        scratch.A = own;
    }

    /// <summary>Whether another part of a compound, or an object joined to it, holds a point of the world and reaches
    /// beyond it.</summary>
    public static bool GoesOn(ConcaveScratch scratch, PartSide side, int part, in Double3 point, in Double3 direction)
    {
        if (side.Compound is not null && CoveredSides.GoesOn(scratch, side, part, point, direction)) return true;
        for (int i = 0; side.IsJoined && i < scratch.GroundCount; i++)
        {
            PartSide other = scratch.Grounds[i];
            if (other == side || !other.MayHold(point)) continue;
            if (CoveredSides.GoesOn(scratch, other, PartSide.NoPart, point, direction)) return true;
        }

        return false;
    }

    /// <summary>Whether a point is on a convex part, or on another near part of its body.</summary>
    public static bool IsOn(
        ConcaveScratch scratch, PartSide side, bool isA, in ConvexShape shape, in Double3 point)
    {
        if (CoveredSides.IsOn(shape, point)) return true;
        if (side.IsConvex) return false;
        ConvexShape room = default;
        Double3 world = side.ToWorld(point);
        for (int i = 0; i < Math.Max(scratch.GroundCount, 1); i++)
        {
            PartSide of = scratch.SideOf(i, isA);
            if (of != side && !of.MayHold(world)) continue;
            Double3 local = of == side ? point : of.ToLocal(world);
            foreach (int k in scratch.AtPoint.Find(scratch, i, isA, PairsAtPoint.AnyPart, local))
            {
                PairDistance near = scratch.Pairs[k];
                if (CoveredSides.IsOn(of.ShapeOf(isA ? near.PartA : near.PartB, ref room), local)) return true;
            }
        }

        return false;
    }

    /// <summary>Whether the point just beyond a point of the world is in a solid.</summary>
    public static bool IsInside(ConcaveScratch scratch, PartSide side, in Double3 point, in Double3 direction) =>
        side.Insides.Length > 0
        && Containment.Holds(scratch, side, FlushSides.JustBeyond(point, direction, side.Tree.Radius));
}
