namespace Gjk.Core;

/// <summary>A round side or edge touches a face along a line. A part that ends beside that line has points there too,
/// which a body that goes on to the line, flat, does not show.</summary>
internal readonly struct TouchLine(in Double3 from, in Double3 along, in Double3 outward, double radius)
{
    /// <summary>Ratio to the radius of a part with a round side: what is beside its line by less is as deep as that,
    /// but for 2^-21 of the radius.</summary>
    private const double Beside = 1.0 / (1 << 10);

    /// <summary>Cosine of 6 degrees: a face that is tilted by more, as much as <see cref="MeetingEdges"/> allows, meets
    /// another one with its edge.</summary>
    private const double Tilted = 0.995;

    private readonly Double3 _from = from, _along = along, _outward = outward;
    private readonly double _least = Beside * radius;

    /// <summary>Takes out the points beside the lines of round sides; a contact's deepest only where another one is
    /// deeper the same way.</summary>
    public static void KeepOn(ConcaveScratch scratch, List<PairContacts> contacts)
    {
        if (!scratch.A.IsConvex) KeepOn(scratch, true, contacts);
        if (!scratch.B.IsConvex) KeepOn(scratch, false, contacts);
    }

    private static void KeepOn(ConcaveScratch scratch, bool isA, List<PairContacts> contacts)
    {
        ConvexShape room = default;
        int count = 0;
        for (int i = 0; i < contacts.Count; i++)
        {
            PairContacts one = contacts[i];
            PartSide other = scratch.SideOf(one.Pair.A, !isA);
            Double3 outward = isA ? one.Manifold.Normal : -one.Manifold.Normal;
            ref readonly ConvexShape shape = ref other.Part(one.PartOf(!isA), ref room);
            if (other.Mesh is null && TryFind(shape, other.Pose, outward, out TouchLine line))
            {
                var cover = new PartsCover(scratch, isA, one);
                ManifoldPoint deepest = one.Manifold[DeepestPoint.Of(one.Manifold)];
                if (line.IsBeside(deepest, cover) && IsAnyDeeper(contacts, one, isA)) continue;
                one = line.KeepOn(one, cover);
            }

            contacts[count++] = one;
        }

        contacts.RemoveRange(count, contacts.Count - count);
    }

    /// <summary>A contact with its deepest point and those that are not beside the line.</summary>
    private PairContacts KeepOn(in PairContacts contact, in PartsCover body)
    {
        ContactManifold kept = default;
        kept.Begin(contact.Manifold.Normal);
        int deepest = DeepestPoint.Of(contact.Manifold);
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

    /// <summary>The line that a shape with a round side or edge shows to a surface, whose way out is given.</summary>
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
            if (Math.Abs(Double3.Dot(ContactCone.FaceOf(corners[0], corners[1], corners[2]), local)) > Tilted)
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

    /// <summary>Whether a point is beside the line, as seen along the way out, and a body goes on to that.</summary>
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
