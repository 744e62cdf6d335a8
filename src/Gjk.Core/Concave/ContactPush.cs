namespace Gjk.Core;

/// <summary>Tests what the push of a contact does to other pairs of parts: B is moved along the contact's normal by its
/// depth. A pair that this takes apart is held by that contact, and needs none of its own.</summary>
internal static class ContactPush
{
    /// <summary>Ratio of depths: below it a depth is much less. At a half no face pushes more than twice as far as it
    /// must.</summary>
    public const float MuchLess = 0.5f;

    /// <summary>Count: the deepest pushes of so many directions are tried on pairs without contact. More costs time;
    /// with fewer some pairs get a contact that they do not need.</summary>
    private const int MostPushes = 16;

    /// <summary>Cosine of 8 degrees: contacts within it push the same way.</summary>
    private const float SameWay = 0.99f;

    /// <summary>Cosine of 60 degrees: a contact within it moves a body along a face by at least half its depth. With
    /// more, what is already pushed straight is pushed aslant, too.</summary>
    private const float Alike = 0.5f;

    /// <summary>Ratios: a push goes so much further than the contact is deep, and by this of the place, so that what
    /// was as deep is apart and not just touching. More takes shallow neighbours for held ones.</summary>
    private const float Further = 1.01f, Room = 8 * (float)ContactCone.Slack;

    /// <summary>How far a contact pushes.</summary>
    public static float LengthOf(in DistanceResult result) =>
        Further * Math.Max(-result.Distance, 0) + Room * (float)DeepestPoint.CoordinateSum(result);

    /// <summary>Adds the contacts of faces that are needed beside the others. Then adds what holds the pairs that no
    /// contact takes apart.</summary>
    /// <param name="scratch">The scratch with both sides, the contacts of faces and the orphans.</param>
    /// <param name="contacts">The contacts that need no others to be judged; sorted.</param>
    public static void AddNeeded(ConcaveScratch scratch, List<PairContacts> contacts)
    {
        InPlaceSort.Sort(contacts);
        int own = contacts.Count;
        if (scratch.FaceContacts.Count > 0) AddFaces(scratch, contacts);
        if (scratch.Orphans.Count > 0) AddOrphans(scratch, contacts, own);
        if (contacts.Count > own) InPlaceSort.Sort(contacts);
        RemoveTwice(contacts);
    }

    /// <summary>Takes the shallowest face first. Contacts at most half as deep as a face, and the faces before it, are
    /// collected before it is judged.</summary>
    private static void AddFaces(ConcaveScratch scratch, List<PairContacts> contacts)
    {
        List<FaceContact> faces = scratch.FaceContacts;
        List<(float Distance, int Contact)> others = scratch.Shallowest;
        others.Clear();
        for (int i = 0; i < contacts.Count; i++) others.Add((-contacts[i].Result.Distance, i));
        InPlaceSort.Sort(others);
        InPlaceSort.Sort(faces);
        scratch.Pushes.Clear();
        int next = 0, own = contacts.Count, nextFace = own;
        for (int i = faces.Count - 1; i >= 0; i--)
        {
            float much = faces[i].Contact.Result.Distance * MuchLess;
            for (; next < others.Count && -others[next].Distance > much; next++)
                Collect(contacts[others[next].Contact], scratch.Pushes);
            for (; nextFace < contacts.Count && contacts[nextFace].Result.Distance > much; nextFace++)
                Collect(contacts[nextFace], scratch.Pushes);
            if (IsNeeded(scratch, faces[i])) contacts.Add(Named(faces[i], contacts, own));
        }
    }

    /// <summary>Takes the deepest orphan first, as its push takes most others apart.</summary>
    private static void AddOrphans(ConcaveScratch scratch, List<PairContacts> contacts, int own)
    {
        List<FaceContact> orphans = scratch.Orphans;
        InPlaceSort.Sort(orphans);
        scratch.Pushes.Clear();
        foreach (PairContacts one in contacts) Collect(one, scratch.Pushes);
        foreach (FaceContact orphan in orphans)
        {
            if (IsHeld(scratch, orphan)) continue;
            contacts.Add(Named(orphan, contacts, own));
            Collect(orphan.Contact, scratch.Pushes);
        }
    }

    /// <summary>The contact of a face, named by its pair where the parts at its tip are apart and have a contact that
    /// pushes another way: of two crossing sheets each pair may show another side.</summary>
    /// <param name="face">The contact, and its pair.</param>
    /// <param name="contacts">With the others.</param>
    /// <param name="own">How many of them are sorted.</param>
    private static PairContacts Named(in FaceContact face, List<PairContacts> contacts, int own)
    {
        PairContacts one = face.Contact;
        int other = contacts.BinarySearch(0, own, one, null);
        bool isOther = other >= 0 && contacts[other].Result.Distance > 0 && AreApart(contacts[other], one);
        return isOther ? face.OfOwnParts : one;
    }

    /// <summary>Keeps the deepest contact of each pair of parts, with the points of another one along the same way;
    /// given sorted contacts.</summary>
    private static void RemoveTwice(List<PairContacts> contacts)
    {
        int kept = 0;
        for (int i = 0; i < contacts.Count; i++)
        {
            PairContacts one = contacts[i];
            if (kept == 0 || contacts[kept - 1].CompareTo(one) != 0) contacts[kept++] = one;
            else if (one.Result.Distance < contacts[kept - 1].Result.Distance)
                contacts[kept - 1] = WithPointsOf(one, contacts[kept - 1]);
            else contacts[kept - 1] = WithPointsOf(contacts[kept - 1], one);
        }

        contacts.RemoveRange(kept, contacts.Count - kept);
    }

    private static PairContacts WithPointsOf(in PairContacts deeper, in PairContacts other)
    {
        if (!deeper.Manifold.Normal.Equals(other.Manifold.Normal)) return deeper;
        ContactManifold all = deeper.Manifold;
        double same = Room * DeepestPoint.CoordinateSum(deeper.Result);
        for (int i = 0; i < other.Manifold.Count && all.Count < ContactManifold.Capacity; i++)
        {
            bool isThere = false;
            for (int j = 0; j < all.Count; j++)
                isThere |= ((Double3)all[j].PointB - other.Manifold[i].PointB).Length <= same;
            if (!isThere) all.Add(other.Manifold[i]);
        }

        return new PairContacts(deeper.PartA, deeper.PartB, deeper.Result, all, deeper.Pair);
    }

    /// <summary>Adds the push of a contact, unless one of its direction is as deep. What is level, as a pair is
    /// that may be an orphan, holds that pair.</summary>
    private static void Collect(in PairContacts contact, List<PairContacts> pushes)
    {
        if (!(contact.Result.Distance <= SeamContacts.LevelRoomOf(contact.Result))) return;
        int nearest = -1;
        float cosine = -2;
        for (int i = 0; i < pushes.Count; i++)
        {
            float found = Vector3.Dot(pushes[i].Manifold.Normal, contact.Manifold.Normal);
            if (found > cosine) (nearest, cosine) = (i, found);
        }

        if (cosine < SameWay && pushes.Count < MostPushes) pushes.Add(contact);
        else if (contact.Result.Distance < pushes[nearest].Result.Distance) pushes[nearest] = contact;
    }

    /// <summary>Makes orphans of contacts that another one makes needless: its push takes their parts apart, and theirs
    /// does not do that for it.</summary>
    public static void RemoveNeedless(ConcaveScratch scratch, List<PairContacts> contacts)
    {
        if (contacts.Count < 2) return;
        scratch.Pushes.Clear();
        foreach (PairContacts one in contacts) Collect(one, scratch.Pushes);
        int kept = 0;
        for (int i = 0; i < contacts.Count; i++)
        {
            if (IsNeedless(scratch, contacts[i])) scratch.Orphans.Add(new FaceContact(contacts[i]));
            else contacts[kept++] = contacts[i];
        }

        contacts.RemoveRange(kept, contacts.Count - kept);
    }

    /// <summary>Whether the contact of a face is needed: where a contact of another direction takes the two parts apart
    /// by much less, it is not the face that they meet, but what it ends at.</summary>
    private static bool IsNeeded(ConcaveScratch scratch, in FaceContact face)
    {
        foreach (PairContacts push in scratch.Pushes)
        {
            if (!AreApart(push, face.Contact)) continue;
            if (TakesApart(scratch, push, face) || IsHeldShorter(scratch, face, push)) return false;
        }

        return true;
    }

    /// <summary>Whether a collected push takes apart a pair that has no contact of its own.</summary>
    private static bool IsHeld(ConcaveScratch scratch, in FaceContact orphan)
    {
        foreach (PairContacts push in scratch.Pushes)
        {
            if (TakesApart(scratch, push, orphan) || IsPushedAlike(scratch, orphan, push)) return true;
            if (push.Result.Distance > orphan.Contact.Result.Distance * MuchLess && AreApart(push, orphan.Contact)
                && IsHeldShorter(scratch, orphan, push))
            {
                return true;
            }
        }

        return false;
    }

    private static bool IsNeedless(ConcaveScratch scratch, in PairContacts one)
    {
        if (!(one.Result.Distance < 0)) return false;
        var pair = new FaceContact(one);
        foreach (PairContacts push in scratch.Pushes)
        {
            if (push.Result.Distance < 0 && AreApart(push, one) && TakesApart(scratch, push, pair)
                && !TakesApart(scratch, one, new FaceContact(push)))
            {
                return true;
            }
        }

        return false;
    }

    private static bool AreApart(in PairContacts one, in PairContacts other) =>
        Vector3.Dot(one.Manifold.Normal, other.Manifold.Normal) < ContactCone.LeastCosine;

    /// <summary>Whether the pair itself has a much shorter way out than the face's, and its convex part is held by a
    /// contact.</summary>
    private static bool IsHeldShorter(ConcaveScratch scratch, in FaceContact face, in PairContacts other) =>
        AreOfOneConvex(scratch, face, other) && face.Own > face.Contact.Result.Distance * MuchLess;

    /// <summary>Whether a contact pushes a convex part along the face whose place the pair's own way took.</summary>
    private static bool IsPushedAlike(ConcaveScratch scratch, in FaceContact orphan, in PairContacts push) =>
        push.Result.Distance < 0 && Vector3.Dot(push.Manifold.Normal, orphan.Shortened) > Alike
            && AreOfOneConvex(scratch, orphan, push);

    private static bool AreOfOneConvex(ConcaveScratch scratch, in FaceContact face, in PairContacts other) =>
        face.IsOfA
            ? scratch.B.Mesh is null && other.PartB == face.PartB
            : scratch.SideOf(face.Contact.Pair.A, true).Mesh is null && other.PartA == face.PartA
                && other.Pair.A == face.Contact.Pair.A;

    /// <summary>Whether a push takes the parts of a pair apart, or goes half the way.</summary>
    private static bool TakesApart(ConcaveScratch scratch, in PairContacts push, in FaceContact pair)
    {
        Vector3 by = push.Manifold.Normal * LengthOf(push.Result);
        scratch.SelectGround(pair.Contact.Pair);

        // The parts are apart, and the contact is that of a face behind what they show each other.
        if (pair.Own > Math.Max(pair.Contact.Result.Distance, 0)) return !IsBehind(scratch, pair, by);
        float own = pair.Own;

        // Their distance grows by no less than the push along their own way, and by no more than the whole push.
        if (own + Vector3.Dot(by, pair.OwnNormal) > MuchLess * own) return true;
        if (own + ((Double3)by).Length < MuchLess * own) return false;
        ConvexShape roomA = default, roomB = default;
        PartSide a = scratch.A, b = scratch.B;
        float left = ConvexQuery.SignedDistance(
            a.ShapeOf(pair.PartA, ref roomA), a.Pose, b.ShapeOf(pair.PartB, ref roomB),
            new RigidPose(b.Pose.Rotation, b.Pose.Position + by)).Distance;

        // Parts that only touch are not apart while they slide.
        return own < 0 ? left >= 0 || left > MuchLess * own : left > 0;
    }

    /// <summary>Whether a point of a face's contact is still over the triangle and behind it after a push.</summary>
    private static bool IsBehind(ConcaveScratch scratch, in FaceContact face, Vector3 push)
    {
        PartSide mesh = face.IsOfA ? scratch.A : scratch.B;
        int sign = face.IsOfA ? 1 : -1;
        ContactManifold manifold = face.Contact.Manifold;
        RotationD turn = new(mesh.Pose.Rotation);
        Double3 normal = turn.InverseRotate(sign * manifold.Normal), shift = turn.InverseRotate(sign * push);
        var over = new TriangleColumn(mesh, face.IsOfA ? face.PartA : face.PartB, normal);
        for (int i = 0; i < manifold.Count; i++)
        {
            Double3 foot = face.IsOfA ? manifold[i].LocalPointA : manifold[i].LocalPointB;
            if (manifold[i].Gap + Double3.Dot(shift, normal) < 0 && over.Holds(foot + shift)) return true;
        }

        return false;
    }
}
