namespace Gjk.Core;

/// <summary>What a pair of parts has along the faces of its triangles, where its own way out does not show: the contact
/// of a face that meets the other body's tip, and a stand-in, for a pair that nothing else holds.</summary>
/// <param name="scratch">With both sides.</param>
/// <param name="own">The pair's contact along its own way.</param>
/// <param name="plane">Of that.</param>
/// <param name="maxGap">In world units.</param>
internal ref struct FaceSearch(ConcaveScratch scratch, in PairContacts own, in ContactPlane plane, float maxGap)
{
    /// <summary>Cosine: triangles that are so steep to each other do not tell which side of an open one is meant.
    /// More asks for the tips of both sides, which costs time only.</summary>
    private const double Steep = 0.1;

    /// <summary>Sine: faces that are tilted by no more lie on each other. Ten times more or less is as good for
    /// WheelAlongEdgeTests.</summary>
    private const double Level = 0.01;

    /// <summary>Ratio to a depth: points along a face of which the deepest is less deep than the tip by more are not
    /// what the body shows there. At a tenth a rocking body keeps its points.</summary>
    private const double TipRoom = 0.1;

    /// <summary>Ratio of depths: a body beside a corner of a surface is not pushed through it by more than this. With
    /// less, more bodies are pushed aslant; TipContactTests has some that 10 pushes too far.</summary>
    private const float FarLonger = 4;

    private readonly PairContacts _own = own;
    private readonly float _maxGap = Math.Max(maxGap, 0);
    private readonly ContactPlane _plane = plane;
    private FaceContact _best, _standIn;
    private double _bestTip;
    private bool _isGhost, _isLed;

    /// <summary>Tries the faces of both sides' triangles; where the own way only leans and one side is convex, the one
    /// that leans.</summary>
    /// <param name="normal">The pair's own way from A to B, in the world.</param>
    /// <param name="fitA">What A makes of it.</param>
    /// <param name="fitB">What B makes of it.</param>
    /// <param name="shapeA">The part of A.</param>
    /// <param name="shapeB">The part of B.</param>
    public void Run(in Double3 normal, ContactFit fitA, ContactFit fitB, in ConvexShape shapeA, in ConvexShape shapeB)
    {
        bool isMeshA = scratch.A.IsTriangle(_own.PartA), isMeshB = scratch.B.IsTriangle(_own.PartB);
        _isGhost = fitA == ContactFit.Ghost || fitB == ContactFit.Ghost;
        bool isOne = !_isGhost && !(isMeshA && isMeshB);
        if (isMeshA && (!isOne || fitA >= fitB)) Try(true, normal, fitA, shapeA, shapeB);
        if (isMeshB && (!isOne || fitB > fitA)) Try(false, -normal, fitB, shapeA, shapeB);
    }

    /// <summary>Puts what was found where it belongs.</summary>
    /// <param name="contacts">Gets it, if it needs no others to be judged.</param>
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
            // Of a convex part the own way, where the face's is far longer: it leads out, if not straight.
            bool isLong = (_standIn.IsOfA ? scratch.B : scratch.A).Mesh is null
                && _standIn.Contact.Result.Distance < FarLonger * _own.Result.Distance;
            scratch.Orphans.Add(isLong
                ? new FaceContact(_own, _own, _standIn.IsOfA, _standIn.Contact.Manifold.Normal)
                : _standIn);
        }
    }

    private void Try(bool isOfA, in Double3 own, ContactFit fit, in ConvexShape shapeA, in ConvexShape shapeB)
    {
        PartSide mesh = isOfA ? scratch.A : scratch.B, other = isOfA ? scratch.B : scratch.A;
        int triangle = isOfA ? _own.PartA : _own.PartB, part = isOfA ? _own.PartB : _own.PartA;
        ref readonly ConvexShape shape = ref isOfA ? ref shapeB : ref shapeA;
        Double3 face = ContactCone.NormalOf(mesh, triangle);
        if (face.LengthSquared == 0) return;
        if (!mesh.IsSolid && !IsFront(mesh, triangle, other, part, shape, face, own, fit)) face = -face;
        var tip = new TipContact(mesh, triangle, other, shape, face);
        if (tip.Gap > _maxGap) return;
        Double3 world = new RotationD(mesh.Pose.Rotation).Rotate(face);
        bool isLed = TryClimb(other, part, -world, out int corner);
        TipContact led = isLed ? new TipContact(mesh, triangle, other, corner, face) : tip;
        ContactFit tipFit = SeamContacts.Judge(other, part, -world);
        bool isShown = tipFit == ContactFit.Stays
            && !JoinedGrounds.GoesOn(scratch, other, part, tip.Placed, -world);
        ContactManifold along = Along(isOfA ? world : -world, shapeA, shapeB);
        double share = IsLarger(mesh, other, shape) ? TipRoom : 0;
        isShown &= other.IsConvex || along.Count == 0 || IsAsDeep(along, tip.Gap, share);
        isLed = isLed && led.Gap <= 0 && !JoinedGrounds.GoesOn(scratch, other, part, led.Placed, -world);
        if (!isShown && along.Count > 0 && tipFit != ContactFit.Ghost && MayLean(mesh, other, part, shape, world))
        {
            ContactManifold level = Shown(along, other, part, shape.BoundingRadius, isOfA, -world);
            // A solid that is deeper than a gap may be is pushed by its tip, so that all of it comes out.
            bool isDeeper = level.Count > 0 && isLed && ((led.IsOver && !IsAsDeep(level, led.Gap))
                || (other.IsSolid && led.Gap < -2 * _maxGap));
            if (level.Count > 0 && !isDeeper)
            {
                Offer(_own.PartA, _own.PartB, level, isOfA, led.Gap);
                if (_own.Result.Distance < 0) StandIn(_own.PartA, _own.PartB, level, isOfA, false);
                return;
            }
        }

        if (along.Count == 0 && tip.IsOver) along = tip.Manifold(isOfA);
        int ledA = isOfA ? triangle : corner / 3, ledB = isOfA ? corner / 3 : triangle;
        if (isShown && along.Count > 0) Offer(_own.PartA, _own.PartB, along, isOfA, tip.Gap);
        else if (isLed && !isShown && led.IsOver) Offer(ledA, ledB, led.Manifold(isOfA), isOfA, led.Gap);
        if (_own.Result.Distance >= 0) return;
        if (isLed && other.IsSolid) StandIn(ledA, ledB, led.Manifold(isOfA), isOfA, true);
        else StandIn(_own.PartA, _own.PartB, along.Count > 0 ? along : tip.Manifold(isOfA), isOfA, false);
    }

    /// <summary>Whether the points of a mesh's part are as deep as its tip: only the tip is known to be shown along the
    /// face, and not what lies beside it.</summary>
    /// <param name="manifold">The points.</param>
    /// <param name="tip">Its gap.</param>
    /// <param name="share">Of the tip's depth: points that are less deep by no more count. None where the part's body
    /// is the larger one, as a floor is: what that shows far from the other body does not push that aslant.</param>
    public static bool IsAsDeep(in ContactManifold manifold, double tip, double share = TipRoom)
    {
        DistanceResult deepest = DeepestPoint.Result(manifold, default);
        double room = share * Math.Abs(tip) + ContactCone.Slack * DeepestPoint.PlaceOf(deepest);
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

    /// <summary>Whether the other body's part may be pushed along a face to which it leans: along that of the larger
    /// body, and else where they are level.</summary>
    private static bool MayLean(PartSide mesh, PartSide other, int part, in ConvexShape shape, in Double3 face)
    {
        if (IsLarger(mesh, other, shape)) return true;
        if (other.Mesh is null) return false;
        Double3 across = new RotationD(other.Pose.Rotation).Rotate(ContactCone.NormalOf(other, part));
        return Double3.Cross(across, face).Length <= Level;
    }

    private static bool IsLarger(PartSide mesh, PartSide other, in ConvexShape shape) =>
        mesh.RadiusWith(shape) >= other.RadiusWith(shape);

    /// <summary>The points along a face where the other body ends, if its tip is elsewhere.</summary>
    private readonly ContactManifold Shown(
        in ContactManifold along, PartSide other, int part, double size, bool isOfA, in Double3 outward)
    {
        if (!other.HasJoints) return along;
        ContactManifold shown = default;
        shown.Begin(along.Normal);
        for (int i = 0; i < along.Count; i++)
        {
            Double3 foot = CoveredSides.FootOf(along[i], !isOfA, other.Pose);
            Double3 beyond = FlushSides.JustBeyond(foot, outward, size);
            if (!JoinedGrounds.GoesOn(scratch, other, part, beyond, outward)) shown.Add(along[i]);
        }

        return shown;
    }

    /// <summary>The corner to which the other side's mesh climbs from a part along a direction in the world.</summary>
    private static bool TryClimb(PartSide side, int part, in Double3 direction, out int corner)
    {
        corner = -1;
        return side.Mesh is not null && MeshClimb.TryFind(
            side.Mesh, part, new RotationD(side.Pose.Rotation).InverseRotate(direction), out corner);
    }

    /// <summary>Whether an open surface's triangle pushes to the side of its normal: against the face of a solid, where
    /// that is not too steep; else to that of the own way, unless that is far from it; else to the side that the tip
    /// leaves by less.</summary>
    private static bool IsFront(
        PartSide mesh, int triangle, PartSide other, int part, in ConvexShape shape, in Double3 face,
        in Double3 own, ContactFit fit)
    {
        Double3 world = new RotationD(mesh.Pose.Rotation).Rotate(face);
        if (!other.IsSolid)
        {
            return fit <= ContactFit.Leans
                ? Double3.Dot(world, own) >= 0
                : new TipContact(mesh, triangle, other, shape, -face).Gap
                    <= new TipContact(mesh, triangle, other, shape, face).Gap;
        }

        Double3 outward = new RotationD(other.Pose.Rotation).Rotate(ContactCone.NormalOf(other, part));
        double against = Double3.Dot(world, outward);
        if (Math.Abs(against) > Steep) return against < 0;
        bool isFront = TryClimb(other, part, -world, out int front);
        if (!TryClimb(other, part, world, out int back) || !isFront) return isFront;
        return new TipContact(mesh, triangle, other, back, -face).Gap
            <= new TipContact(mesh, triangle, other, front, face).Gap;
    }

    /// <summary>Takes that along which the other body's tip is the shallowest. Parts that do not overlap are not deeper
    /// than their gap may be, and nothing is deep where the bodies are apart.</summary>
    private void Offer(int partA, int partB, in ContactManifold manifold, bool isOfA, double tip)
    {
        PairContacts made = DeepestPoint.Contact(partA, partB, manifold, _own);
        double behind = -made.Result.Distance - ContactCone.Slack * DeepestPoint.PlaceOf(made.Result);
        bool isBehind = _own.Result.Distance > 0 && behind > 0;
        if (isBehind && (behind > 2 * _maxGap || !(scratch.AreAnyTouching || Containment.TryFind(scratch, out _))))
            return;
        if (_best.IsThere && _bestTip >= tip) return;
        (_best, _bestTip) = (new(made, _own, isOfA), tip);
    }

    /// <summary>Takes a corner to which the other side climbs before other tips, and then the shallowest.</summary>
    private void StandIn(int partA, int partB, in ContactManifold manifold, bool isOfA, bool isLed)
    {
        PairContacts made = DeepestPoint.Contact(partA, partB, manifold, _own);
        if (!(made.Result.Distance < 0) || (_isLed && !isLed)) return;
        if (_standIn.IsThere && _isLed == isLed && _standIn.Contact.Result.Distance >= made.Result.Distance) return;
        (_standIn, _isLed) = (new(made, _own, isOfA), isLed);
    }
}
