namespace Gjk.Core;

/// <summary>Static objects that are flush, such as the tiles of a floor, have seams that their union does not show: a
/// contact with one of them is left out where another one goes on, as between the parts of a compound.</summary>
internal sealed class SceneSeams(SceneObjects objects)
{
    private ulong[] _keys = new ulong[16];
    private bool[] _isCovered = new bool[16];
    private readonly List<int> _grounds = [];

    /// <summary>Takes the contacts at such seams out of a scene's.</summary>
    public void Remove(List<PairContacts> contacts)
    {
        int count = SortByBody(contacts);
        bool isAny = false;
        for (int begin = 0, end; begin < count; begin = end)
        {
            end = begin + 1;
            while (end < count && _keys[end] >> 32 == _keys[begin] >> 32) end++;
            FindGrounds(contacts, begin, end);
            if (_grounds.Count > 1) isAny |= Cover(contacts, begin, end);
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
            int a = objects.SlotOf(contacts[i].Pair.A), b = objects.SlotOf(contacts[i].Pair.B);
            if (objects.Settings[a].IsStatic != objects.Settings[b].IsStatic)
                _keys[count++] = (ulong)(uint)(objects.Settings[a].IsStatic ? b : a) << 32 | (uint)i;
        }

        InPlaceSort.Sort(_keys, 0, count);
        return count;
    }

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
    /// holds them.</summary>
    private bool Cover(List<PairContacts> contacts, int begin, int end)
    {
        bool isAny = false;
        for (int i = begin; i < end; i++)
        {
            int at = (int)(uint)_keys[i];
            var one = new BodyContact(objects, contacts[at], (int)(_keys[i] >> 32));
            for (int k = 0; k < _grounds.Count && !_isCovered[at]; k++) _isCovered[at] = one.IsCoveredBy(_grounds[k]);
            isAny |= _isCovered[at];
        }

        for (int i = begin; isAny && i < end; i++)
        {
            int at = (int)(uint)_keys[i];
            if (!_isCovered[at] || !(contacts[at].Result.Distance < 0)) continue;
            var one = new BodyContact(objects, contacts[at], (int)(_keys[i] >> 32));
            bool isHeld = false;
            for (int k = begin; k < end && !isHeld; k++)
            {
                int holder = (int)(uint)_keys[k];
                isHeld = !_isCovered[holder]
                    && one.IsHeldBy(new BodyContact(objects, contacts[holder], one.Body));
            }

            _isCovered[at] = isHeld;
        }

        return isAny;
    }

    /// <summary>A contact as a body has it with a static object.</summary>
    private readonly ref struct BodyContact
    {
        private readonly SceneObjects _objects;
        private readonly PairContacts _contact;
        private readonly bool _isBodyA;

        public BodyContact(SceneObjects objects, in PairContacts contact, int body)
        {
            (_objects, _contact, Body) = (objects, contact, body);
            _isBodyA = objects.SlotOf(contact.Pair.A) == body;
            Ground = objects.SlotOf(_isBodyA ? contact.Pair.B : contact.Pair.A);
        }

        public int Body { get; }

        /// <summary>The slot of the static object.</summary>
        public int Ground { get; }

        /// <summary>From the static object to the body, in the world.</summary>
        private Vector3 Outward => _isBodyA ? -_contact.Manifold.Normal : _contact.Manifold.Normal;

        /// <summary>Whether another static object goes on where this contact is.</summary>
        public bool IsCoveredBy(int ground)
        {
            if (ground == Ground) return false;
            RigidPose pose = _objects.Poses[Ground], cover = _objects.Poses[ground];
            Double3 local = _isBodyA ? _contact.Result.LocalPointB : _contact.Result.LocalPointA;
            Double3 moved = (Double3)pose.Position - cover.Position;
            RotationD turn = new(cover.Rotation);
            Double3 witness = turn.InverseRotate(new RotationD(pose.Rotation).Rotate(local) + moved);
            return _objects.Parts.GoesOn(ground, witness, turn.InverseRotate(Outward));
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
}
