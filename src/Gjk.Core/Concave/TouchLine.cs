namespace Gjk.Core;

/// <summary>A round side or edge touches a face along a line. A part that ends beside that line has points there too,
/// which a body that goes on to the line, flat, does not show.</summary>
internal static class TouchLine
{
    /// <summary>Ratio to the radius of a part with a round side: what is beside its line by less is as deep as that,
    /// but for 2^-21 of the radius.</summary>
    private const double Beside = 1.0 / (1 << 10);

    /// <summary>Cosine of 6 degrees: a face that is tilted by more, as much as <see cref="MeetingEdges"/> allows, meets
    /// another one with its edge.</summary>
    private const double Tilted = 0.995;

    /// <summary>Takes out the points beside the lines of round sides; a contact's deepest only where another one is
    /// deeper the same way.</summary>
    public static void KeepOn(ConcaveScratch scratch, List<PairContacts> contacts)
    {
        if (!scratch.A.IsConvex) KeepOn(scratch, true, contacts);
        if (!scratch.B.IsConvex) KeepOn(scratch, false, contacts);
    }

    private static void KeepOn(ConcaveScratch scratch, bool isA, List<PairContacts> contacts)
    {
        PartSide side = isA ? scratch.A : scratch.B, other = isA ? scratch.B : scratch.A;
        if (other.Mesh is not null) return;
        RotationD toSide = new(side.Pose.Rotation);
        ConvexShape room = default, sideRoom = default;
        int count = 0;
        for (int i = 0; i < contacts.Count; i++)
        {
            PairContacts one = contacts[i];
            Double3 outward = isA ? one.Manifold.Normal : -one.Manifold.Normal;
            ref readonly ConvexShape shape = ref other.Part(Math.Max(isA ? one.PartB : one.PartA, 0), ref room);
            if (!TryFind(shape, other.Pose, -outward, out Double3 from, out Double3 along))
            {
                contacts[count++] = one;
                continue;
            }

            ref readonly ConvexShape own = ref side.Part(isA ? one.PartA : one.PartB, ref sideRoom);
            ContactManifold kept = default;
            kept.Begin(one.Manifold.Normal);
            for (int k = 0; k < one.Manifold.Count; k++)
            {
                Double3 foot = CoveredSides.FootOf(one.Manifold[k], isA, side.Pose);
                Double3 to = ToLine(from - foot, along, outward);
                Double3 between = toSide.InverseRotate(foot + to * 0.5 - side.Pose.Position);
                bool isBeside = to.Length > Beside * shape.BoundingRadius
                    && SeamContacts.IsOn(scratch, isA, own, between)
                    && (k > 0 || IsAnyDeeper(contacts, one, isA));
                if (!isBeside) kept.Add(one.Manifold[k]);
                else if (k == 0) break;
            }

            if (kept.Count > 0) contacts[count++] = new PairContacts(one.PartA, one.PartB, one.Result, kept);
        }

        contacts.RemoveRange(count, contacts.Count - count);
    }

    private static bool IsAnyDeeper(List<PairContacts> contacts, in PairContacts one, bool isA)
    {
        foreach (PairContacts other in contacts)
        {
            if ((isA ? other.PartB == one.PartB : other.PartA == one.PartA)
                && other.Result.Distance < one.Result.Distance
                && ((Double3)other.Manifold.Normal - one.Manifold.Normal).SumOfMagnitudes <= CoveredSides.Room)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The line that a shape with a round side or edge shows to a direction.</summary>
    private static unsafe bool TryFind(
        in ConvexShape shape, in RigidPose pose, in Double3 direction, out Double3 from, out Double3 along)
    {
        FaceCorner* memory = stackalloc FaceCorner[FaceCorners.Capacity];
        var corners = new FaceCorners(memory);
        RotationD turn = new(pose.Rotation);
        Double3 local = turn.InverseRotate(direction);
        shape.GetFace(local, ref corners);
        (from, along) = (default, default);
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

        from = CoveredSides.InWorld(shape.Center + corners[first], pose);
        along = turn.Rotate(corners[last] - corners[first]);
        return true;
    }

    /// <summary>From a point to the nearest one of a line, as seen along a normal.</summary>
    private static Double3 ToLine(in Double3 from, in Double3 along, in Double3 normal)
    {
        Double3 end = from - normal * Double3.Dot(from, normal), way = along - normal * Double3.Dot(along, normal);
        double part = -Double3.Dot(end, way) / way.LengthSquared;
        return end + way * Math.Max(0, Math.Min(part, 1));
    }
}
