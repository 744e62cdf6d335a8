namespace Gjk.Core;

/// <summary>The contact of two parts as their surfaces show it: as the convex query has it, along a triangle's normal
/// instead, or not at all.</summary>
internal static class SeamContacts
{
    /// <summary>Of a depth: less is much less. At a half no face pushes more than twice as far as it must.</summary>
    private const float MuchLess = 0.5f;

    /// <summary>Cosine: two triangles that are so steep to each other do not tell their sides.</summary>
    private const double Steep = 0.1;

    /// <summary>Ratio to a depth: so much less is the tip's.</summary>
    private const double TipRoom = 0.1;

    /// <summary>Count: so many corners a tip is looked for.</summary>
    private const int MostClimbs = 32;

    /// <summary>Finds the contact of two parts, or what may stand for it.</summary>
    public static void Find(ConcaveScratch scratch, in PartDistance pair, float maxGap, List<PartContacts> contacts)
    {
        PartSide a = scratch.A, b = scratch.B;
        int partA = pair.PartA, partB = pair.PartB;
        if ((a.IsSolid && IsInner(a.Mesh!, partA)) || (b.IsSolid && IsInner(b.Mesh!, partB))) return;
        ConvexShape roomA = default, roomB = default;
        ref readonly ConvexShape shapeA = ref a.Part(Math.Max(partA, 0), ref roomA);
        ref readonly ConvexShape shapeB = ref b.Part(Math.Max(partB, 0), ref roomB);
        ContactPlane plane = default;
        DistanceResult result = ConvexQuery.Contacts(
            shapeA, a.Pose, shapeB, b.Pose, maxGap, ref plane, out ContactManifold manifold);
        if (manifold.Count == 0) return;
        RotationD toA = new(a.Pose.Rotation), toB = new(b.Pose.Rotation);
        Double3 normal = plane.Normal.LengthSquared > 0
            ? plane.Frame.RotationA.Rotate(plane.Normal)
            : (Double3)result.Normal;
        ContactFit fitA = Judge(a, partA, toA.InverseRotate(normal));
        ContactFit fitB = Judge(b, partB, toB.InverseRotate(-normal));
        if (fitA == ContactFit.Stays && fitB == ContactFit.Stays)
        {
            if (IsJoint(scratch, a, true, pair, result, normal) || IsJoint(scratch, b, false, pair, result, -normal))
            {
                if (result.Distance < 0)
                {
                    scratch.Orphans.Add(new FaceContact(
                        new PartContacts(partA, partB, result, manifold), partA, partB, true, result.Distance));
                }

                return;
            }

            DeepestFirst(ref manifold);
            contacts.Add(new PartContacts(partA, partB, result, manifold));
            return;
        }

        if (result.Distance < 0 && TryTip(scratch, pair, result, normal, fitA, fitB, shapeA, shapeB)) return;
        var search = new FaceSearch(scratch, pair, result, plane, maxGap)
        {
            IsGhost = fitA == ContactFit.Ghost || fitB == ContactFit.Ghost,
        };
        bool isOne = !search.IsGhost && (a.Mesh is null || b.Mesh is null);
        if (a.Mesh is not null && (!isOne || fitA >= fitB)) search.Try(true, normal, fitA, shapeA, shapeB);
        if (b.Mesh is not null && (!isOne || fitB > fitA)) search.Try(false, -normal, fitB, shapeA, shapeB);
        if (search.Best.Manifold.Count > 0)
        {
            if (!search.IsGhost) contacts.Add(search.Best);
            else scratch.FaceContacts.Add(new FaceContact(
                search.Best, partA, partB, search.IsBestOfA, result.Distance));
        }
        else if (search.Fallback.Manifold.Count > 0 && result.Distance < 0)
        {
            // Of a convex part the own way, where the face's is much longer: it leads out, if not straight.
            bool isLong = (search.IsFallbackOfA ? b : a).Mesh is null
                && search.Fallback.Result.Distance * MuchLess < result.Distance;
            if (isLong) search.Fallback = new PartContacts(partA, partB, result, manifold);
            scratch.Orphans.Add(new FaceContact(search.Fallback, partA, partB, search.IsFallbackOfA, result.Distance));
        }
    }

    /// <summary>A convex part whose own way out shows, but not in the solid that goes on further into it: the solid's
    /// tip there.</summary>
    private static bool TryTip(
        ConcaveScratch scratch, in PartDistance pair, in DistanceResult result, in Double3 normal, ContactFit fitA,
        ContactFit fitB, in ConvexShape shapeA, in ConvexShape shapeB)
    {
        bool isConvexA = scratch.A.Mesh is null;
        PartSide convex = isConvexA ? scratch.A : scratch.B, solid = isConvexA ? scratch.B : scratch.A;
        if (convex.Mesh is not null || !solid.IsSolid || (isConvexA ? fitA : fitB) != ContactFit.Stays) return false;
        Double3 outward = isConvexA ? normal : -normal;
        RotationD toSolid = new(solid.Pose.Rotation);
        int triangle = isConvexA ? pair.PartB : pair.PartA;
        if (!TryClimb(solid, triangle, toSolid.InverseRotate(-outward), out int corner)) return false;
        Double3 local = solid.Mesh!.GetCorner(corner), tip = toSolid.Rotate(local) + solid.Pose.Position;
        ref readonly ConvexShape shape = ref isConvexA ? ref shapeA : ref shapeB;
        if (!ConvexQuery.Contains(shape, convex.Pose, (Vector3)tip)) return false;
        RotationD toConvex = new(convex.Pose.Rotation);
        shape.Support(toConvex.InverseRotate(outward), out Double3 most);
        Double3 top = toConvex.Rotate(shape.Center + most) + convex.Pose.Position + outward * shape.Margin;
        double gap = Double3.Dot(outward, tip - top);
        if (!(gap <= 0)) return false;
        Double3 foot = tip - outward * gap;
        var localFoot = (Vector3)toConvex.InverseRotate(foot - convex.Pose.Position);
        var point = new ManifoldPoint((Vector3)foot, (Vector3)tip, localFoot, (Vector3)local, (float)gap, 0);
        ContactManifold manifold = default;
        manifold.Begin((Vector3)normal);
        manifold.Add(isConvexA ? point : point.Swapped);
        int partA = isConvexA ? pair.PartA : corner / 3, partB = isConvexA ? corner / 3 : pair.PartB;
        scratch.FaceContacts.Add(new FaceContact(
            new PartContacts(partA, partB, Deepest(manifold, result), manifold), pair.PartA, pair.PartB, isConvexA,
            result.Distance));
        return true;
    }

    /// <summary>What is found along the faces of a pair's triangles.</summary>
    private ref struct FaceSearch
    {
        private readonly ConcaveScratch _scratch;
        private readonly PartDistance _pair;
        private readonly DistanceResult _result;
        private readonly float _maxGap;
        private ContactPlane _plane;
        private bool _isFallbackLed;

        public FaceSearch(
            ConcaveScratch scratch, in PartDistance pair, in DistanceResult result, in ContactPlane plane,
            float maxGap)
        {
            (_scratch, _pair, _result, _plane, _maxGap) = (scratch, pair, result, plane, maxGap);
            Best = Fallback = default;
            IsGhost = IsBestOfA = IsFallbackOfA = _isFallbackLed = false;
        }

        public PartContacts Best, Fallback;

        public bool IsGhost, IsBestOfA, IsFallbackOfA;

        /// <summary>Tries the faces of one side's triangle.</summary>
        public void Try(
            bool isOfA, in Double3 own, ContactFit fit, in ConvexShape shapeA, in ConvexShape shapeB)
        {
            PartSide mesh = isOfA ? _scratch.A : _scratch.B, other = isOfA ? _scratch.B : _scratch.A;
            int triangle = isOfA ? _pair.PartA : _pair.PartB, part = isOfA ? _pair.PartB : _pair.PartA;
            ref readonly ConvexShape shape = ref isOfA ? ref shapeB : ref shapeA;
            Double3 face = ContactCone.NormalOf(mesh.Mesh!, mesh.IsSolid, triangle);
            if (face.LengthSquared == 0) return;
            RotationD toMesh = new(mesh.Pose.Rotation), toOther = new(other.Pose.Rotation);
            if (!mesh.IsSolid) face *= SideOf(mesh, triangle, other, part, shape, face, toMesh.InverseRotate(own), fit);
            var tip = new TipContact(mesh, triangle, other, shape, face);
            if (tip.Gap > Math.Max(_maxGap, 0)) return;
            Double3 world = toMesh.Rotate(face), along = isOfA ? world : -world;
            bool isShown = Judge(other, part, toOther.InverseRotate(-world)) == ContactFit.Stays;
            ContactManifold manifold = default;
            if (_plane.Normal.LengthSquared > 0)
            {
                ContactPlane plane = _plane;
                ConvexQuery.ContactsAlong(shapeA, _scratch.A.Pose, shapeB, along, _maxGap, ref plane, out manifold);
            }

            // Of a mesh only its tip is known to be shown along the face, and not what lies beside it.
            bool hasTip = other.Mesh is null || manifold.Count == 0
                || Deepest(manifold, _result).Distance <= tip.Gap + TipRoom * Math.Abs(tip.Gap) + ContactCone.Slack;
            if (isShown && hasTip)
            {
                if (manifold.Count > 0 || tip.TryAdd(isOfA, mesh, _maxGap, ref manifold))
                    Offer(_pair.PartA, _pair.PartB, manifold, isOfA);
            }
            else if (other.Mesh is not null && TryClimb(other, part, toOther.InverseRotate(-world), out int corner))
            {
                var deep = new TipContact(mesh, triangle, other, corner, face);
                ContactManifold one = default;
                if (deep.TryAdd(isOfA, mesh, 0, ref one))
                    Offer(isOfA ? triangle : corner / 3, isOfA ? corner / 3 : triangle, one, isOfA);
            }

            // Where nothing else holds the pair: the tip that the other's part leads to, or that of the part.
            int partA = _pair.PartA, partB = _pair.PartB;
            bool isLed = other.Mesh is not null && other.IsSolid
                && TryClimb(other, part, toOther.InverseRotate(-world), out int led)
                && TryLed(isOfA, mesh, triangle, other, led, face, ref manifold, ref partA, ref partB);
            if (!isLed && manifold.Count == 0) tip.TryAdd(isOfA, mesh, _maxGap, ref manifold, true);
            if (manifold.Count == 0) return;
            PartContacts last = Made(partA, partB, manifold);
            if (!(last.Result.Distance < 0) || (_isFallbackLed && !isLed)) return;
            if (Fallback.Manifold.Count > 0 && _isFallbackLed == isLed
                && Fallback.Result.Distance >= last.Result.Distance)
            {
                return;
            }

            _isFallbackLed = isLed;
            Fallback = last;
            IsFallbackOfA = isOfA;
        }

        private static bool TryLed(
            bool isOfA, PartSide mesh, int triangle, PartSide other, int corner, in Double3 face,
            ref ContactManifold manifold, ref int partA, ref int partB)
        {
            var tip = new TipContact(mesh, triangle, other, corner, face);
            ContactManifold one = default;
            if (!tip.TryAdd(isOfA, mesh, 0, ref one, true)) return false;
            manifold = one;
            (partA, partB) = isOfA ? (triangle, corner / 3) : (corner / 3, triangle);
            return true;
        }

        /// <summary>1 or -1: the side of an open surface's triangle to which it pushes.</summary>
        private readonly double SideOf(
            PartSide mesh, int triangle, PartSide other, int part, in ConvexShape shape, in Double3 face,
            in Double3 own, ContactFit fit)
        {
            if (other.IsSolid)
            {
                Double3 outward = ContactCone.NormalOf(other.Mesh!, true, part);
                double against = Double3.Dot(
                    new RotationD(mesh.Pose.Rotation).Rotate(face),
                    new RotationD(other.Pose.Rotation).Rotate(outward));
                if (Math.Abs(against) > Steep) return against < 0 ? 1 : -1;
                RotationD toMesh = new(mesh.Pose.Rotation), toOther = new(other.Pose.Rotation);
                Double3 turned = toOther.InverseRotate(toMesh.Rotate(face));
                bool isFront = TryClimb(other, part, -turned, out int front);
                if (!TryClimb(other, part, turned, out int back) || !isFront) return isFront ? 1 : -1;
                return new TipContact(mesh, triangle, other, back, -face).Gap
                    > new TipContact(mesh, triangle, other, front, face).Gap ? -1 : 1;
            }
            else if (fit <= ContactFit.Leans)
            {
                return Double3.Dot(face, own) < 0 ? -1 : 1;
            }

            return new TipContact(mesh, triangle, other, shape, -face).Gap
                > new TipContact(mesh, triangle, other, shape, face).Gap ? -1 : 1;
        }

        private void Offer(int partA, int partB, in ContactManifold manifold, bool isOfA)
        {
            PartContacts made = Made(partA, partB, manifold);
            if (_result.Distance > 0 && made.Result.Distance < -2 * _maxGap - (float)ContactCone.Slack) return;
            if (Best.Manifold.Count > 0 && Best.Result.Distance >= made.Result.Distance) return;
            Best = made;
            IsBestOfA = isOfA;
        }

        private readonly PartContacts Made(int partA, int partB, ContactManifold manifold)
        {
            DeepestFirst(ref manifold);
            return new(partA, partB, Deepest(manifold, _result), manifold);
        }
    }

    /// <summary>Whether a triangle is there twice, once each way: a wall inside a solid.</summary>
    private static bool IsInner(TriangleMesh mesh, int triangle)
    {
        mesh.GetCorners(triangle, out _, out Double3 b, out Double3 c);
        int way = 0;
        for (CornerRing ring = mesh.SidesAt(3 * triangle); ring.MoveNext();)
        {
            Double3 after = mesh.GetCorner(ContactCone.After(ring.Current));
            Double3 before = mesh.GetCorner(ContactCone.Before(ring.Current));
            if (after == b && before == c) way++;
            else if (after == c && before == b) way--;
        }

        return way == 0;
    }

    /// <summary>From a triangle uphill along a direction, from corner to corner.</summary>
    private static bool TryClimb(PartSide side, int triangle, in Double3 direction, out int corner)
    {
        TriangleMesh mesh = side.Mesh!;
        corner = 3 * triangle;
        double height = Double3.Dot(direction, mesh.GetCorner(corner));
        for (int i = 1; i < 3; i++) Improve(mesh, 3 * triangle + i, direction, ref corner, ref height);
        for (int step = 0; step < MostClimbs; step++)
        {
            int before = corner, lowest = corner;
            for (CornerRing ring = mesh.SidesAt(before); ring.MoveNext();)
            {
                if (ring.Current < lowest) lowest = ring.Current;
                Improve(mesh, ContactCone.After(ring.Current), direction, ref corner, ref height);
                Improve(mesh, ContactCone.Before(ring.Current), direction, ref corner, ref height);
            }

            if (corner != before) continue;
            corner = lowest;
            return true;
        }

        return false;
    }

    private static void Improve(
        TriangleMesh mesh, int side, in Double3 direction, ref int corner, ref double height)
    {
        double found = Double3.Dot(direction, mesh.GetCorner(side));
        if (!(found > height)) return;
        (corner, height) = (side, found);
    }

    /// <summary>Whether a face's contact is needed: where a contact of another direction takes the two parts apart by
    /// much less, it is not the face that they meet, but what it ends at.</summary>
    /// <param name="scratch">With both sides.</param>
    /// <param name="face">The contact.</param>
    /// <param name="others">Those that are there.</param>
    /// <param name="count">How many of them.</param>
    /// <param name="isLast">Whether a contact of any direction and depth will do.</param>
    public static bool IsNeeded(
        ConcaveScratch scratch, in FaceContact face, List<PartContacts> others, int count, bool isLast)
    {
        for (int i = 0; i < count; i++)
        {
            PartContacts other = others[i];
            if (!(other.Result.Distance <= ContactCone.Slack)) continue;
            if (!isLast && (other.Result.Distance <= face.Contact.Result.Distance * MuchLess
                || Vector3.Dot(other.Manifold.Normal, face.Contact.Manifold.Normal) >= ContactCone.LeastCosine))
            {
                continue;
            }

            if (IsTakenApart(scratch, face, other)) return false;

            // Where the pair itself has a much shorter way out, and the same convex part is held from elsewhere.
            bool isSame = face.IsOfA
                ? scratch.B.Mesh is null && other.PartB == face.PartB
                : scratch.A.Mesh is null && other.PartA == face.PartA;
            bool isOther = Vector3.Dot(other.Manifold.Normal, face.Contact.Manifold.Normal) < ContactCone.LeastCosine
                && other.Result.Distance > face.Contact.Result.Distance * MuchLess;
            if (isSame && isOther && face.Own > face.Contact.Result.Distance * MuchLess) return false;
        }

        return true;
    }

    /// <summary>Takes out contacts that another one makes needless: its push takes their parts apart, and theirs do not
    /// do that for it.</summary>
    public static void RemoveNeedless(ConcaveScratch scratch, List<PartContacts> contacts)
    {
        for (int i = contacts.Count - 1; i >= 0; i--)
        {
            PartContacts one = contacts[i];
            if (!(one.Result.Distance < 0)) continue;
            bool isNeedless = false;
            for (int j = 0; j < contacts.Count && !isNeedless; j++)
            {
                PartContacts other = contacts[j];
                if (j == i || !(other.Result.Distance < 0)
                    || Vector3.Dot(other.Manifold.Normal, one.Manifold.Normal) >= ContactCone.LeastCosine)
                {
                    continue;
                }

                isNeedless = IsTakenApart(scratch, new FaceContact(one, one.PartA, one.PartB, true, one.Result.Distance), other)
                    && !IsTakenApart(scratch, new FaceContact(other, other.PartA, other.PartB, true, other.Result.Distance), one);
            }

            if (isNeedless) contacts.RemoveAt(i);
        }
    }

    /// <summary>Whether another part of a compound goes on where the contact of one of its parts is, and further: the
    /// parts are flush there, or in each other. Such a part is among the pairs, as it is as near.</summary>
    private static bool IsJoint(
        ConcaveScratch scratch, PartSide side, bool isA, in PartDistance pair, in DistanceResult result,
        in Double3 outward)
    {
        if (side.Compound is null) return false;
        List<PartDistance> pairs = scratch.Pairs;
        Double3 local = isA ? result.LocalPointA : result.LocalPointB;
        RotationD turn = new(side.Pose.Rotation);
        Double3 direction = turn.InverseRotate(outward);
        int mine = isA ? pair.PartA : pair.PartB;
        for (int i = 0; i < pairs.Count; i++)
        {
            int part = isA ? pairs[i].PartA : pairs[i].PartB;
            if (part == mine || (isA ? pairs[i].PartB != pair.PartB : pairs[i].PartA != pair.PartA)) continue;
            ref readonly ConvexShape shape = ref side.Compound.Parts[part];
            shape.Support(direction, out Double3 most);
            Double3 to = shape.Center + most + direction * shape.Margin - local;
            double length = to.Length;
            if (!(Double3.Dot(to, direction) > 8 * ContactCone.Slack * length)) continue;
            float near = ConvexQuery.Distance(shape, RigidPose.Identity, (Vector3)local, (float)length).Distance;
            if (near <= 4 * (float)ContactCone.Slack * (1 + (float)local.Length)) return true;
        }

        return false;
    }

    /// <summary>Whether the push of a contact takes the parts of another one apart, or goes half the way.</summary>
    private static bool IsTakenApart(ConcaveScratch scratch, in FaceContact face, in PartContacts push)
    {
        PartSide a = scratch.A, b = scratch.B;
        float reach = Math.Abs(push.Result.PointA.X) + Math.Abs(push.Result.PointA.Y)
            + Math.Abs(push.Result.PointA.Z);
        Vector3 by = push.Manifold.Normal
            * (1.01f * Math.Max(-push.Result.Distance, 0) + 8 * (float)ContactCone.Slack * (1 + reach));
        if (face.Own <= 0)
        {
            ConvexShape roomA = default, roomB = default;
            float left = ConvexQuery.SignedDistance(
                a.Part(Math.Max(face.PartA, 0), ref roomA), a.Pose, b.Part(Math.Max(face.PartB, 0), ref roomB),
                new RigidPose(b.Pose.Rotation, b.Pose.Position + by)).Distance;
            return left >= 0 || left > MuchLess * face.Own;
        }

        PartSide mesh = face.IsOfA ? a : b;
        ContactManifold manifold = face.Contact.Manifold;
        RotationD toMesh = new(mesh.Pose.Rotation);
        Double3 normal = toMesh.InverseRotate(face.IsOfA ? manifold.Normal : -manifold.Normal);
        Double3 shift = toMesh.InverseRotate(face.IsOfA ? by : -by);
        var tip = new TipContact(mesh, face.IsOfA ? face.PartA : face.PartB, mesh, 3 * (face.IsOfA ? face.PartA : face.PartB), normal);
        for (int i = 0; i < manifold.Count; i++)
        {
            Double3 foot = face.IsOfA ? manifold[i].LocalPointA : manifold[i].LocalPointB;
            if (manifold[i].Gap + Double3.Dot(shift, normal) < 0 && tip.IsOver(foot + shift)) return false;
        }

        return true;
    }

    private static ContactFit Judge(PartSide side, int part, in Double3 direction) =>
        side.Mesh is null || direction.LengthSquared == 0
            ? ContactFit.Stays
            : new ContactCone(side.Mesh, side.IsSolid, direction).Judge(part, out _);

    private static void DeepestFirst(ref ContactManifold manifold)
    {
        int deepest = 0;
        for (int i = 1; i < manifold.Count; i++)
            if (manifold[i].Gap < manifold[deepest].Gap) deepest = i;
        if (deepest == 0) return;
        ContactManifold before = manifold;
        manifold = default;
        manifold.Begin(before.Normal);
        manifold.Add(before[deepest]);
        for (int i = 0; i < before.Count; i++)
            if (i != deepest) manifold.Add(before[i]);
    }

    /// <summary>The deepest point of a manifold as a result.</summary>
    private static DistanceResult Deepest(in ContactManifold manifold, in DistanceResult before)
    {
        ManifoldPoint point = manifold[0];
        for (int i = 1; i < manifold.Count; i++)
            if (manifold[i].Gap < point.Gap) point = manifold[i];
        return new DistanceResult(
            point.Gap > 0 ? GjkStatus.Separated : GjkStatus.Overlapping, point.Gap,
            Math.Min(before.LowerBound, point.Gap), point.PointA, point.PointB, manifold.Normal, point.LocalPointA,
            point.LocalPointB, before.Iterations);
    }
}
