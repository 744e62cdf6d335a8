namespace Gjk.Core;

/// <summary>Finds the pair of parts that touches first: as <see cref="PartPairSearch"/>, with bounds of the fraction
/// instead of the distance.</summary>
/// <remarks>The fraction is bounded by the way that B's box goes, seen from A's, until they meet. For bodies that turn,
/// it is bounded by their distance where the search begins: that closes no faster than the velocities and the turns of
/// the furthest points allow. <see cref="PartAdvancement"/> chooses where it begins. Exactness: parts are cast up to
/// the float after the least fraction so far, since a later contact may still round to it. Of contacts that are equal
/// in <see cref="ContactOrder"/> the best feature stays, then the least numbers: the result is that of all pairs in
/// turn.</remarks>
internal struct PartCastSearch
{
    /// <summary>Ratio: 2^-18; more than rounding makes of the products with a fraction. More only costs time.</summary>
    private const double Beyond = 1 + 1.0 / (1 << 18);

    /// <summary>Ratio to the radii: 2^-14; more than the distance at which parts count as touching where the caller
    /// gives no tolerance (<see cref="ConvexQuery.DefaultTolerance"/>). More only costs time.</summary>
    private const double ImpactRoom = 1.0 / (1 << 14);

    /// <summary>Ratio to the radii: 2^-6; more than the tolerance that a caller may ask for of any two parts
    /// (<see cref="ConvexQuery.CoarsestTolerance"/>). More only costs time, counted by ImpactAgreementTests.</summary>
    private const double MostRoom = 1.0 / (1 << 6);

    /// <summary>Count: a plane is tried after so many parts, and after each doubling. A matter of speed.</summary>
    private const int IdleBeforeProof = 16;

    /// <summary>Bits: even powers of two. There a triangle's own plane is tried, else that of the distance.</summary>
    private const int OtherPowers = 0x55555555;

    /// <summary>Ratio to the radii: 2^-40, more than rounding makes of a cast's way, so that no part is excluded whose
    /// fraction rounds to the largest one. More only costs time. Pinned by SmallBesideLargeTests.</summary>
    private const double WayError = 1.0 / (1L << 40);

    private PartMotion _motion;
    private TreeFrame _frame;
    private TrianglesApart _triangles;
    private Vector3 _wayInA, _wayInB;
    private double _length, _maxFraction, _from, _to, _margins;
    private float _reached, _room;

    /// <summary>The best contact so far, by the fraction of the whole motion, or a ray's distance.</summary>
    private ContactOrder _best;

    /// <summary>B's motion from its pose outside the union, if it begins deeper in that than is allowed.</summary>
    private RigidMotion _lifted;
    private Double3 _lift, _wayOfLifted;
    private CastOptions _liftedOptions;
    private bool _isLifted;

    /// <summary>Which sides a ray meets.</summary>
    public RaySides Sides;

    /// <summary>Gets every hit of a ray, where it is not null.</summary>
    public List<RayHit>? CollectedRays;

    /// <summary>Gets every hit of a cast, where it is not null.</summary>
    public List<CastHit>? CollectedCasts;

    /// <summary>The first contact of a cast or impact; for a ray see <see cref="Ray"/>.</summary>
    public CastResult Cast;

    /// <inheritdoc cref="Cast"/>
    public RayCastResult Ray;

    /// <summary>Which features of the parts meet.</summary>
    public MetFeature Feature;

    /// <summary>The parts that touch first; negative where there are none.</summary>
    public int PartA, PartB;

    /// <summary>How many pairs of parts were cast, and how many pieces and distances of the bodies.</summary>
    public int QueryCount, Steps;

    /// <summary>How many pairs of parts the boxes left.</summary>
    private int _met;

    /// <summary>The motion, or the ray.</summary>
    public readonly PartMotion Motion => _motion;

    /// <summary>World units per fraction: the fastest that any distance closes.</summary>
    public readonly double Speed => _length;

    /// <summary>The largest fraction that may still be the least.</summary>
    public readonly double LastFraction => Math.Min(_maxFraction, _best.Solved);

    /// <summary>World units: parts of an impact further apart than this do not touch.</summary>
    public readonly double TouchRoom =>
        Math.Max(Math.Min(_motion.Tolerance, MostRoom * Size), ImpactRoom * Size) * Beyond;

    /// <summary>Parts that are apart up to this fraction are no first contact, whatever rounding makes of the
    /// way.</summary>
    private readonly double FurthestFraction => LastFraction
        + (_motion.Kind == MotionKind.Cast ? WayError * Size / Math.Max(_length, double.Epsilon) : 0);

    private readonly double Size => (_frame.RadiusA + _frame.RadiusB) * _frame.Unit + _margins;

    /// <summary>Prepares a search.</summary>
    public void Reset(ConcaveScratch scratch, in PartMotion motion)
    {
        PartSide sideA = scratch.A, sideB = scratch.B;
        _motion = motion;
        _maxFraction = Math.Max(motion.MaxFraction, 0);
        _margins = sideA.Margin + sideB.Margin;
        (_from, _to) = (0, double.PositiveInfinity);
        ComposeFrame(scratch, 0);
        Double3 way = motion.Way;
        _triangles = new TrianglesApart(sideA, sideB, _frame, way);
        _length = motion.Kind == MotionKind.Impact
            ? way.Length + Spin(sideA, motion.A.AngularVelocity) + Spin(sideB, motion.B.AngularVelocity)
            : PartMotion.Length(way);
        Double3 unit = _length > 0 ? way * (1 / _length) : default;
        Double3 inA = _frame.RotationA.InverseRotate(unit);
        _wayInA = (Vector3)inA;
        _wayInB = (Vector3)_frame.Rotation.InverseRotate(-inA);
        PartA = PartB = -1;
        _isLifted = false;
        QueryCount = Steps = _met = 0;
        _best = new ContactOrder(double.PositiveInfinity, CastStatus.Miss, 0);
        SetReached(_maxFraction);
    }

    /// <summary>Also passes contacts that get no deeper from another pose of B, outside the union.</summary>
    public void SetLifted(in RigidPose pose, in Double3 lift)
    {
        bool turns = (_motion.A.AngularVelocity, _motion.B.AngularVelocity) != default;
        (_isLifted, _lift, _wayOfLifted) = (true, lift, turns ? default : _motion.Way);
        _lifted = new RigidMotion(pose, _motion.B.Velocity, _motion.B.AngularVelocity);
        // By no more than rounding: it begins deeper than is allowed, and what it sinks by in short steps adds up.
        _liftedOptions = CastOptions.OnlyDeeper(UnionLift.RoundingOf(_motion.A.Pose) + UnionLift.RoundingOf(pose));
    }

    /// <summary>Restricts the search to a piece of the motion, of parts that do not touch before it.</summary>
    /// <param name="scratch">With both sides posed at the first fraction.</param>
    /// <param name="from">The fraction that it begins at.</param>
    /// <param name="to">The one that it ends at.</param>
    /// <param name="rounding">World units: by so much the poses may differ from those of the motion.</param>
    public void RestrictTo(ConcaveScratch scratch, double from, double to, double rounding)
    {
        (_from, _to) = (from, to);
        ComposeFrame(scratch, rounding);
        SetReached(LastFraction);
    }

    private void ComposeFrame(ConcaveScratch scratch, double rounding)
    {
        PartSide sideA = scratch.A, sideB = scratch.B;
        TreeFrame.Compose(sideA.Tree, sideA.Pose, sideB.Tree, sideB.Pose, _margins, out _frame);
        _room = (float)(((_margins + rounding) / _frame.Unit + _frame.Room) * Beyond) + float.Epsilon;
    }

    /// <summary>Finds the first contact.</summary>
    public static unsafe void Run(ConcaveScratch scratch)
    {
        ref PartCastSearch search = ref scratch.CastSearch;
        if (search._motion.Kind == MotionKind.Cast && search._length == 0)
        {
            // Parts that share no point at the start never meet.
            PartPairSearch.Collect(scratch, 0, scratch.Pairs);
            foreach (PairDistance pair in scratch.Pairs)
                search.CastParts(scratch, Math.Max(pair.PartA, 0), Math.Max(pair.PartB, 0));
            return;
        }

        PartTree a = scratch.A.Tree, b = scratch.B.Tree;
        float* bounds = stackalloc float[PartTree.Lanes];
        PartHeap heap = scratch.Heap;
        PlaneProof plane = scratch.Plane;
        plane.BeginCast(scratch.A, scratch.B, search._motion.Way);
        heap.Clear();
        heap.Push(0, 0, 0);
        fixed (float* boxesA = a.Boxes, boxesB = b.Boxes)
        {
            while (heap.TryPop(out PartHeap.Entry pair) && pair.Bound <= search._reached)
            {
                if (plane.IsUntried && plane.IsWholeNoNearer(scratch.A, scratch.B)) return;
                if (plane.IsSet && plane.IsNoNearer(scratch.A, pair.A, scratch.B, pair.B)) continue;
                int childA = a.Children[pair.A], childB = b.Children[pair.B];
                if (childA < 0 && childB < 0)
                {
                    search.CastLeaves(scratch, childA, childB);
                    continue;
                }

                bool isA = search._frame.ChooseOpened(
                    boxesA, pair.A, childA, boxesB, pair.B, childB, out float* node, out float factor,
                    out TurnedBox other);
                search.FindBounds(isA, node, factor, other, bounds);
                heap.PushChildren(pair, isA, isA ? a.Children : b.Children, bounds, search._reached);
            }
        }
    }

    /// <summary>The speed of a side's furthest point about its position.</summary>
    private static double Spin(PartSide side, Vector3 turn) =>
        PartMotion.Length(turn) * (PartMotion.Length(side.Tree.Origin) + side.Tree.Radius + side.Margin) * Beyond;

    /// <summary>Sets what bounds are compared with, for a fraction or a ray's distance.</summary>
    private void SetReached(double fraction)
    {
        double along = Math.Min(fraction, _to) - _from;
        double length = _motion.Kind == MotionKind.Ray ? 1 : _length;
        double way = length > 0 ? along * length * Beyond / _frame.Unit : 0;
        if (_motion.Kind == MotionKind.Impact) way += _room + TouchRoom / _frame.Unit;
        _reached = _motion.Kind == MotionKind.Impact ? BoxLanes.Squared(way) : BoxLanes.AtMost(way * Beyond);
    }

    private readonly unsafe void FindBounds(bool isA, float* node, float factor, in TurnedBox other, float* bounds)
    {
        if (_motion.Kind == MotionKind.Impact) BoxLanes.DistanceSquared(node, factor, other, _frame.Room, bounds);
        else BoxLanes.Entries(node, factor, other, isA ? _wayInA : _wayInB, _room, bounds);
    }

    private void CastLeaves(ConcaveScratch scratch, int leafA, int leafB)
    {
        int firstA = PartTree.FirstOf(leafA), endA = firstA + PartTree.CountOf(leafA);
        int firstB = PartTree.FirstOf(leafB), endB = firstB + PartTree.CountOf(leafB);
        for (int i = firstA; i < endA; i++)
            for (int j = firstB; j < endB; j++) CastParts(scratch, scratch.A.Tree.Order[i], scratch.B.Tree.Order[j]);
    }

    /// <summary>Casts two parts, and keeps their contact if it is the first.</summary>
    public void CastParts(ConcaveScratch scratch, int partA, int partB)
    {
        bool isIdle = ++_met >= IdleBeforeProof && _motion.Kind == MotionKind.Cast && _length > 0;
        if (isIdle && (_met & (_met - 1)) == 0) TrySetPlane(scratch, partA, partB);
        if (isIdle && _triangles.StayApart(partA, partB, FurthestFraction)) return;
        QueryCount++;

        // Which contacts are passed depends on the whole way; so does where an impact's steps end.
        bool isImpact = _motion.Kind == MotionKind.Impact;
        bool isWhole = PartA < 0 || CollectedCasts is not null || _motion.Options.PassesShallow || isImpact;
        var most = (float)Math.Min(
            _maxFraction, isWhole ? double.PositiveInfinity : RoundOff.Up((float)FurthestFraction));
        if (_motion.Kind == MotionKind.Ray)
        {
            RayCastResult met = PartQuery.RayCast(scratch.A, partA, _motion, Sides, most);
            if (CollectedRays is not null && met.IsHit) CollectedRays.Add(new RayHit(met, scratch.A.NumberOf(partA)));
            else if (met.IsHit && KeepMet(scratch, new CastHit(met.ToCast(), partA, partB, MetFeature.None))) Ray = met;
            return;
        }

        ConvexShape roomA = default, roomB = default;
        ref readonly ConvexShape a = ref scratch.A.ShapeOf(partA, ref roomA);
        ref readonly ConvexShape b = ref scratch.B.ShapeOf(partB, ref roomB);
        if (isImpact && !double.IsInfinity(_to) && ConvexQuery.StaysApart(
            a, _motion.A, b, _motion.B, _motion.Tolerance, (float)_maxFraction, _from, _to)) return;
        CastResult found = CastShapes(a, b, _motion.B, most, _motion.Options);
        if (!found.MayHit || (CollectedCasts is null && PartA >= 0 && found.Order.CompareTo(_best) > 0)) return;
        if (_isLifted && !UnionLift.IsOutOf(found, _lifted.Pose, _lift, _wayOfLifted, 1)
            && !CastShapes(a, b, _lifted, most, _liftedOptions).MayHit) return;
        MetFeature feature = MetFeature.None;
        if (found.Status == CastStatus.Hit)
        {
            feature = MetFeatures.Of(
                a, PartAdvancement.PoseAt(_motion.A, found.Fraction), b,
                PartAdvancement.PoseAt(_motion.B, found.Fraction), found.Normal);
        }

        if (CollectedCasts is not null)
            CollectedCasts.Add(new CastHit(found, scratch.A.NumberOf(partA), scratch.B.NumberOf(partB), feature));
        else KeepMet(scratch, new CastHit(found, partA, partB, feature));
    }

    /// <summary>Keeps a contact among those that are met at the same fraction, and as the first if it comes before the
    /// best one.</summary>
    private bool KeepMet(ConcaveScratch scratch, in CastHit hit)
    {
        ContactOrder found = hit.Result.Order;
        int order = PartA < 0 ? -1 : found.CompareTo(_best);
        if (order < 0) scratch.Met.Clear();
        if (order <= 0) scratch.Met.Add(hit);
        if (order == 0) order = (int)hit.Feature - (int)Feature;
        if (order == 0) order = hit.PartA.CompareTo(PartA);
        if (order == 0) order = hit.PartB.CompareTo(PartB);
        if (order >= 0) return false;
        (_best, Cast, Feature, PartA, PartB) = (found, hit.Result, hit.Feature, hit.PartA, hit.PartB);
        SetReached(found.Solved);
        return true;
    }

    /// <summary>Sets the plane of two parts that are apart at the start. Where many parts pass closely, the boxes'
    /// bounds in float rule none of them out.</summary>
    private readonly void TrySetPlane(ConcaveScratch scratch, int partA, int partB)
    {
        DistanceResult start = PartQuery.Distance(scratch.A, partA, scratch.B, partB, float.PositiveInfinity);
        if (start.Status != GjkStatus.Separated) return;
        scratch.Plane.SetCast(
            scratch.A, partA, scratch.B, partB, start.Normal, (_met & OtherPowers) != 0, FurthestFraction);
    }

    private readonly CastResult CastShapes(
        in ConvexShape a, in ConvexShape b, in RigidMotion motionB, float most, in CastOptions options) =>
        _motion.Kind == MotionKind.Cast
            ? ConvexQuery.Cast(a, _motion.A.Pose, _motion.A.Velocity, b, motionB.Pose, motionB.Velocity, most, options)
            : ConvexQuery.TimeOfImpact(a, _motion.A, b, motionB, _motion.Tolerance, most, options);
}
