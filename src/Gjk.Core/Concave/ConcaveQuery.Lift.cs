namespace Gjk.Core;

// Casts that pass shallow contacts, of bodies that are in the union of parts: see UnionLift.
public static partial class ConcaveQuery
{
    /// <summary>Where a solid meets the open surface that it has been lifted off: what is behind that when the motion
    /// begins is not met again, and what crosses it is not in its way from above.</summary>
    private static CastHit FirstAbove(
        ConcaveScratch scratch, PartMotion motion, in RigidMotion a, in RigidMotion b, in RigidPose lifted,
        float maxFraction, float tolerance, in CastOptions options)
    {
        PartSide sideA = scratch.A, sideB = scratch.B;
        if (sideA.IsSolid == sideB.IsSolid || (sideA.IsSolid ? sideB : sideA).Mesh is null) return InvalidCast;
        var moved = new RigidMotion(lifted, b.Velocity, b.AngularVelocity);
        sideB.Pose = lifted;
        scratch.CastSearch.Begin(scratch, motion, a, moved, maxFraction, tolerance, options);
        CastHit first = First(scratch, motion, a, moved, maxFraction, options, null);
        sideB.Pose = b.Pose;
        bool isBelow = Vector3.Dot(first.Result.Normal, lifted.Position - b.Pose.Position) > 0;
        return first.IsHit && isBelow ? first : InvalidCast;
    }

    /// <summary>Where B is out of the union of A's parts, and what it may pass from there: what begins deeper in the
    /// union than is allowed may slide along it, over the seams of its parts.</summary>
    private static bool TryLift(
        ConcaveScratch scratch, in RigidMotion a, in RigidMotion b, in CastOptions options, out RigidPose lifted,
        out CastOptions liftedOptions)
    {
        (lifted, liftedOptions) = (b.Pose, options);
        if (!options.PassesShallow) return false;
        bool isLifted = false;
        for (int i = 0; i < UnionLift.MostLifts; i++)
        {
            scratch.B.Pose = lifted;
            var still = new RigidMotion(a.Pose, Vector3.Zero);
            CastHit start = Move(scratch, PartMotion.Cast, still, new RigidMotion(lifted, Vector3.Zero), 0, 0, default);
            if (!UnionLift.TryMove(ShorterWay(scratch, start), liftedOptions, 1, ref lifted)) break;
            isLifted = true;
            liftedOptions = UnionLift.Within(UnionLift.RoundingOf(a.Pose) + UnionLift.RoundingOf(lifted));
        }

        scratch.B.Pose = b.Pose;
        return isLifted;
    }

    /// <summary>What takes the place of a hit with the seam of parts that B has been passing: the contact with their
    /// surface.</summary>
    private static CastHit OffSeam(
        ConcaveScratch scratch, PartMotion motion, in RigidMotion a, in RigidMotion b, float maxFraction,
        float tolerance, in CastOptions options, in CastHit hit)
    {
        PartSide sideA = scratch.A, sideB = scratch.B;
        CastHit first = Move(scratch, motion, a, b, maxFraction, tolerance, default);
        RigidPose atA = PartAdvancement.PoseAt(a, first.Fraction), atB = PartAdvancement.PoseAt(b, first.Fraction);
        if (!ShowsFace(sideA, first.PartA, atA, first.Result.Normal)
            && !ShowsFace(sideB, first.PartB, atB, -first.Result.Normal))
        {
            return hit;
        }

        (atA, atB) = (PartAdvancement.PoseAt(a, hit.Fraction), PartAdvancement.PoseAt(b, hit.Fraction));
        double room = UnionLift.RoundingOf(atA) + UnionLift.RoundingOf(atB);
        if (motion == PartMotion.Impact) room += scratch.CastSearch.TouchRoom;
        Double3 point = first.Result.Point;
        Double3 way = b.VelocityOf(point, first.Fraction) - a.VelocityOf(point, first.Fraction);
        if (!UnionLift.TryLeave(hit.Result, first.Result, way, options, room, 1, ref atB)) return hit;
        (sideA.Pose, sideB.Pose) = (atA, atB);
        CastResult above = Move(
            scratch, motion, new RigidMotion(atA, a.Velocity, a.AngularVelocity),
            new RigidMotion(atB, b.Velocity, b.AngularVelocity), maxFraction - hit.Fraction, tolerance, default).Result;
        (sideA.Pose, sideB.Pose) = (a.Pose, b.Pose);
        return UnionLift.IsFlush(above, first.Result) ? first : hit;
    }

    private static bool ShowsFace(PartSide side, int part, in RigidPose pose, Vector3 normal)
    {
        ConvexShape room = default;
        return MetFeatures.Of(side.Part(Math.Max(part, 0), ref room), pose, normal, out _) == MetFeature.Face;
    }

    /// <summary>The way out of the two parts that overlap deepest, where it is shorter than the one over a solid's
    /// outside: a solid that stands in a floor rises out of it, though its walls, which are all that the floor touches,
    /// look aside. A way that leads into a solid is followed by the one out of that. Of two solids the way over the
    /// outside is the shorter one already, and what is inside without touching is behind the parts.</summary>
    private static CastResult ShorterWay(ConcaveScratch scratch, in CastHit start)
    {
        ref PartCastSearch search = ref scratch.CastSearch;
        PartSide a = scratch.A, b = scratch.B;
        if (start.Status != CastStatus.OverlappingAtStart || (a.IsSolid && b.IsSolid)) return start.Result;
        bool isOfParts = search.PartA >= 0 && search.Cast.Status == CastStatus.OverlappingAtStart
            && search.Cast.Depth < start.Result.Depth;
        CastHit way = isOfParts ? new CastHit(search.Cast, search.PartA, search.PartB) : start;
        if (a.IsSolid) return OffSheet(scratch, a, way.PartA, b, way.PartB, way.Result);
        if (!b.IsSolid) return way.Result;
        return OffSheet(scratch, b, way.PartB, a, way.PartA, way.Result.Swapped).Swapped;
    }

    /// <summary>The way that takes a solid off the face of an open surface, with all of it that hangs together with a
    /// triangle, to the nearer side. What is behind the surface as a whole would meet it again.</summary>
    /// <param name="scratch">Of which another one is rented.</param>
    /// <param name="solid">A.</param>
    /// <param name="triangle">Of the solid.</param>
    /// <param name="sheet">B; other things are left by the own way.</param>
    /// <param name="part">Of the surface.</param>
    /// <param name="own">The way out of these two.</param>
    private static CastResult OffSheet(
        ConcaveScratch scratch, PartSide solid, int triangle, PartSide sheet, int part, in CastResult own)
    {
        CastResult best = own;
        if (sheet.Mesh is null || triangle < 0 || part < 0) return best;
        Double3 face = new RotationD(sheet.Pose.Rotation).Rotate(ContactCone.NormalOf(sheet, part));
        if (face.LengthSquared == 0) face = own.Normal;
        RotationD turn = new(solid.Pose.Rotation);
        float least = float.PositiveInfinity;
        int sides = 0;
        for (int i = 0; i < 2; i++, face = -face)
        {
            if (!MeshClimb.TryFind(solid.Mesh!, triangle, turn.InverseRotate(-face), out int corner)) continue;
            Double3 tip = CoveredSides.InWorld(solid.Mesh!.GetCorner(corner), solid.Pose);
            float room = UnionLift.RoundingOf(solid.Pose) + UnionLift.RoundingOf(sheet.Pose);
            ConcaveScratch other = scratch.Rent();
            RayHit front = RayCast(
                AnyShape.Surface(sheet.Mesh), sheet.Pose, (Vector3)(tip - face * room), (Vector3)face, other);
            scratch.Return(other);
            if (front.IsHit) sides++;
            float deep = Math.Max(front.Distance - room, 0);
            if (!front.IsHit || deep >= least) continue;
            least = deep;
            best = new CastResult(own.Status, 0, own.Point, (Vector3)(-face), 0, least);
        }

        // Where the surface has no corner behind it, the other side's says nothing.
        return sides == 2 || Vector3.Dot(best.Normal, own.Normal) > 0 ? best : own;
    }
}
