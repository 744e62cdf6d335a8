namespace Gjk.Core;

/// <summary>A contact as a body has it with a static object.</summary>
internal readonly ref struct BodyContact
{
    private readonly SceneObjects _objects;
    private readonly PairContacts _contact;
    private readonly bool _isBodyA;

    public BodyContact(SceneObjects objects, scoped in PairContacts contact, int body)
    {
        (_objects, _contact, Body) = (objects, contact, body);
        _isBodyA = objects.SlotOfAnswer(contact.Pair.A) == body;
        Ground = objects.SlotOfAnswer(_isBodyA ? contact.Pair.B : contact.Pair.A);
    }

    public int Body { get; }

    /// <summary>The slot of the static object.</summary>
    public int Ground { get; }

    /// <summary>From the static object to the body, in the world.</summary>
    private Vector3 Outward => _isBodyA ? -_contact.Manifold.Normal : _contact.Manifold.Normal;

    public bool Overlaps => _contact.Result.Distance < 0;

    public void AddPlane(List<OpenPlane> planes) =>
        CoveredSides.AddPlane(planes, _contact.Manifold, !_isBodyA, _objects.Poses[Ground]);

    /// <summary>The box of its points on the static object, and the magnitudes of where they are; only of its
    /// witness where there are no planes to be lifted to.</summary>
    public void Bound(int planes, out PartBox box, out double place)
    {
        box = new PartBox(Witness, Witness);
        for (int i = 0; planes > 0 && i < _contact.Manifold.Count; i++)
        {
            Double3 foot = CoveredSides.FootOf(_contact.Manifold[i], !_isBodyA, _objects.Poses[Ground]);
            box.Add(foot);
        }

        place = box.Min.SumOfMagnitudes + box.Max.SumOfMagnitudes
            + ((Double3)_objects.Poses[Ground].Position).SumOfMagnitudes;
    }

    /// <summary>Whether one of the other static objects goes on where this contact is.</summary>
    public bool GoesOnIn(List<int> others) => new GroundCover(_objects, others).GoesOn(Witness, Outward);

    /// <summary>Whether its part is there beyond the plane of another contact.</summary>
    public bool StandsOn(List<OpenPlane> planes)
    {
        ConvexShape room = default;
        return CoveredSides.StandsOn(Witness, Outward, GroundPart(ref room), _objects.Poses[Ground], planes);
    }

    /// <summary>Whether the plane of another contact is across it.</summary>
    public bool IsAnyAcross(List<OpenPlane> planes) => CoveredSides.IsAnyAcross(planes, Outward);

    /// <summary>Whether it is at a side that other static objects cover.</summary>
    public bool IsBuried(List<int> others, List<OpenPlane> planes)
    {
        ConvexShape room = default;
        return CoveredSides.IsBuried(
            _contact.Manifold, !_isBodyA, GroundPart(ref room), _objects.Poses[Ground], planes,
            new GroundCover(_objects, others));
    }

    /// <summary>Whether it is along a face that the static object, as it is convex, meets elsewhere: as a part of a
    /// compound it would not have it.</summary>
    public bool IsAside
    {
        get
        {
            if (!Overlaps || !_objects.Parts.Has(Body) || _objects.Parts.Has(Ground)) return false;
            ConvexShape groundRoom = default, bodyRoom = default;
            ManifoldPoint tip = CoveredSides.Tip(
                GroundPart(ref groundRoom), _objects.Poses[Ground], BodyPart(ref bodyRoom), _objects.Poses[Body],
                Outward);
            return !FaceSearch.IsAsDeep(_contact.Manifold, tip.Gap);
        }
    }

    private Double3 Witness => CoveredSides.InWorld(
        _isBodyA ? _contact.Result.LocalPointB : _contact.Result.LocalPointA, _objects.Poses[Ground]);

    /// <summary>Adds the plane in which others end where they go on.</summary>
    public void AddEnd(List<OpenPlane> ends, List<int> others)
    {
        ConvexShape room = default;
        FlushSides.AddEnd(
            ends, Witness, Outward, GroundPart(ref room), _objects.Poses[Ground],
            new GroundCover(_objects, others));
    }

    /// <summary>The contact along a plane in which static objects end together.</summary>
    public bool TryFlush(List<int> others, List<OpenPlane> ends, float maxGap, out PairContacts flush)
    {
        ConvexShape groundRoom = default, bodyRoom = default;
        ref readonly ConvexShape ground = ref GroundPart(ref groundRoom);
        ref readonly ConvexShape body = ref BodyPart(ref bodyRoom);
        RigidPose pose = _objects.Poses[Ground], bodyPose = _objects.Poses[Body];
        var cover = new GroundCover(_objects, others);
        flush = _contact;
        bool isThere = _isBodyA
            ? FlushSides.TryFlush(ref flush, false, body, bodyPose, ground, pose, maxGap, ends, cover)
            : FlushSides.TryFlush(ref flush, true, ground, pose, body, bodyPose, maxGap, ends, cover);
        Double3 normal = flush.Manifold.Normal;
        return isThere && _objects.Parts.Shows(
            Body, _isBodyA ? _contact.PartA : _contact.PartB, _isBodyA ? normal : -normal);
    }

    /// <summary>The contact along the way that all of the static objects show together.</summary>
    public bool TryStraighten(List<int> others, float maxGap, out PairContacts straight)
    {
        ConvexShape groundRoom = default, bodyRoom = default;
        ref readonly ConvexShape ground = ref GroundPart(ref groundRoom);
        ref readonly ConvexShape body = ref BodyPart(ref bodyRoom);
        RigidPose pose = _objects.Poses[Ground], bodyPose = _objects.Poses[Body];
        Double3 way = new GroundCover(_objects, others).EndNear(Witness, Outward).Normal;
        straight = _contact;
        return _objects.Parts.Shows(Body, _isBodyA ? _contact.PartA : _contact.PartB, -way) && (_isBodyA
            ? CoveredSides.TryAlong(ref straight, false, body, bodyPose, ground, pose, maxGap, way)
            : CoveredSides.TryAlong(ref straight, true, ground, pose, body, bodyPose, maxGap, way));
    }

    /// <summary>Finds the line that the body shows to the static object.</summary>
    public bool TryFindLine(out TouchLine line)
    {
        line = default;
        if (_objects.Parts.Has(Body) && _objects.Parts[Body].Mesh is not null) return false;
        ConvexShape room = default;
        return TouchLine.TryFind(BodyPart(ref room), _objects.Poses[Body], Outward, out line);
    }

    /// <summary>Whether its deepest point is beside the line, where static objects go on to that.</summary>
    public bool IsBeside(in TouchLine line, List<int> grounds) =>
        line.IsBeside(_contact, !_isBodyA, _objects.Poses[Ground], new GroundCover(_objects, grounds));

    /// <summary>The contact without the other points that are.</summary>
    public PairContacts KeptOn(in TouchLine line, List<int> grounds) =>
        line.KeepOn(_contact, !_isBodyA, _objects.Poses[Ground], new GroundCover(_objects, grounds));

    /// <summary>Whether another contact of the same part of the body is deeper, the same way.</summary>
    public bool IsUnder(in BodyContact other) =>
        (_isBodyA ? _contact.PartA : _contact.PartB) == (other._isBodyA ? other._contact.PartA : other._contact.PartB)
        && TouchLine.IsDeeper(other._contact, other.Outward, _contact, Outward);

    /// <summary>Whether another contact's push takes the body out of this part.</summary>
    public bool IsHeldBy(in BodyContact other)
    {
        Vector3 push = other.Outward * ContactPush.LengthOf(other._contact.Result);
        ConvexShape ground = default, body = default;
        return ContactPush.TakesApart(
            GroundPart(ref ground), _objects.Poses[Ground], BodyPart(ref body), _objects.Poses[Body],
            _contact.Result.Distance, Outward, push);
    }

    private ref readonly ConvexShape GroundPart(ref ConvexShape room) =>
        ref _objects.Parts.Part(Ground, _isBodyA ? _contact.PartB : _contact.PartA, ref room);

    private ref readonly ConvexShape BodyPart(ref ConvexShape room) =>
        ref _objects.Parts.Part(Body, _isBodyA ? _contact.PartA : _contact.PartB, ref room);
}
