namespace Gjk.Core;

// The shortest way of a convex body over a solid's outside. Behind the plane of a face there may be more of the solid,
// beside a reflex edge, so each way is tried; and a face far from the body's middle may be the one that takes least.
internal static partial class SolidExit
{
    /// <summary>Ratio to the coordinates and the way: 2^-19, some roundings of a pose to float. After a way out, the
    /// body may be so far in as before; ways that differ by less are equal.</summary>
    private const double WayRounding = 1.0 / (1 << 19);

    /// <summary>Finds the shortest of the ways across the faces' planes that take a convex part out.</summary>
    /// <param name="scratch">Memory; another scratch is rented from it.</param>
    /// <param name="outer">The solid.</param>
    /// <param name="inner">The side with the part.</param>
    /// <param name="part">No triangle.</param>
    /// <param name="middle">A point of the part in the solid, in the world.</param>
    /// <param name="near">A way over a face near by: the answer where it is as short, and where no way leads
    /// out.</param>
    private static Exit ShortestOf(
        ConcaveScratch scratch, PartSide outer, PartSide inner, int part, in Double3 middle, in Exit near)
    {
        if (!(near.Depth > 0)) return near;
        ConcaveScratch other = scratch.Rent();
        double room = WayRounding
            * (middle.SumOfMagnitudes + ((Double3)outer.Pose.Position).SumOfMagnitudes + inner.Margin + near.Depth);
        double least = LeastOf(scratch, other, outer, inner, part, near) - room;
        AnyShape surface = outer.UnitShape(0);
        other.A.TrySet(surface, outer.Pose);
        other.B.TrySet(AnyShape.Of(inner.ConvexPart(part)), inner.Pose);
        bool isOut = IsOut(scratch, other, outer, middle, near, inner.Pose, room);
        Exit best = near;
        if (!isOut || near.Depth > least + 2 * room)
        {
            double most = isOut ? near.Depth - room : double.PositiveInfinity;
            CollectWays(outer, inner, part, middle, least, most, other.Shallowest);
            TryWays(scratch, other, outer, inner, part, middle, room, ref best);
        }

        scratch.Return(other);
        return best;
    }

    /// <summary>No way out is shorter: the last point of the part to leave has to get to the surface, and the part's
    /// margin beyond that.</summary>
    private static double LeastOf(
        ConcaveScratch scratch, ConcaveScratch other, PartSide outer, PartSide inner, int part, in Exit near)
    {
        ref readonly ConvexShape shape = ref inner.ConvexPart(part);
        shape.Support(inner.ToLocalDirection(-near.Normal), out Double3 point);
        Double3 last = inner.ToWorld(shape.Center + point);
        if (!Containment.Holds(scratch, outer, last)) return 0;
        AnyShape surface = outer.UnitShape(0);
        return shape.Margin
            + Math.Abs(ConcaveQuery.SignedDistance(surface, outer.Pose, (Vector3)last, other).Distance);
    }

    /// <summary>The ways across the planes of faces whose lengths are in a range, the shortest first.</summary>
    private static void CollectWays(
        PartSide outer, PartSide inner, int part, in Double3 middle, double least, double most,
        List<(float Lift, int Triangle)> ways)
    {
        ways.Clear();
        Double3 from = outer.ToLocal(middle);
        double scale = 1 / outer.Tree.Unit, limit = most * scale;
        RotationD solid = new(outer.Pose.Rotation), body = new(inner.Pose.Rotation);
        ref readonly ConvexShape shape = ref inner.ConvexPart(part);
        Double3 between = inner.ToLocal(middle) - shape.Center;
        for (int i = 0; i < outer.PartCount; i++)
        {
            outer.GetCorners(i, out Double3 a, out Double3 b, out Double3 c);
            Double3 across = Double3.Cross((b - a) * scale, (c - a) * scale) * outer.OutwardOf(i);
            double height = Double3.Dot(across, (a - from) * scale), length = across.LengthSquared;
            if ((height > 0 && height * height >= limit * limit * length) || length == 0) continue;
            length = Math.Sqrt(length);
            Double3 along = body.InverseRotate(solid.Rotate(across)) * (-1 / length);
            shape.Support(along, out Double3 point);
            double lift = height / (length * scale) + Double3.Dot(along, point - between) + shape.Margin;
            if (lift > 0 && lift >= least && lift < most) ways.Add(((float)lift, i));
        }

        InPlaceSort.Sort(ways);
    }

    /// <summary>Keeps the first way that leads out. Triangles of one plane have the same way.</summary>
    private static void TryWays(
        ConcaveScratch scratch, ConcaveScratch other, PartSide outer, PartSide inner, int part, in Double3 middle,
        double room, ref Exit best)
    {
        List<(float Lift, int Triangle)> ways = other.Shallowest;
        Exit tried = default;
        for (int i = 0; i < ways.Count; i++)
        {
            outer.TryGetOutward(ways[i].Triangle, out Double3 outward, out Double3 corner);
            double lift = Double3.Dot(outward, corner) + Reach(inner, part, -outward, isWhole: false);
            bool isSame = lift - tried.Depth <= room
                && (outward - tried.Normal).LengthSquared <= ContactCone.Slack * ContactCone.Slack;
            if (isSame) continue;
            tried = new Exit(lift, outward, (Vector3)middle, ways[i].Triangle, part);
            if (!IsOut(scratch, other, outer, middle, tried, inner.Pose, room)) continue;
            best = tried;
            return;
        }
    }

    /// <summary>Whether a way takes the body out of the solid, but for rounding. It may touch the surface.</summary>
    /// <param name="scratch">Memory.</param>
    /// <param name="other">With the solid's surface and the body.</param>
    /// <param name="outer">The solid.</param>
    /// <param name="middle">A point of the body.</param>
    /// <param name="way">The way.</param>
    /// <param name="from">The body's pose before it.</param>
    /// <param name="room">World units: so much is rounding.</param>
    private static bool IsOut(
        ConcaveScratch scratch, ConcaveScratch other, PartSide outer, in Double3 middle, in Exit way,
        in RigidPose from, double room)
    {
        Double3 moved = way.Normal * (way.Depth + room);
        if (Containment.Holds(scratch, outer, middle + moved)) return false;
        other.B.Pose = new RigidPose(from.Rotation, (Vector3)((Double3)from.Position + moved));
        PartPairSearch.Run(other, 0);
        if (other.Search.PartA < 0) return true;
        if (IsDeep(other, other.Search.PartA, room)) return false;
        PartPairSearch.Collect(other, 0, other.Pairs);
        for (int i = 0; i < other.Pairs.Count; i++)
            if (IsDeep(other, other.Pairs[i].PartA, room)) return false;
        return true;
    }

    private static bool IsDeep(ConcaveScratch other, int triangle, double room) =>
        PartQuery.SignedDistance(other.A, triangle, other.B, 0).Distance < -room;
}
