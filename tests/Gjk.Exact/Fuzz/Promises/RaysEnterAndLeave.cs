using Gjk.Core;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>A ray from B's place along the motion enters A and leaves it at points of A, and a plane along the normal
/// there has all of A on the side that the ray comes from or goes to: so no earlier and no later point of the ray is in
/// A. Whether it meets A at all is what the distance of a segment says.</summary>
internal static class RaysEnterAndLeave
{
    public static string? Broken(FuzzPair pair)
    {
        Vector3 origin = pair.PoseB.Position, direction = (Vector3)pair.Motion.Relative;
        if (direction == default || !float.IsFinite(direction.LengthSquared())) return null;
        return Problem(
            pair, origin, direction, ConvexQuery.RayCast(pair.A, pair.PoseA, origin, direction),
            ConvexQuery.RayExit(pair.A, pair.PoseA, origin, direction));
    }

    /// <summary>What is wrong with two answers, which may be lies.</summary>
    public static string? Problem(
        FuzzPair pair, Vector3 origin, Vector3 direction, in RayCastResult enter, in RayCastResult leave)
    {
        Double3 along = (Double3)direction * (1 / ((Double3)direction).Length);
        string? wrong = (enter.Status, leave.Status) switch
        {
            (CastStatus.Hit, CastStatus.Hit) when leave.Distance < enter.Distance => "it leaves before it enters",
            (CastStatus.Hit, CastStatus.Hit) =>
                End(pair, origin, -along, -enter.Distance, enter.Normal)
                    ?? End(pair, origin, along, leave.Distance, leave.Normal),
            (CastStatus.Miss, CastStatus.Hit) when IsOnSurface(pair, origin) =>
                End(pair, origin, along, leave.Distance, leave.Normal),
            (CastStatus.OverlappingAtStart, CastStatus.Hit) => End(pair, origin, along, leave.Distance, leave.Normal),
            (CastStatus.Miss, CastStatus.Miss) => Missed(pair, origin, direction),
            _ => "they contradict each other",
        };
        return wrong is null
            ? null
            : Say.Line($"{enter.Status} at {enter.Distance:R}, left: {leave.Status} at {leave.Distance:R}: {wrong}");
    }

    /// <summary>How the end of what the ray has in A is none, or null.</summary>
    private static string? End(FuzzPair pair, Vector3 origin, in Double3 outward, double distance, Vector3 normal)
    {
        PosedShape body = pair.BodyA;
        Double3 start = (Double3)origin - body.Position;
        Double3 point = start + outward * distance, local = body.InverseRotate(point);
        Double3 n = (Double3)normal * (1 / ((Double3)normal).Length);
        double rate = Double3.Dot(n, outward), side = body.LongestSide;
        double noise = Accuracy.LeastFloat
            + Accuracy.Rounding * (start.Length + Math.Abs(distance) + side + body.Center.Length)
            + (body.IsCurved ? Accuracy.CurvedRatio : Accuracy.WitnessScale) * side;
        double rounding = Accuracy.DistanceRatio * Math.Abs(distance);
        double outside = body.Outside(local, [body.InverseRotate(n), .. Directions.Few, .. body.FaceNormals(64)]);
        if (!(outside <= noise + rounding)) return Say.Line($"its end lies {outside} outside");
        if (!(rate >= -Accuracy.NormalTurn)) return Say.Line($"the normal {normal} is not outward");

        // A ray that only touches has its direction for a normal, which no plane is across.
        if (rate >= 1 - Accuracy.UnitLength && distance >= 0)
        {
            var after = (Vector3)(origin + outward * (distance + side / 64));
            double depth = -ConvexQuery.SignedDistance(pair.A, pair.PoseA, after).Distance;
            return depth <= noise + 2 * rounding + PointsLieOnTheShapes.Rounded(after)
                ? null
                : Say.Line($"{after}, beyond its end, is {depth} deep");
        }

        double beyond = body.Height(n) - Double3.Dot(n, point - body.Rotate(body.Center));
        return beyond <= noise + rounding * Math.Abs(rate) + Accuracy.NormalTurn * side * Math.Sqrt(3)
            ? null
            : Say.Line($"along {normal} the shape reaches {beyond} beyond its end");
    }

    /// <summary>A ray that leaves or slides from there passes, and has an end. The depth of what is curved, which says
    /// so, is less sharp than the ray.</summary>
    private static bool IsOnSurface(FuzzPair pair, Vector3 origin)
    {
        DistanceResult r = ConvexQuery.SignedDistance(pair.A, pair.PoseA, origin);
        double room = pair.BodyA.IsCurved ? Accuracy.CurvedRatio : Accuracy.FlagScale;
        return Math.Abs(r.Distance) <= Accuracy.LeastFloat + room * pair.BodyA.LongestSide;
    }

    private static string? Missed(FuzzPair pair, Vector3 origin, Vector3 direction)
    {
        DistanceResult r = ConvexQuery.SignedDistance(
            pair.A, pair.PoseA, ConvexShape.Segment(default, direction), new RigidPose(origin));
        double size = pair.BodyA.LongestSide + ((Double3)direction).Length;
        double noise = Accuracy.LeastFloat + Accuracy.FlagScale * size;
        return r.Distance >= -noise ? null : Say.Line($"a segment along it is {-r.Distance} deep");
    }
}
