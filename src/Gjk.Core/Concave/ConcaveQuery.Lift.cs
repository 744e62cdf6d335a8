namespace Gjk.Core;

// Casts that pass shallow contacts, of bodies that begin in a union of parts: see UnionLift.
public static partial class ConcaveQuery
{
    /// <summary>Ratio to the smaller body's radius: 2^-8. A body that is deeper in another by so much than is allowed
    /// is in it for certain, and not through it yet. Pinned by FlushSolidTests.</summary>
    private const double JustInside = 1.0 / (1 << 8);

    /// <summary>Casts a motion that passes shallow contacts.</summary>
    private static CastHit CastInUnion(ConcaveScratch scratch, in PartMotion motion, List<CastHit>? all)
    {
        var union = new PartsCast(scratch, motion);
        UnionLift.TryLift(ref union, motion.Options, out RigidPose lifted, out Double3 lift);
        CastHit first = FirstContact(scratch, motion, lifted, lift, all);
        if (all is not null) return default;
        double touch = motion.Kind == MotionKind.Impact ? scratch.CastSearch.TouchRoom : 0;
        CastHit found = UnionLift.FirstOfUnion(ref union, motion.Options, lifted, touch, first);
        PartSide sideA = scratch.A, sideB = scratch.B;
        bool mayEnter = (sideA.HasInside || sideB.HasInside) && sideA.PartCount > 1 && sideB.PartCount > 1;
        return mayEnter && Enters(scratch, ref union, motion, found, out CastHit met) ? met : found;
    }

    /// <summary>Whether the body enters a solid by a face that meets one of the solid's flush. It passes that face
    /// triangle by triangle, and gets no deeper in any of them. So a look into the solid, just after the touch,
    /// decides.</summary>
    private static bool Enters(
        ConcaveScratch scratch, ref PartsCast union, in PartMotion motion, in CastHit found, out CastHit met)
    {
        met = union.CastFrom(0, motion.B.Pose, default);
        float at = met.Result.Fraction, left = found.Result.Fraction - at;
        double rate = Math.Abs(Double3.Dot(met.Result.Normal, motion.Way)), allowed = motion.Options.AllowedDepth;
        bool mayBe = met.Status == CastStatus.Hit && (found.IsHit || found.Status == CastStatus.Miss);
        if (!mayBe || !(rate * left > allowed)) return false;
        double look = Math.Min(scratch.A.Tree.Radius, scratch.B.Tree.Radius) * JustInside + allowed;
        left = (float)Math.Min(left, 2 * look / rate);
        scratch.A.Pose = PartAdvancement.PoseAt(motion.A, at);
        scratch.B.Pose = PartAdvancement.PoseAt(motion.B, at);
        bool enters = TryFindInside(scratch, motion, CastResult.Nothing(CastStatus.Miss, left, 0), out _);
        (scratch.A.Pose, scratch.B.Pose) = (motion.A.Pose, motion.B.Pose);
        return enters;
    }

    /// <summary>A's parts as a union in which B moves.</summary>
    private struct PartsCast(ConcaveScratch scratch, in PartMotion motion) : IUnionCast
    {
        private readonly PartMotion _motion = motion;

        public readonly float Sign => 1;

        public readonly RigidPose PoseAt(float fraction) => PartAdvancement.PoseAt(_motion.B, fraction);

        public readonly float RoundingAt(float fraction, in RigidPose pose) =>
            UnionLift.RoundingOf(PartAdvancement.PoseAt(_motion.A, fraction)) + UnionLift.RoundingOf(pose);

        public readonly Double3 WayAt(in Double3 point, float fraction) =>
            _motion.B.VelocityOf(point, fraction) - _motion.A.VelocityOf(point, fraction);

        public readonly CastResult CastAlong(in RigidPose pose, Vector3 way)
        {
            scratch.B.Pose = pose;
            var still = new RigidMotion(_motion.A.Pose, Vector3.Zero);
            bool isStill = way == Vector3.Zero;
            CastHit start = CastMotion(scratch, new PartMotion(
                MotionKind.Cast, still, new RigidMotion(pose, way), isStill ? 0 : 1, 0, default));
            CastResult found = isStill ? ShorterExit(scratch, start) : start.Result;
            scratch.B.Pose = _motion.B.Pose;
            return found;
        }

        public readonly CastHit CastFrom(float fraction, in RigidPose pose, in CastOptions options)
        {
            PartMotion rest = _motion.RestFrom(fraction, pose, options);
            (scratch.A.Pose, scratch.B.Pose) = (rest.A.Pose, rest.B.Pose);
            CastHit found = options.PassesShallow
                ? FirstContact(scratch, rest, pose, default, null)
                : CastMotion(scratch, rest);
            (scratch.A.Pose, scratch.B.Pose) = (_motion.A.Pose, _motion.B.Pose);
            return found;
        }

        public readonly bool ShowsFace(in CastHit hit)
        {
            ConvexShape roomA = default, roomB = default;
            return MetFeatures.AnyIsFace(
                scratch.A.ShapeOf(hit.PartA, ref roomA), PartAdvancement.PoseAt(_motion.A, hit.Fraction),
                scratch.B.ShapeOf(hit.PartB, ref roomB), PoseAt(hit.Fraction), hit.Result.Normal);
        }
    }

    /// <summary>The way out of the two parts that overlap deepest, where it is shorter than the one over a solid's
    /// outside. A solid that stands in a floor rises out of it, though the floor touches only its walls, which look
    /// aside. A way that leads into a solid is followed by the way out of that. Of two solids, the way over the outside
    /// is the shorter one already, and what is inside without touching is behind the parts. Of a compound, the deepest
    /// pair of units counts.</summary>
    private static CastResult ShorterExit(ConcaveScratch scratch, in CastHit start)
    {
        ref PartCastSearch search = ref scratch.CastSearch;
        PartSide a = scratch.A, b = scratch.B;
        bool isShortest = (a.HasInside && b.HasInside) || !a.IsUnit || !b.IsUnit;
        if (start.Status != CastStatus.OverlappingAtStart || isShortest) return start.Result;
        bool isOfParts = search.PartA >= 0 && search.Cast.Status == CastStatus.OverlappingAtStart
            && search.Cast.Depth < start.Result.Depth;
        CastHit way = isOfParts ? new CastHit(search.Cast, search.PartA, search.PartB) : start;
        if (a.IsSolid) return ExitOfSheet(scratch, a, way.PartA, b, way.PartB, way.Result);
        if (!b.IsSolid) return way.Result;
        return ExitOfSheet(scratch, b, way.PartB, a, way.PartA, way.Result.Swapped).Swapped;
    }

    /// <summary>The way that takes a solid off the face of an open surface, with all of it that is connected to a
    /// triangle, to the nearer side. What lies wholly behind the surface would meet it again.</summary>
    /// <param name="scratch">Memory; another scratch is rented from it.</param>
    /// <param name="solid">A.</param>
    /// <param name="triangle">A triangle of the solid.</param>
    /// <param name="sheet">B. If it is no surface, the own way stays.</param>
    /// <param name="part">A triangle of the surface.</param>
    /// <param name="own">The way out of these two.</param>
    private static CastResult ExitOfSheet(
        ConcaveScratch scratch, PartSide solid, int triangle, PartSide sheet, int part, in CastResult own)
    {
        CastResult best = own;
        if (sheet.Mesh is null || triangle < 0 || part < 0) return best;
        Double3 face = sheet.ToWorldDirection(ContactCone.NormalOf(sheet, part));
        if (face.LengthSquared == 0) face = own.Normal;
        RotationD turn = new(solid.Pose.Rotation);
        float least = float.PositiveInfinity;
        int sides = 0;
        for (int i = 0; i < 2; i++, face = -face)
        {
            if (!MeshClimb.TryFind(solid.Mesh!, triangle, turn.InverseRotate(-face), out int corner)) continue;
            Double3 tip = solid.ToWorld(solid.Mesh!.GetCorner(corner));
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

        // If only one side has a surface to meet, the distance to it says nothing about the other side.
        return sides == 2 || Vector3.Dot(best.Normal, own.Normal) > 0 ? best : own;
    }
}
