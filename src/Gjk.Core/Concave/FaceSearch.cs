namespace Gjk.Core;

/// <summary>Searches contacts along the faces of a pair's triangles, where the pair's own way out does not show: the
/// contact of a face that meets the other body's tip, and a stand-in, for a pair that nothing else holds.</summary>
/// <param name="scratch">The scratch with both sides.</param>
/// <param name="own">The pair's contact along its own way.</param>
/// <param name="plane">The plane of that contact.</param>
/// <param name="maxGap">In world units.</param>
internal ref struct FaceSearch(ConcaveScratch scratch, in PairContacts own, in ContactPlane plane, float maxGap)
{
    /// <summary>Cosine: triangles steeper to each other do not show which side of an open one is meant. With more, the
    /// tips of both sides are searched, which costs time only.</summary>
    private const double Steep = 0.1;

    /// <summary>Sine: faces that are tilted by no more lie on each other. Ten times more or less is as good for
    /// WheelAlongEdgeTests.</summary>
    private const double Level = 0.01;

    /// <summary>Ratio to a depth: the deepest point along a face may be less deep than the tip by this. If it is less
    /// deep, the points are not what the body shows there. At a tenth a rocking body keeps its points.</summary>
    private const double TipRoom = 0.1;

    /// <summary>Ratio of depths: a body beside a corner of a surface is pushed through it by at most this many times
    /// its own depth. With less, more bodies are pushed aslant; TipContactTests has some that 10 pushes too
    /// far.</summary>
    private const float FarLonger = 4;

    private readonly PairContacts _own = own;
    private readonly float _maxGap = Math.Max(maxGap, 0);
    private readonly ContactPlane _plane = plane;
    private FaceContact _best, _standIn;
    private double _bestTip;
    private bool _isGhost, _isLed;

    /// <summary>Tries the faces of both sides' triangles. If the own way only leans and one side is convex, only the
    /// face of the side that leans is tried.</summary>
    /// <param name="normal">The pair's own way from A to B, in the world.</param>
    /// <param name="fitA">How it fits A.</param>
    /// <param name="fitB">How it fits B.</param>
    /// <param name="shapeA">The part of A.</param>
    /// <param name="shapeB">The part of B.</param>
    public void Run(in Double3 normal, ContactFit fitA, ContactFit fitB, in ConvexShape shapeA, in ConvexShape shapeB)
    {
        bool isMeshA = scratch.A.IsTriangle(_own.PartA), isMeshB = scratch.B.IsTriangle(_own.PartB);
        _isGhost = fitA == ContactFit.Ghost || fitB == ContactFit.Ghost;
        bool isOne = !_isGhost && !(isMeshA && isMeshB);
        if (isMeshA && (!isOne || fitA >= fitB)) TryFace(true, normal, fitA, shapeA, shapeB);
        if (isMeshB && (!isOne || fitB > fitA)) TryFace(false, -normal, fitB, shapeA, shapeB);
    }

    /// <summary>Adds what was found to the contacts, or to those that are judged later.</summary>
    /// <param name="contacts">Gets the contact, if that needs no others to be judged.</param>
    public readonly void Add(List<PairContacts> contacts)
    {
        if (_best.IsThere)
        {
            float depth = _best.Contact.Result.Distance;
            bool isMuchDeeper = depth < 0 && _own.Result.Distance > depth * ContactPush.MuchLess;
            if (!_isGhost && !isMuchDeeper) contacts.Add(_best.OfOwnParts);
            else scratch.FaceContacts.Add(_best);
        }
        else if (_standIn.IsThere)
        {
            // A convex part keeps its own way, if the face's is far longer: it leads out, if not straight.
            bool isLong = (_standIn.IsOfA ? scratch.B : scratch.A).Mesh is null
                && _standIn.Contact.Result.Distance < FarLonger * _own.Result.Distance;
            scratch.Orphans.Add(isLong
                ? new FaceContact(_own, _own, _standIn.IsOfA, _standIn.Contact.Manifold.Normal)
                : _standIn);
        }
    }

    private void TryFace(bool isOfA, in Double3 own, ContactFit fit, in ConvexShape shapeA, in ConvexShape shapeB)
    {
        PartSide mesh = isOfA ? scratch.A : scratch.B, other = isOfA ? scratch.B : scratch.A;
        int triangle = isOfA ? _own.PartA : _own.PartB, part = isOfA ? _own.PartB : _own.PartA;
        ref readonly ConvexShape shape = ref isOfA ? ref shapeB : ref shapeA;
        Double3 face = ContactCone.NormalOf(mesh, triangle);
        if (face.LengthSquared == 0) return;
        if (!mesh.IsSolid && !IsFront(mesh, triangle, other, part, shape, face, own, fit)) face = -face;
        var tip = new TipContact(mesh, triangle, other, shape, face);
        if (tip.Gap > _maxGap) return;
        Double3 world = mesh.ToWorldDirection(face);
        bool isLed = TryClimb(other, part, -world, out int corner);
        TipContact led = isLed ? new TipContact(mesh, triangle, other, corner, face) : tip;
        if (_own.Result.Distance > 0 && !(isLed && led.IsOver) && tip.IsBeside(shape)) return;
        ContactFit tipFit = SeamContacts.Judge(other, part, -world);
        bool isShown = tipFit == ContactFit.Stays
            && !JoinedGrounds.GoesOn(scratch, other, part, tip.TipInWorld, -world);
        ContactManifold along = Along(isOfA ? world : -world, shapeA, shapeB);
        double share = IsLarger(mesh, other, shape) ? TipRoom : 0;
        isShown &= other.IsConvex || along.Count == 0 || IsAsDeep(along, tip.Gap, share);
        isLed = isLed && led.Gap <= 0 && !JoinedGrounds.GoesOn(scratch, other, part, led.TipInWorld, -world);
        if (!isShown && along.Count > 0 && tipFit != ContactFit.Ghost && MayLean(mesh, other, part, shape, world))
        {
            // The points where the other body ends, if its tip is elsewhere.
            ContactManifold level = other.HasJoints
                ? FlushSides.ShownPoints(along, -world, new PartsCover(scratch, !isOfA, _own), isFar: true)
                : along;
            // A solid that is deeper than a gap may be is pushed by its tip, so that all of it gets out; but a level
            // face keeps its own points, on which it stands.
            bool isDeeper = level.Count > 0 && isLed && !IsLevel(other, part, world)
                && ((led.IsOver && !IsAsDeep(level, led.Gap)) || (other.IsSolid && led.Gap < -2 * _maxGap));
            if (level.Count > 0 && !isDeeper)
            {
                KeepShallowest(_own.PartA, _own.PartB, level, isOfA, led.Gap);
                if (_own.Result.Distance < 0) StandIn(_own.PartA, _own.PartB, level, isOfA, false);
                return;
            }
        }

        if (tip.IsOver && (along.Count == 0 || !IsAsDeep(along, tip.Gap, share: 0))) along = tip.Manifold(isOfA);
        int ledA = isOfA ? triangle : corner / 3, ledB = isOfA ? corner / 3 : triangle;
        if (isShown && along.Count > 0) KeepShallowest(_own.PartA, _own.PartB, along, isOfA, tip.Gap);
        else if (isLed && !isShown && led.IsOver) KeepShallowest(ledA, ledB, led.Manifold(isOfA), isOfA, led.Gap);
        if (_own.Result.Distance >= 0) return;
        if (isLed && other.IsSolid) StandIn(ledA, ledB, led.Manifold(isOfA), isOfA, true);
        else StandIn(_own.PartA, _own.PartB, along.Count > 0 ? along : tip.Manifold(isOfA), isOfA, false);
    }

    /// <summary>Whether the points of a mesh's part are as deep as its tip: only the tip is known to be shown along the
    /// face, and not what lies beside it.</summary>
    /// <param name="manifold">The points.</param>
    /// <param name="tip">Its gap.</param>
    /// <param name="share">Ratio to the tip's depth: points may be less deep by this. It is 0 where the part's body is
    /// the larger one, as a floor is: what that shows far from the other body does not push the body aslant.</param>
    public static bool IsAsDeep(in ContactManifold manifold, double tip, double share = TipRoom)
    {
        DistanceResult deepest = DeepestPoint.ToResult(manifold, default);
        double room = share * Math.Abs(tip) + ContactCone.Slack * DeepestPoint.CoordinateSum(deepest);
        return deepest.Distance <= tip + room;
    }

    /// <summary>The points of the two parts along a direction, from A to B in the world.</summary>
    private readonly ContactManifold Along(in Double3 direction, in ConvexShape shapeA, in ConvexShape shapeB)
    {
        ContactManifold manifold = default;
        if (_plane.Normal.LengthSquared == 0) return manifold;
        ContactPlane plane = _plane;
        ConvexQuery.ContactsAlong(
            shapeA, scratch.A.Pose, shapeB, scratch.B.Pose, direction, _maxGap, ref plane, out manifold);
        return manifold;
    }

    /// <summary>Whether the other body's part may be pushed along a face to which it leans: along the larger body's
    /// face, or where the two faces are level.</summary>
    private static bool MayLean(PartSide mesh, PartSide other, int part, in ConvexShape shape, in Double3 face) =>
        IsLarger(mesh, other, shape) || (other.Mesh is not null && !other.IsJoined && IsLevel(other, part, face));

    /// <summary>Whether a triangle lies level across a direction in the world.</summary>
    public static bool IsLevel(PartSide other, int part, in Double3 face)
    {
        Double3 across = other.ToWorldDirection(ContactCone.NormalOf(other, part));
        return Double3.Cross(across, face).Length <= Level;
    }

    private static bool IsLarger(PartSide mesh, PartSide other, in ConvexShape shape) =>
        mesh.RadiusWith(shape) >= other.RadiusWith(shape);

    /// <summary>The corner to which the other side's mesh climbs from a part along a direction in the world.</summary>
    private static bool TryClimb(PartSide side, int part, in Double3 direction, out int corner)
    {
        corner = -1;
        return side.Mesh is not null
            && MeshClimb.TryFind(side.Mesh, part, side.ToLocalDirection(direction), out corner);
    }

    /// <summary>Whether an open surface's triangle pushes to the side of its normal: against the face of a solid, where
    /// that is not too steep; else to that of the own way, unless that is far from it; else to the side that the tip
    /// leaves by less.</summary>
    private static bool IsFront(
        PartSide mesh, int triangle, PartSide other, int part, in ConvexShape shape, in Double3 face,
        in Double3 own, ContactFit fit)
    {
        Double3 world = mesh.ToWorldDirection(face);
        if (!other.IsSolid)
        {
            return fit <= ContactFit.Leans
                ? Double3.Dot(world, own) >= 0
                : new TipContact(mesh, triangle, other, shape, -face).Gap
                    <= new TipContact(mesh, triangle, other, shape, face).Gap;
        }

        Double3 outward = other.ToWorldDirection(ContactCone.NormalOf(other, part));
        double against = Double3.Dot(world, outward);
        if (Math.Abs(against) > Steep) return against < 0;
        bool isFront = TryClimb(other, part, -world, out int front);
        if (!TryClimb(other, part, world, out int back) || !isFront) return isFront;
        return new TipContact(mesh, triangle, other, back, -face).Gap
            <= new TipContact(mesh, triangle, other, front, face).Gap;
    }

    /// <summary>Keeps the contact along which the other body's tip is the shallowest. Parts that do not overlap are not
    /// deeper than their gap may be, and nothing is deep where the bodies are apart.</summary>
    private void KeepShallowest(int partA, int partB, in ContactManifold manifold, bool isOfA, double tip)
    {
        PairContacts made = DeepestPoint.MakeContact(partA, partB, manifold, _own);
        double behind = -made.Result.Distance - ContactCone.Slack * DeepestPoint.CoordinateSum(made.Result);
        bool isBehind = _own.Result.Distance > 0 && behind > 0;
        if (isBehind && (behind > 2 * _maxGap || !(scratch.AreAnyTouching || scratch.IsOneInside)))
            return;
        if (_best.IsThere && _bestTip >= tip) return;
        (_best, _bestTip) = (new(made, _own, isOfA), tip);
    }

    /// <summary>Keeps a stand-in: a corner that the other side climbs to comes before other tips, then the
    /// shallowest.</summary>
    private void StandIn(int partA, int partB, in ContactManifold manifold, bool isOfA, bool isLed)
    {
        PairContacts made = DeepestPoint.MakeContact(partA, partB, manifold, _own);
        if (!(made.Result.Distance < 0) || (_isLed && !isLed)) return;
        if (_standIn.IsThere && _isLed == isLed && _standIn.Contact.Result.Distance >= made.Result.Distance) return;
        (_standIn, _isLed) = (new(made, _own, isOfA), isLed);
    }
}
