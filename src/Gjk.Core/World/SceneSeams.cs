namespace Gjk.Core;

/// <summary>Static objects that are flush, such as the tiles of a floor, have seams that their union does not show: a
/// contact with one of them is left out where another one goes on, as between the parts of a compound.</summary>
internal sealed class SceneSeams(SceneObjects objects)
{
    private ulong[] _keys = new ulong[16];
    private bool[] _isCovered = new bool[16];
    private readonly List<int> _grounds = [];
    private readonly List<OpenPlane> _planes = [];
    private readonly List<(int At, PairContacts Straight)> _straight = [];

    /// <summary>Takes the contacts at such seams out of a scene's.</summary>
    public void Remove(List<PairContacts> contacts, float maxGap)
    {
        int count = SortByBody(contacts);
        bool isAny = false;
        for (int begin = 0, end; begin < count; begin = end)
        {
            end = begin + 1;
            while (end < count && _keys[end] >> 32 == _keys[begin] >> 32) end++;
            FindGrounds(contacts, begin, end);
            if (_grounds.Count > 1) isAny |= Cover(contacts, begin, end, maxGap);
        }

        if (!isAny) return;
        int kept = 0;
        for (int i = 0; i < contacts.Count; i++)
            if (!_isCovered[i]) contacts[kept++] = contacts[i];
        contacts.RemoveRange(kept, contacts.Count - kept);
    }

    /// <summary>The contacts with static objects, by the slot of the body that touches them.</summary>
    private int SortByBody(List<PairContacts> contacts)
    {
        if (_keys.Length < contacts.Count)
        {
            _keys = new ulong[2 * contacts.Count];
            _isCovered = new bool[_keys.Length];
        }

        Array.Clear(_isCovered, 0, contacts.Count);
        int count = 0;
        for (int i = 0; i < contacts.Count; i++)
        {
            int a = objects.SlotOfAnswer(contacts[i].Pair.A), b = objects.SlotOfAnswer(contacts[i].Pair.B);
            bool isSmooth = IsHalfSpace(a) || IsHalfSpace(b);
            if (!isSmooth && objects.Settings[a].IsStatic != objects.Settings[b].IsStatic)
                _keys[count++] = (ulong)(uint)(objects.Settings[a].IsStatic ? b : a) << 32 | (uint)i;
        }

        InPlaceSort.Sort(_keys, 0, count);
        return count;
    }

    /// <summary>A half-space has no seam, and goes on everywhere.</summary>
    private bool IsHalfSpace(int slot) => objects.Shapes[slot].Kind == ShapeKind.HalfSpace;

    /// <summary>The static objects that a body touches. Contacts are sorted, so those with one object are
    /// together.</summary>
    private void FindGrounds(List<PairContacts> contacts, int begin, int end)
    {
        _grounds.Clear();
        int body = (int)(_keys[begin] >> 32);
        for (int i = begin; i < end; i++)
        {
            int ground = new BodyContact(objects, contacts[(int)(uint)_keys[i]], body).Ground;
            if (_grounds.Count == 0 || _grounds[_grounds.Count - 1] != ground) _grounds.Add(ground);
        }
    }

    /// <summary>Finds the contacts of a body that are covered; those of pairs that overlap only where another contact
    /// holds them, or else the one that takes their place does.</summary>
    private bool Cover(List<PairContacts> contacts, int begin, int end, float maxGap)
    {
        _planes.Clear();
        for (int i = begin; i < end; i++)
        {
            BodyContact one = At(contacts, i);
            int at = (int)(uint)_keys[i];
            for (int k = 0; k < _grounds.Count && !_isCovered[at]; k++) _isCovered[at] = one.GoesOnIn(_grounds[k]);
            if (!_isCovered[at]) one.AddPlane(_planes);
        }

        bool isAny = false;
        for (int i = begin; i < end; i++)
        {
            BodyContact one = At(contacts, i);
            ref bool isCovered = ref _isCovered[(int)(uint)_keys[i]];
            isCovered = isCovered ? !one.StandsOn(_planes) : IsBuried(one);
            isAny |= isCovered;
        }

        if (!isAny) return false;
        _straight.Clear();
        for (int i = begin; i < end; i++)
        {
            BodyContact one = At(contacts, i);
            int at = (int)(uint)_keys[i];
            if (_isCovered[at] && one.Overlaps && !IsHeld(contacts, begin, end, one)
                && one.TryStraighten(_grounds, maxGap, out PairContacts straight))
            {
                _straight.Add((at, straight));
            }
        }

        foreach ((int at, PairContacts straight) in _straight) (contacts[at], _isCovered[at]) = (straight, false);
        for (int i = begin; i < end; i++)
        {
            BodyContact one = At(contacts, i);
            int at = (int)(uint)_keys[i];
            if (_isCovered[at] && one.Overlaps) _isCovered[at] = IsHeld(contacts, begin, end, one);
        }

        return true;
    }

    private bool IsBuried(in BodyContact one)
    {
        foreach (int ground in _grounds)
            if (one.IsBuried(ground, _planes)) return true;
        return false;
    }

    private BodyContact At(List<PairContacts> contacts, int key) =>
        new(objects, contacts[(int)(uint)_keys[key]], (int)(_keys[key] >> 32));

    /// <summary>Whether a contact that is not covered takes the body out of the part of another one.</summary>
    private bool IsHeld(List<PairContacts> contacts, int begin, int end, in BodyContact one)
    {
        for (int k = begin; k < end; k++)
            if (!_isCovered[(int)(uint)_keys[k]] && one.IsHeldBy(At(contacts, k))) return true;
        return false;
    }

    /// <summary>A contact as a body has it with a static object.</summary>
    private readonly ref struct BodyContact
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

        /// <summary>Whether another static object goes on where this contact is.</summary>
        public bool GoesOnIn(int ground) =>
            ground != Ground && new GroundCover(_objects, ground).GoesOn(Witness, Outward);

        /// <summary>Whether its part is there beyond the plane of another contact.</summary>
        public bool StandsOn(List<OpenPlane> planes)
        {
            ConvexShape room = default;
            return CoveredSides.StandsOn(Witness, Outward, GroundPart(ref room), _objects.Poses[Ground], planes);
        }

        /// <summary>Whether it is at a side that another static object covers.</summary>
        public bool IsBuried(int ground, List<OpenPlane> planes)
        {
            ConvexShape room = default;
            return ground != Ground && CoveredSides.IsBuried(
                _contact.Manifold, !_isBodyA, GroundPart(ref room), _objects.Poses[Ground], planes,
                new GroundCover(_objects, ground));
        }

        private Double3 Witness => CoveredSides.InWorld(
            _isBodyA ? _contact.Result.LocalPointB : _contact.Result.LocalPointA, _objects.Poses[Ground]);

        /// <summary>The contact along the way that all of the static objects show together.</summary>
        public bool TryStraighten(List<int> grounds, float maxGap, out PairContacts straight)
        {
            ConvexShape groundRoom = default, bodyRoom = default;
            ref readonly ConvexShape ground = ref GroundPart(ref groundRoom);
            ref readonly ConvexShape body = ref BodyPart(ref bodyRoom);
            RigidPose pose = _objects.Poses[Ground], bodyPose = _objects.Poses[Body];
            Double3 way = CoveredSides.WayFrom(Witness, Outward, new GroundCover(_objects, Ground, grounds));
            straight = _contact;
            return _objects.Parts.Shows(Body, _isBodyA ? _contact.PartA : _contact.PartB, -way) && (_isBodyA
                ? CoveredSides.TryAlong(ref straight, false, body, bodyPose, ground, pose, maxGap, way)
                : CoveredSides.TryAlong(ref straight, true, ground, pose, body, bodyPose, maxGap, way));
        }

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

    /// <summary>A static object, and for the way to a point those that are there beside it.</summary>
    private readonly struct GroundCover(SceneObjects objects, int ground, List<int>? grounds = null) : ICover
    {
        public bool GoesOn(in Double3 point, in Double3 direction)
        {
            RotationD turn = new(objects.Poses[ground].Rotation);
            Double3 local = turn.InverseRotate(point - objects.Poses[ground].Position);
            return objects.Parts.GoesOn(ground, local, turn.InverseRotate(direction));
        }

        public Double3 WayTo(in Double3 point)
        {
            var pose = new RigidPose((Vector3)point);
            DistanceResult least = default;
            foreach (int other in grounds!)
            {
                if (other == ground) continue;
                DistanceResult found = objects.Parts.Distance(
                    ConvexShape.Point(), pose, other, float.PositiveInfinity).Result;
                if (least.Status == GjkStatus.None || found.Distance < least.Distance) least = found;
            }

            return -least.Normal;
        }
    }
}
