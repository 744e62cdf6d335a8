namespace Gjk.Core;

/// <summary>The pair of parts that touches first: as <see cref="PartPairSearch"/>, with bounds of the fraction instead
/// of the distance.</summary>
/// <remarks>The way that B's box goes, seen from A's, until they meet bounds the fraction; of bodies that turn, their
/// distance where the search begins, which closes no faster than the velocities and the turns of the furthest points
/// allow. <see cref="PartAdvancement"/> says where that is. Exactness: parts are asked up to the float after the least
/// fraction so far, since a contact may be found behind it and still round to it; of those that are equal in
/// <see cref="ContactOrder"/> the best feature stays, then the least numbers: that of all pairs in turn.</remarks>
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

    /// <summary>Count: after so many parts, and each twice as many, a plane is tried. Only the cost changes.</summary>
    private const int IdleBeforeProof = 16;

    /// <summary>Bits: even powers of two; there a triangle's own plane is tried, else a distance's.</summary>
    private const int OtherPowers = 0x55555555;

    /// <summary>Ratio to the radii: 2^-40; more than rounding makes of a cast's way, so that a largest fraction cuts
    /// off none that another part's rounds to. More only costs time. Pinned by SmallBesideLargeTests.</summary>
    private const double WayError = 1.0 / (1L << 40);

    private PartMotion _motion;
    private TreeFrame _frame;
    private Vector3 _wayInA, _wayInB;
    private double _length, _maxFraction, _from, _to, _margins;
    private float _reached, _room;

    /// <summary>The best so far, by the fraction of the whole motion, or a ray's distance.</summary>
    private ContactOrder _best;

    /// <summary>B's motion from where it is out of the union, if it begins deeper in that than is allowed.</summary>
    private RigidMotion _lifted;
    private Double3 _lift, _wayOfLifted;
    private CastOptions _liftedOptions;
    private bool _isLifted;

    /// <summary>Which sides a ray meets.</summary>
    public RaySides Sides;

    /// <summary>Takes every hit of a ray, where it is not null.</summary>
    public List<RayHit>? All;

    /// <summary>Takes every pair that is met, where it is not null.</summary>
    public List<CastHit>? AllCasts;

    /// <summary>What the parts said; of a ray the other one.</summary>
    public CastResult Cast;

    /// <inheritdoc cref="Cast"/>
    public RayCastResult Ray;

    /// <summary>What of the parts meets.</summary>
    public MetFeature Feature;

    /// <summary>The parts that touch first; negative where there are none.</summary>
    public int PartA, PartB;

    /// <summary>How many pairs of parts were looked at, and how many pieces and distances of the bodies there
    /// were.</summary>
    public int Asked, Steps;

    /// <summary>World units per fraction: no faster does any distance close.</summary>
    public readonly double Speed => _length;

    /// <summary>The last fraction that may still be the least.</summary>
    public readonly double Last => Math.Min(_maxFraction, _best.Solved);

    /// <summary>World units: parts of an impact that are further apart do not touch.</summary>
    public readonly double TouchRoom =>
        Math.Max(Math.Min(_motion.Tolerance, MostRoom * Size), ImpactRoom * Size) * Beyond;

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
        _length = motion.Kind == MotionKind.Impact
            ? way.Length + Spin(sideA, motion.A.AngularVelocity) + Spin(sideB, motion.B.AngularVelocity)
            : Length(way);
        Double3 unit = _length > 0 ? way * (1 / _length) : default;
        Double3 inA = _frame.RotationA.InverseRotate(unit);
        _wayInA = (Vector3)inA;
        _wayInB = (Vector3)_frame.Rotation.InverseRotate(-inA);
        PartA = PartB = -1;
        _isLifted = false;
        Asked = Steps = 0;
        _best = new ContactOrder(double.PositiveInfinity, CastStatus.Miss, 0);
        SetReached(_maxFraction);
    }

    /// <summary>Passes also what B does not get deeper into if it begins elsewhere.</summary>
    public void Lift(in RigidPose pose, in Double3 lift)
    {
        bool turns = (_motion.A.AngularVelocity, _motion.B.AngularVelocity) != default;
        (_isLifted, _lift, _wayOfLifted) = (true, lift, turns ? default : _motion.Way);
        _lifted = new RigidMotion(pose, _motion.B.Velocity, _motion.B.AngularVelocity);
        _liftedOptions = UnionLift.Within(UnionLift.RoundingOf(_motion.A.Pose) + UnionLift.RoundingOf(pose));
    }

    /// <summary>Looks at a piece of the motion only, of parts that do not touch before it.</summary>
    /// <param name="scratch">With both sides posed at the first fraction.</param>
    /// <param name="from">The fraction that it begins at.</param>
    /// <param name="to">The one that it ends at.</param>
    /// <param name="rounding">World units: so far the sides may be from where the motion has them.</param>
    public void RestrictTo(ConcaveScratch scratch, double from, double to, double rounding)
    {
        (_from, _to) = (from, to);
        ComposeFrame(scratch, rounding);
        SetReached(Last);
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
                search.Ask(scratch, Math.Max(pair.PartA, 0), Math.Max(pair.PartB, 0));
            return;
        }

        PartTree a = scratch.A.Tree, b = scratch.B.Tree;
        float* bounds = stackalloc float[PartTree.Lanes];
        PartHeap heap = scratch.Heap;
        PlaneProof plane = scratch.Plane;
        plane.Clear();
        heap.Clear();
        heap.Add(0, 0, 0);
        fixed (float* boxesA = a.Boxes, boxesB = b.Boxes)
        {
            while (heap.TryTake(out PartHeap.Entry pair) && pair.Bound <= search._reached)
            {
                if (plane.IsUntried && plane.IsWholeNoNearer(scratch.A, scratch.B)) return;
                if (plane.IsSet && plane.IsNoNearer(scratch.A, pair.A, scratch.B, pair.B)) continue;
                int childA = a.Children[pair.A], childB = b.Children[pair.B];
                if (childA < 0 && childB < 0)
                {
                    search.AskLeaves(scratch, childA, childB);
                    continue;
                }

                bool isA = search._frame.Open(
                    boxesA, pair.A, childA, boxesB, pair.B, childB, out float* node, out float factor,
                    out TurnedBox other);
                search.Bounds(isA, node, factor, other, bounds);
                heap.AddBelow(pair, isA, isA ? a.Children : b.Children, bounds, search._reached);
            }
        }
    }

    /// <summary>A vector's length where its square may leave the range of double.</summary>
    private static double Length(in Double3 v)
    {
        double most = v.SumOfMagnitudes;
        if (!(most > 0)) return 0;
        double unit = PowerOfTwo.AtMost(most);
        return (v * (1 / unit)).Length * unit;
    }

    /// <summary>How fast the furthest point of a side moves about its position.</summary>
    private static double Spin(PartSide side, Vector3 turn) =>
        Length(turn) * (Length(side.Tree.Origin) + side.Tree.Radius + side.Margin) * Beyond;

    /// <summary>What bounds are compared with, for a fraction, or a ray's distance.</summary>
    private void SetReached(double fraction)
    {
        double along = Math.Min(fraction, _to) - _from;
        double length = _motion.Kind == MotionKind.Ray ? 1 : _length;
        double way = length > 0 ? along * length * Beyond / _frame.Unit : 0;
        if (_motion.Kind == MotionKind.Impact) way += _room + TouchRoom / _frame.Unit;
        _reached = _motion.Kind == MotionKind.Impact ? BoxLanes.Squared(way) : BoxLanes.AtMost(way * Beyond);
    }

    private readonly unsafe void Bounds(bool isA, float* node, float factor, in TurnedBox other, float* bounds)
    {
        if (_motion.Kind == MotionKind.Impact) BoxLanes.DistanceSquared(node, factor, other, _frame.Room, bounds);
        else BoxLanes.Entries(node, factor, other, isA ? _wayInA : _wayInB, _room, bounds);
    }

    private void AskLeaves(ConcaveScratch scratch, int leafA, int leafB)
    {
        int firstA = PartTree.FirstOf(leafA), endA = firstA + PartTree.CountOf(leafA);
        int firstB = PartTree.FirstOf(leafB), endB = firstB + PartTree.CountOf(leafB);
        for (int i = firstA; i < endA; i++)
            for (int j = firstB; j < endB; j++) Ask(scratch, scratch.A.Tree.Order[i], scratch.B.Tree.Order[j]);
    }

    /// <summary>Asks two parts, and keeps their contact if it is the first.</summary>
    public void Ask(ConcaveScratch scratch, int partA, int partB)
    {
        Asked++;
        ConvexShape roomA = default, roomB = default;
        ref readonly ConvexShape a = ref scratch.A.Part(partA, ref roomA);

        // What is passed depends on the whole way, and so does where an impact's steps end.
        bool isImpact = _motion.Kind == MotionKind.Impact;
        bool isWhole = PartA < 0 || AllCasts is not null || _motion.Options.PassesShallow || isImpact;
        double error = _motion.Kind == MotionKind.Cast ? WayError * Size / Math.Max(_length, double.Epsilon) : 0;
        double least = _best.Solved + error;
        var most = (float)Math.Min(_maxFraction, isWhole ? double.PositiveInfinity : RoundOff.Up((float)least));
        if (_motion.Kind == MotionKind.Ray)
        {
            RayCastResult met = ConvexQuery.RayCast(
                a, _motion.A.Pose, _motion.B.Pose.Position, _motion.B.Velocity, most, _motion.Options, Sides);
            TriangleBack.Judge(scratch.A, partA, _motion.B.Velocity, Sides, ref met);
            if (All is not null && met.IsHit) All.Add(new RayHit(met, scratch.A.NumberOf(partA)));
            else if (met.IsHit && KeepIfFirst(met.Order, MetFeature.None, partA, partB)) Ray = met;
            return;
        }

        ref readonly ConvexShape b = ref scratch.B.Part(partB, ref roomB);
        if (isImpact && !double.IsInfinity(_to) && ConvexQuery.StaysApart(
            a, _motion.A, b, _motion.B, _motion.Tolerance, (float)_maxFraction, _from, _to)) return;
        bool isIdle = Asked >= IdleBeforeProof && (Asked & (Asked - 1)) == 0;
        if (isIdle && _motion.Kind == MotionKind.Cast) TryPlane(scratch, partA, partB);
        CastResult found = Move(a, b, _motion.B, most, _motion.Options);
        if (!found.MayHit || (AllCasts is null && PartA >= 0 && found.Order.CompareTo(_best) > 0)) return;
        if (_isLifted && !UnionLift.IsOutOf(found, _lifted.Pose, _lift, _wayOfLifted, 1)
            && !Move(a, b, _lifted, most, _liftedOptions).MayHit) return;
        MetFeature feature = MetFeature.None;
        if (found.Status == CastStatus.Hit)
        {
            feature = MetFeatures.Of(
                a, PartAdvancement.PoseAt(_motion.A, found.Fraction), b,
                PartAdvancement.PoseAt(_motion.B, found.Fraction), found.Normal);
        }

        if (AllCasts is not null)
            AllCasts.Add(new CastHit(found, scratch.A.NumberOf(partA), scratch.B.NumberOf(partB), feature));
        else Meet(scratch, new CastHit(found, partA, partB, feature));
    }

    /// <summary>Keeps a contact with those that are met at once.</summary>
    private void Meet(ConcaveScratch scratch, in CastHit hit)
    {
        int order = PartA < 0 ? -1 : hit.Result.Order.CompareTo(_best);
        if (order < 0) scratch.Met.Clear();
        if (order <= 0) scratch.Met.Add(hit);
        if (KeepIfFirst(hit.Result.Order, hit.Feature, hit.PartA, hit.PartB)) Cast = hit.Result;
    }

    /// <summary>Takes the plane of two parts that are apart at the start: where many parts pass each other closely,
    /// the boxes' bounds in float let all of them pass.</summary>
    private readonly void TryPlane(ConcaveScratch scratch, int partA, int partB)
    {
        DistanceResult start = PartQuery.Distance(scratch.A, partA, scratch.B, partB, float.PositiveInfinity);
        if (start.Status != GjkStatus.Separated) return;
        scratch.Plane.SetWay(
            scratch.A, partA, scratch.B, partB, start.Normal, (Asked & OtherPowers) != 0,
            _motion.Way, Last + WayError * Size / Math.Max(_length, double.Epsilon));
    }

    private readonly CastResult Move(
        in ConvexShape a, in ConvexShape b, in RigidMotion motionB, float most, in CastOptions options) =>
        _motion.Kind == MotionKind.Cast
            ? ConvexQuery.Cast(a, _motion.A.Pose, _motion.A.Velocity, b, motionB.Pose, motionB.Velocity, most, options)
            : ConvexQuery.TimeOfImpact(a, _motion.A, b, motionB, _motion.Tolerance, most, options);

    /// <summary>Whether an answer is before the best one; then it takes its place.</summary>
    private bool KeepIfFirst(in ContactOrder found, MetFeature feature, int partA, int partB)
    {
        int order = PartA < 0 ? -1 : found.CompareTo(_best);
        if (order == 0) order = (int)feature - (int)Feature;
        if (order == 0) order = partA.CompareTo(PartA);
        if (order == 0) order = partB.CompareTo(PartB);
        if (order >= 0) return false;
        (_best, Feature, PartA, PartB) = (found, feature, partA, partB);
        SetReached(found.Solved);
        return true;
    }
}
