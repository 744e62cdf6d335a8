namespace Gjk.Core;

/// <summary>Whether a piece of one shape lies inside the other, where their parts share no point. Each piece is then
/// wholly inside or wholly outside, so one point of it decides.</summary>
internal static class Containment
{
    /// <summary>Ratio to a triangle's size: 2^-10. A point so far behind it shows on which side of another surface its
    /// solid is. It is more than rounding, and less than a solid's thickness. Pinned by FlushSolidTests.</summary>
    private const double Behind = 1.0 / (1 << 10);

    /// <summary>Finds the first piece of either that lies in the other's inside.</summary>
    /// <param name="scratch">With both sides set, whose parts share no point.</param>
    /// <param name="found">The overlap, at a point of the piece.</param>
    public static bool TryFind(ConcaveScratch scratch, out PairDistance found)
    {
        if (TryFind(scratch, scratch.A, scratch.B, out int holder, out int part, out DistanceResult result))
        {
            found = new PairDistance(result, holder, part);
            return true;
        }

        bool isInB = TryFind(scratch, scratch.B, scratch.A, out holder, out part, out result);
        found = new PairDistance(result.Swapped, part, holder);
        return isInB;
    }

    /// <summary>Whether a piece of either is in the other's inside, after B has moved. The middle of each piece is
    /// tested, unless that is on the surface.</summary>
    /// <param name="scratch">With both sides set, whose parts may touch.</param>
    /// <param name="moved">How far B has moved from its pose, in the world.</param>
    public static bool IsAnyInside(ConcaveScratch scratch, in Double3 moved) =>
        IsAnyInside(scratch, scratch.A, scratch.B, moved) || IsAnyInside(scratch, scratch.B, scratch.A, -moved);

    /// <summary>Whether the middle of a triangle that touches the other's surface is in its inside, after B has moved.
    /// A piece with edges in a surface may be on both sides of it. If nothing has moved, faces of two solids may
    /// coincide, so a point just behind the middle is tested, too.</summary>
    /// <param name="scratch">With both sides set, whose parts may touch.</param>
    /// <param name="moved">How far B has moved from its pose, in the world.</param>
    /// <param name="pair">The triangle, and one that it touches.</param>
    /// <param name="outward">The direction out of the triangle's solid, in the world; 0 where it has none.</param>
    public static bool IsAnyTouchingInside(
        ConcaveScratch scratch, in Double3 moved, out PairDistance pair, out Double3 outward)
    {
        if (IsAnyTouchingInside(scratch, scratch.B, scratch.A, -moved, out pair, out outward)) return true;
        bool isIn = IsAnyTouchingInside(scratch, scratch.A, scratch.B, moved, out pair, out outward);
        pair = new PairDistance(pair.Result, pair.PartB, pair.PartA);
        return isIn;
    }

    /// <summary>Whether a point of the world, in double, is in a solid.</summary>
    public static bool Holds(ConcaveScratch scratch, PartSide outer, in Double3 world) =>
        FindHolder(scratch, outer, VectorDD.ToFrame(outer.Pose, (VectorDD)world)) is not null;

    /// <summary>Whether a solid winds around a point of a ray. The point is computed in 106 bits.</summary>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="outer">The side with the solids.</param>
    /// <param name="origin">Where the ray begins, in the world.</param>
    /// <param name="direction">Of any length.</param>
    /// <param name="distance">World units along the ray.</param>
    public static bool HoldsOnRay(
        ConcaveScratch scratch, PartSide outer, Vector3 origin, Vector3 direction, double distance)
    {
        Double3 along = direction;
        VectorDD point = (Double3)origin + (VectorDD)along * (DoubleDouble)(distance / along.Length);
        return FindHolder(scratch, outer, VectorDD.ToFrame(outer.Pose, point)) is not null;
    }

    /// <summary>The first inside that holds a point of the shape's frame, or null.</summary>
    private static SolidInside? FindHolder(ConcaveScratch scratch, PartSide outer, in VectorDD local)
    {
        foreach (SolidInside inside in outer.Insides)
            if (Encloses(scratch, inside, local)) return inside;
        return null;
    }

    private static bool Encloses(ConcaveScratch scratch, SolidInside inside, in VectorDD local) =>
        inside.MayHold((Double3)local) && scratch.Winding.About(inside.Mesh, inside.ToMesh(local)) != 0;

    private static bool IsAnyInside(ConcaveScratch scratch, PartSide outer, PartSide inner, in Double3 moved)
    {
        if (!outer.HasInside || inner.IsEndless) return false;
        for (int piece = 0; piece < inner.PieceCount; piece++)
            if (IsInside(scratch, outer, inner, inner.MiddleOf(piece, out _), moved)) return true;
        return false;
    }

    private static bool IsAnyTouchingInside(
        ConcaveScratch scratch, PartSide outer, PartSide inner, in Double3 moved, out PairDistance found,
        out Double3 outward)
    {
        (found, outward) = (default, default);
        if (!outer.HasInside || !(inner.Mesh is not null || inner.HasInside)) return false;
        SolidExit.FindTouching(scratch, outer == scratch.B);
        int last = PartSide.NoPart;
        foreach (PairDistance pair in scratch.Pairs)
        {
            if (pair.PartB == last) continue;
            last = pair.PartB;
            if (inner.Mesh is null && inner.OutwardOf(last) == 0) continue;
            bool hasOutward = inner.TryGetOutward(last, out outward, out Double3 corner);
            Double3 middle = inner.MiddleOf(last);
            found = new PairDistance(pair.Result, last, pair.PartA);
            if (IsInside(scratch, outer, inner, middle, moved)) return true;
            bool mayLie = hasOutward && moved == default;
            if (mayLie && IsBehind(scratch, outer, inner, middle, outward, corner)) return true;
        }

        return false;
    }

    /// <summary>Whether the point behind the middle of a solid's triangle is in both solids.</summary>
    private static bool IsBehind(
        ConcaveScratch scratch, PartSide outer, PartSide inner, in Double3 middle, in Double3 outward,
        in Double3 corner)
    {
        VectorDD at = VectorDD.ToWorld(inner.Pose, middle);
        Double3 inward = outward * (-Behind * ((Double3)at - corner).Length);
        return FindHolder(scratch, inner, VectorDD.ToFrame(inner.Pose, at + (VectorDD)inward)) is not null
            && IsInside(scratch, outer, inner, middle, inward);
    }

    /// <summary>Whether a point of the inner's frame is in the outer, and not on its surface.</summary>
    private static bool IsInside(
        ConcaveScratch scratch, PartSide outer, PartSide inner, in Double3 point, in Double3 moved)
    {
        VectorDD local = VectorDD.ToFrame(outer.Pose, VectorDD.ToWorld(inner.Pose, point) + (VectorDD)moved);
        for (int i = 0; i < outer.Insides.Length; i++)
        {
            if (!Encloses(scratch, outer.Insides[i], local)) continue;
            if (!IsOnSurface(scratch, outer.UnitShape(i), (Vector3)(Double3)local)) return true;
        }

        return false;
    }

    /// <summary>Whether a point touches a triangle, but for rounding.</summary>
    private static bool IsOnSurface(ConcaveScratch scratch, in AnyShape unit, Vector3 point)
    {
        ConcaveScratch other = scratch.Rent();
        double room = ContactCone.Slack * ((Double3)point).SumOfMagnitudes;
        float distance = ConcaveQuery.SignedDistance(unit, RigidPose.Identity, point, other).Distance;
        scratch.Return(other);
        return Math.Abs(distance) <= room;
    }

    private static bool TryFind(
        ConcaveScratch scratch, PartSide outer, PartSide inner, out int holder, out int part,
        out DistanceResult result)
    {
        part = holder = PartSide.NoPart;
        result = default;
        if (!outer.HasInside || inner.IsEndless) return false;
        for (int piece = 0; piece < inner.PieceCount; piece++)
        {
            Double3 point = inner.PointOf(piece, out int first);
            VectorDD placed = VectorDD.ToWorld(inner.Pose, point), local = VectorDD.ToFrame(outer.Pose, placed);
            if (FindHolder(scratch, outer, local) is not { } inside) continue;
            part = inner.NumberOf(first);
            if (outer.Compound is not null) holder = inside.First;
            var world = (Vector3)(Double3)placed;
            result = new DistanceResult(
                GjkStatus.Overlapping, 0, 0, world, world, Vector3.Zero, (Vector3)(Double3)local, (Vector3)point, 0);
            return true;
        }

        return false;
    }
}
