namespace Gjk.Exact.Fuzz.Concave;

/// <summary>Contacts against single queries of the parts. Of surfaces and convex shapes those that push along the faces
/// of both parts are there. Each has the bits of its parts' own, or is along a face, or holds a corner of a
/// solid; and its points lie on the parts.</summary>
/// <remarks>What is deep in a solid is found from its outside, so the parts of a contact need not be near each
/// other.</remarks>
internal static class ContactsOfParts
{
    /// <summary>Angle: what rounding to float may turn a direction by. More loses no find, less nearly all.</summary>
    private const double Straight = 1e-7;

    /// <summary>Ratio to the longest side of the parts: a triangle that is less high shows nothing.</summary>
    private const double Flat = 1e-4;

    /// <summary>Ratio of a height to the place, 2^-20: float holds no lower triangle there.</summary>
    private const double FlatThere = 1.0 / (1 << 20);

    /// <summary>Ratio to the size and the place: how far a point may be off its part.</summary>
    private const double Beside = 1e-5;

    /// <summary>Cosine: contacts that push more alike than this, or more against each other, bury none of each
    /// other.</summary>
    private const double Alike = 0.9;

    /// <summary>Cosine: contacts that push less alike than this do not hold what the other one would.</summary>
    private const float Lifting = 0.1f;

    public static string? Broken(ConcavePair pair)
    {
        if (pair.IsUnknown) return null;
        float gap = pair.Least + 0.01f * (float)pair.ScaleOf(0, 0);
        if (!float.IsFinite(gap) || pair.All.Count(one => one.Distance <= gap) > 500) return null;
        var found = new List<PairContacts>();
        ConcaveQuery.FindContacts(pair.A, pair.PoseA, pair.B, pair.PoseB, gap, pair.Scratch, found);
        foreach (PairContacts one in found)
            if (Fault(pair, found, one, gap) is { } fault) return Say.Line($"{one}: {fault}");
        if (pair.HasSolid || IsCompound(pair.RawA) || IsCompound(pair.RawB)) return null;

        var named = found.Select(one => pair.IndexOf(one.PartA, one.PartB)).ToHashSet();
        for (int i = 0; i < pair.PairCount; i++)
        {
            if (!(pair.All[i].Distance <= gap) || named.Contains(i)) continue;
            int a = i / pair.PartsB.Length, b = i % pair.PartsB.Length;
            DistanceResult part = Own(pair, i, gap, out ContactManifold manifold);
            if (manifold.Count > 0 && IsShown(pair, a, b, manifold.Normal)
                && !IsHeld(pair, i, found, part.Distance, manifold))
            {
                return Say.Line($"the contact of pair {i}, {part}, is lost");
            }
        }

        return null;
    }

    private static bool IsCompound(RawShape shape) => shape.Triangles is null && !shape.IsConvex;

    /// <summary>What is wrong about a contact, or null.</summary>
    private static string? Fault(ConcavePair pair, List<PairContacts> found, in PairContacts one, float gap)
    {
        int i = pair.IndexOf(one.PartA, one.PartB), a = i / pair.PartsB.Length, b = i % pair.PartsB.Length;
        Vector3 normal = one.Manifold.Normal;
        DistanceResult part = Own(pair, i, gap, out ContactManifold manifold);
        bool IsOwn(PairContacts other) =>
            manifold.Count > 0 && other.Manifold.Normal == manifold.Normal && other.Result.Distance == part.Distance;
        if (IsOwn(one)) return null;

        // A corner that a neighbour climbs to is named by these parts, too, beside their own.
        bool isThere = found.Exists(other => pair.IndexOf(other.PartA, other.PartB) == i && IsOwn(other));
        double place = ((Double3)pair.PoseA.Position).Length + ((Double3)pair.PoseB.Position).Length;
        double size = pair.ScaleOf(a, b) + place;

        // A point of a compound's part over which another part goes on is left to that one. Along the opposite
        // direction it is what a neighbour climbs to.
        bool mayLack = IsCompound(pair.RawA) || IsCompound(pair.RawB);
        bool isElsewhere = !mayLack && Vector3.Dot(normal, manifold.Normal) > 0
            && Vector3.Cross(normal, manifold.Normal).Length() <= Straight
            && Math.Abs(one.Result.Distance - part.Distance) > Beside * size;
        if (!pair.HasSolid && !isThere && manifold.Count > 0 && IsShown(pair, a, b, manifold.Normal)
            && !IsLeftToOthers(pair, a, b, one.Manifold, manifold)
            && (isElsewhere || !IsHeld(pair, i, found, part.Distance, manifold)))
        {
            return Say.Line($"the parts say {part}, {manifold.Count} points");
        }

        bool isAlong = Along(pair.PartsA[a], pair.PoseA, normal) || Along(pair.PartsB[b], pair.PoseB, normal);
        if (!(isAlong || pair.HasSolid || IsClimbed(pair, normal, gap)))
            return Say.Line($"neither along a face nor what the parts say: {part}, {manifold.Count} points");
        for (int k = 0; k < one.Manifold.Count; k++)
        {
            ManifoldPoint point = one.Manifold[k];
            double off = Math.Abs(Double3.Dot((Double3)point.PointB - point.PointA, normal) - point.Gap);
            if (!(off <= Beside * size)) return Say.Line($"point {k} has a gap of {point.Gap:R} and is off by {off}");
            double beside = Math.Min(
                Off(pair.PartsA[a], pair.PoseA, point.PointA), Off(pair.PartsB[b], pair.PoseB, point.PointB));
            if (!(beside <= Beside * size)) return Say.Line($"point {k} lies {beside} beside both parts");
        }

        return null;
    }

    /// <summary>Whether a contact has the points of the parts' own but for those in other parts of a
    /// compound.</summary>
    private static bool IsLeftToOthers(
        ConcavePair pair, int a, int b, in ContactManifold contact, in ContactManifold own)
    {
        if (!contact.Normal.Equals(own.Normal)) return false;
        for (int k = 0; k < own.Count; k++)
        {
            ManifoldPoint point = own[k];
            bool isKept = false;
            for (int j = 0; j < contact.Count; j++) isKept |= Same(contact[j], point);
            if (!isKept && !IsInOther(pair.RawA, pair.PartsA, pair.PoseA, a, point.PointA)
                && !IsInOther(pair.RawB, pair.PartsB, pair.PoseB, b, point.PointB))
            {
                return false;
            }
        }

        return true;

        static bool Same(in ManifoldPoint p, in ManifoldPoint q) =>
            p.PointA.Equals(q.PointA) && p.PointB.Equals(q.PointB);

        static bool IsInOther(RawShape shape, ConvexShape[] parts, RigidPose pose, int part, Vector3 point) =>
            IsCompound(shape)
                && Enumerable.Range(0, parts.Length).Any(i => i != part && Off(parts[i], pose, point) == 0);
    }

    /// <summary>Whether a direction is that of two parts: from them it was climbed to a corner of others.</summary>
    private static bool IsClimbed(ConcavePair pair, Vector3 normal, float gap)
    {
        for (int i = 0; i < pair.PairCount; i++)
        {
            if (!(pair.All[i].Distance <= gap)) continue;
            Own(pair, i, gap, out ContactManifold own);
            if (own.Count > 0 && own.Normal == normal) return true;
        }

        return false;
    }

    /// <summary>Whether a found contact lifts two parts half the way along their own, or all points of their own are
    /// on or behind its plane, by no more than it pushes the other body out: such a side may be covered. Which side of
    /// each other two triangles are on that touch in one plane is arbitrary, as is the side of a plane of two that a
    /// body leaves by whose centre lies in it.</summary>
    private static bool IsHeld(
        ConcavePair pair, int i, List<PairContacts> found, float own, in ContactManifold contact)
    {
        bool isEitherWay = own == 0 && pair.RawA.Triangles is not null && pair.RawB.Triangles is not null;
        foreach (PairContacts one in found)
        {
            float along = Vector3.Dot(one.Manifold.Normal, contact.Normal);
            if (isEitherWay) along = Math.Abs(along);
            if (along > Lifting && along * Math.Max(-one.Result.Distance, 0) >= -own / 2) return true;
            if (Buries(pair, one.Manifold, contact) || TakesApart(pair, i, own, one)) return true;
        }

        return false;
    }

    /// <summary>Whether two parts are as far out of each other by the push of a contact, which is as short as their
    /// own, as by theirs.</summary>
    private static bool TakesApart(ConcavePair pair, int i, float own, in PairContacts one)
    {
        float push = -one.Result.Distance;
        int a = i / pair.PartsB.Length, b = i % pair.PartsB.Length;
        double room = Room(pair, one.Manifold[0].PointA);
        if (!(push > 0 && push <= -own + room)) return false;
        var pushed = new RigidPose(pair.PoseB.Rotation, pair.PoseB.Position + one.Manifold.Normal * push);
        return ConvexQuery.SignedDistance(pair.PartsA[a], pair.PoseA, pair.PartsB[b], pushed).Distance >= -room;
    }

    private static double Room(ConcavePair pair, in Double3 foot) => Beside * (pair.ScaleOf(0, 0)
        + ((Double3)pair.PoseA.Position).Length + ((Double3)pair.PoseB.Position).Length + foot.Length);

    private static bool Buries(ConcavePair pair, in ContactManifold one, in ContactManifold lost) =>
        Math.Abs(Double3.Dot(one.Normal, (Double3)lost.Normal)) < Alike
            && (Buries(pair, one, lost, isA: true) || Buries(pair, one, lost, isA: false));

    private static bool Buries(ConcavePair pair, in ContactManifold one, in ContactManifold lost, bool isA)
    {
        Double3 normal = isA ? one.Normal : -one.Normal;
        ManifoldPoint deepest = one[0];
        for (int k = 1; k < one.Count; k++)
            if (one[k].Gap < deepest.Gap) deepest = one[k];
        Double3 foot = isA ? deepest.PointA : deepest.PointB;
        double room = Room(pair, foot), most = Math.Max(-deepest.Gap, 0) + room;
        for (int k = 0; k < lost.Count; k++)
        {
            double behind = Double3.Dot(normal, foot - (isA ? lost[k].PointA : lost[k].PointB));
            if (!(behind >= -room && behind <= most)) return false;
        }

        return true;
    }

    private static DistanceResult Own(ConcavePair pair, int i, float gap, out ContactManifold manifold) =>
        ConvexQuery.Contacts(
            pair.PartsA[i / pair.PartsB.Length], pair.PoseA, pair.PartsB[i % pair.PartsB.Length], pair.PoseB, gap,
            out manifold);

    private static double Off(in ConvexShape part, in RigidPose pose, Vector3 point) =>
        ConvexQuery.Distance(part, pose, ConvexShape.Point(), new RigidPose(point)).Distance;

    /// <summary>Whether both parts certainly end along a direction.</summary>
    private static bool IsShown(ConcavePair pair, int a, int b, Vector3 normal) =>
        Faces(pair, a, b, normal) && !IsFlat(pair.RawA, a) && !IsFlat(pair.RawB, b);

    private static bool IsFlat(RawShape shape, int part)
    {
        if (shape.Triangles is null) return false;
        Double3[] corners = shape.CornersOf(part)!;
        double longest = Enumerable.Range(0, 3).Max(i => (corners[(i + 1) % 3] - corners[i]).Length);
        double area = Double3.Cross(corners[1] - corners[0], corners[2] - corners[0]).Length;
        return !(area > longest * Math.Max(Flat * longest, FlatThere * (longest + corners[0].Length)));
    }

    /// <summary>Whether a direction is across both parts; across what is no triangle all are.</summary>
    private static bool Faces(ConcavePair pair, int a, int b, Vector3 normal) =>
        (pair.RawA.Triangles is null || Along(pair.RawA, a, pair.PoseA, normal))
            && (pair.RawB.Triangles is null || Along(pair.RawB, b, pair.PoseB, normal));

    /// <summary>Whether a direction is across a triangle of a mesh.</summary>
    private static bool Along(RawShape shape, int part, in RigidPose pose, Vector3 normal) =>
        shape.Triangles is not null && shape.CornersOf(part) is { } corners && Along(corners, pose, normal);

    /// <summary>Whether a direction is across a part that is a triangle.</summary>
    private static bool Along(in ConvexShape part, in RigidPose pose, Vector3 normal)
    {
        if (part.Kind != ShapeKind.Triangle) return false;
        part.TryGetVertex(0, out Double3 a);
        part.TryGetVertex(1, out Double3 b);
        part.TryGetVertex(2, out Double3 c);
        return Along([a, b, c], pose, normal);
    }

    private static bool Along(Double3[] corners, in RigidPose pose, Vector3 normal)
    {
        Double3 across = Double3.Cross(corners[1] - corners[0], corners[2] - corners[0]);
        double length = across.Length;
        if (!(length > 0)) return false;
        Double3 world = new ApproximateRotation(pose.Rotation).Rotate(across * (1 / length));
        return Double3.Cross(world, normal).Length <= Straight;
    }
}
