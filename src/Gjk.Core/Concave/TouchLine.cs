namespace Gjk.Core;

/// <summary>The line along which a round side or edge touches a face. A part that ends beside that line has contact
/// points there, too. A body that goes on to the line, flat, does not show them.</summary>
internal readonly struct TouchLine(in Double3 from, in Double3 along, in Double3 outward, double radius)
{
    /// <summary>Ratio to the radius of a part with a round side: a point less far beside the line is as deep as the
    /// line, up to 2^-21 of the radius.</summary>
    private const double Beside = 1.0 / (1 << 10);

    /// <summary>Cosine of 6 degrees: a face tilted by more, as much as <see cref="MeetingEdges"/> allows, touches
    /// another one with its edge.</summary>
    private const double Tilted = 0.995;

    private readonly Double3 _from = from, _along = along, _outward = outward;
    private readonly double _least = Beside * radius;

    /// <summary>Removes the points beside the lines of round sides. A contact's deepest point is only removed if
    /// another contact is deeper in the same direction.</summary>
    public static void RemoveBeside(ConcaveScratch scratch, List<PairContacts> contacts)
    {
        if (!scratch.A.IsConvex) RemoveBeside(scratch, true, contacts);
        if (!scratch.B.IsConvex) RemoveBeside(scratch, false, contacts);
    }

    private static void RemoveBeside(ConcaveScratch scratch, bool isA, List<PairContacts> contacts)
    {
        ConvexShape room = default;
        int count = 0;
        for (int i = 0; i < contacts.Count; i++)
        {
            PairContacts one = contacts[i];
            PartSide other = scratch.SideOf(one.Pair.A, !isA);
            Double3 outward = isA ? one.Manifold.Normal : -one.Manifold.Normal;
            ref readonly ConvexShape shape = ref other.ShapeOf(one.PartOf(!isA), ref room);
            if (other.Mesh is null && TryFind(shape, other.Pose, outward, out TouchLine line))
            {
                var cover = new PartsCover(scratch, isA, one);
                ManifoldPoint deepest = one.Manifold[DeepestPoint.IndexIn(one.Manifold)];
                if (line.IsBeside(deepest, cover) && IsAnyDeeper(contacts, one, isA)) continue;
                one = line.WithoutBeside(one, cover);
            }

            contacts[count++] = one;
        }

        contacts.RemoveRange(count, contacts.Count - count);
    }

    /// <summary>A contact with its deepest point and those that are not beside the line.</summary>
    private PairContacts WithoutBeside(in PairContacts contact, in PartsCover body)
    {
        ContactManifold kept = default;
        kept.Begin(contact.Manifold.Normal);
        int deepest = DeepestPoint.IndexIn(contact.Manifold);
        for (int k = 0; k < contact.Manifold.Count; k++)
            if (k == deepest || !IsBeside(contact.Manifold[k], body)) kept.Add(contact.Manifold[k]);
        return new PairContacts(contact.PartA, contact.PartB, contact.Result, kept, contact.Pair);
    }

    /// <summary>Whether another contact of the part that touches along the line is deeper the same way.</summary>
    private static bool IsAnyDeeper(List<PairContacts> contacts, in PairContacts one, bool isA)
    {
        Double3 normal = one.Manifold.Normal;
        foreach (PairContacts other in contacts)
        {
            bool isOfPart = isA ? other.PartB == one.PartB : other.PartA == one.PartA && other.Pair.A == one.Pair.A;
            if (isOfPart && other.Result.Distance < one.Result.Distance
                && (other.Manifold.Normal - normal).SumOfMagnitudes <= CoveredSides.Room)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Finds the line that a shape with a round side or edge shows to a surface, given the contact's
    /// normal.</summary>
    private static unsafe bool TryFind(
        in ConvexShape shape, in RigidPose pose, in Double3 outward, out TouchLine line)
    {
        FaceCorner* memory = stackalloc FaceCorner[FaceCorners.Capacity];
        var corners = new FaceCorners(memory);
        RotationD turn = new(pose.Rotation);
        Double3 local = turn.InverseRotate(-outward);
        shape.GetFace(local, ref corners);
        line = default;
        int count = corners.Count, first = 0, last = 1;
        if (count < 2 || (corners.Side == RoundSide.None && shape.Margin == 0)) return false;
        if (count > 2)
        {
            if (Math.Abs(Double3.Dot(ContactCone.UnitNormalOf(corners[0], corners[1], corners[2]), local)) > Tilted)
                return false;
            for (int i = 1; i < count; i++)
                if (Double3.Dot(corners[i] - corners[first], local) > 0) first = i;
            last = (first + 1) % count;
            int before = (first + count - 1) % count;
            if (Double3.Dot(corners[before] - corners[last], local) > 0) last = before;
        }

        Double3 along = turn.Rotate(corners[last] - corners[first]);
        line = new TouchLine(
            CoveredSides.InWorld(shape.Center + corners[first], pose), along, outward, shape.BoundingRadius);
        return true;
    }

    /// <summary>Whether a point is beside the line, seen along the normal, and a body goes on to the line.</summary>
    private bool IsBeside(in ManifoldPoint point, in PartsCover body)
    {
        Double3 foot = CoveredSides.FootOf(point, body.IsA, body.Side.Pose);
        Double3 from = _from - foot, end = from - _outward * Double3.Dot(from, _outward);
        Double3 way = _along - _outward * Double3.Dot(_along, _outward);
        double part = -Double3.Dot(end, way) / way.LengthSquared;
        Double3 to = end + way * Math.Max(0, Math.Min(part, 1));
        return to.Length > _least && body.Holds(foot + to * 0.5);
    }
}
