namespace Gjk.Core;

/// <summary>Static objects that are flush, such as the tiles of a floor, have seams that their union does not show: a
/// contact with one of them is left out where another one goes on, as between the parts of a compound.</summary>
internal sealed class SceneSeams(SceneObjects objects)
{
    private ulong[] _keys = new ulong[16];
    private bool[] _isCovered = new bool[16];
    private readonly List<Ground> _grounds = [], _around = [];
    private readonly List<int> _near = [];
    private readonly List<OpenPlane> _planes = [], _ends = [];
    private int _center, _planeCount;
    private double _lift;
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
            if (_grounds.Count < 2) continue;
            isAny |= Cover(contacts, begin, end, maxGap);
            isAny |= KeepOnLines(contacts, begin, end);
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
            if (_grounds.Count == 0 || _grounds[_grounds.Count - 1].Slot != ground)
                _grounds.Add(new Ground(objects, ground));
        }
    }

    /// <summary>Finds the contacts of a body that are covered; those of pairs that overlap only where another contact
    /// holds them, or else the one that takes their place does.</summary>
    private bool Cover(List<PairContacts> contacts, int begin, int end, float maxGap)
    {
        _planes.Clear();
        _ends.Clear();
        BeginNear();
        for (int i = begin; i < end; i++)
        {
            BodyContact one = At(contacts, i);
            int at = (int)(uint)_keys[i];
            FindNear(contacts, i, end, one);
            _isCovered[at] = one.GoesOnIn(_near);
            if (_isCovered[at]) one.AddEnd(_ends, _near);
            else one.AddPlane(_planes);
        }

        bool isAny = false;
        BeginNear();
        for (int i = begin; i < end; i++)
        {
            BodyContact one = At(contacts, i);
            ref bool isCovered = ref _isCovered[(int)(uint)_keys[i]];
            bool isAcross = !isCovered && one.IsAnyAcross(_planes);
            if (isAcross) FindNear(contacts, i, end, one);
            isCovered = isCovered
                ? !one.StandsOn(_planes)
                : one.IsAside || (isAcross && one.IsBuried(_near, _planes));
            isAny |= isCovered;
            if (!isCovered) one.AddPlane(_ends);
        }

        if (!isAny) return false;
        LayFlush(contacts, begin, end, maxGap);
        _straight.Clear();
        BeginNear();
        for (int i = begin; i < end; i++)
        {
            BodyContact one = At(contacts, i);
            int at = (int)(uint)_keys[i];
            if (!_isCovered[at] || !one.Overlaps || IsHeld(contacts, begin, end, one)) continue;
            FindNear(contacts, i, end, one);
            if (one.TryStraighten(_near, maxGap, out PairContacts straight)) _straight.Add((at, straight));
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

    /// <summary>Gives covered contacts the direction of a plane in which what covers them ends with their own
    /// object.</summary>
    private void LayFlush(List<PairContacts> contacts, int begin, int end, float maxGap)
    {
        BeginNear();
        for (int i = begin; i < end; i++)
        {
            BodyContact one = At(contacts, i);
            int at = (int)(uint)_keys[i];
            if (!_isCovered[at]) continue;
            FindNear(contacts, i, end, one);
            if (!one.TryFlush(_near, _ends, maxGap, out PairContacts flush)) continue;
            (contacts[at], _isCovered[at]) = (flush, false);
        }
    }

    /// <summary>Takes out the points of a body beside its lines, as <see cref="TouchLine"/> does where one object goes
    /// on to them.</summary>
    private bool KeepOnLines(List<PairContacts> contacts, int begin, int end)
    {
        bool isAny = false;
        _near.Clear();
        foreach (Ground ground in _grounds) _near.Add(ground.Slot);
        for (int i = begin; i < end; i++)
        {
            int at = (int)(uint)_keys[i];
            BodyContact one = At(contacts, i);
            if (_isCovered[at] || !one.TryFindLine(out TouchLine line)) continue;
            _isCovered[at] = one.IsBeside(line, _near) && IsAnyDeeper(contacts, begin, end, one);
            if (_isCovered[at]) isAny = true;
            else contacts[at] = one.KeptOn(line, _near);
        }

        return isAny;
    }

    private bool IsAnyDeeper(List<PairContacts> contacts, int begin, int end, in BodyContact one)
    {
        for (int k = begin; k < end; k++)
            if (!_isCovered[(int)(uint)_keys[k]] && one.IsUnder(At(contacts, k))) return true;
        return false;
    }

    /// <summary>Before a walk over the contacts of a body, with the planes that there are.</summary>
    private void BeginNear()
    {
        (_center, _planeCount, _lift) = (-1, _planes.Count, 0);
        foreach (OpenPlane plane in _planes)
            _lift = Math.Max(_lift, plane.Depth + 2 * CoveredSides.Room * plane.Foot.SumOfMagnitudes);
    }

    /// <summary>Finds the other grounds that may hold a point of a contact, or one lifted to a plane: of those around
    /// the contacts that follow with the same ground.</summary>
    private void FindNear(List<PairContacts> contacts, int at, int end, in BodyContact one)
    {
        one.Bound(_planeCount, out PartBox box, out double place);
        if (_center != one.Ground)
        {
            _center = one.Ground;
            PartBox all = box;
            double most = place;
            for (int i = at + 1; i < end; i++)
            {
                BodyContact other = At(contacts, i);
                if (other.Ground != _center) break;
                other.Bound(_planeCount, out PartBox next, out double nextPlace);
                all.Add(next);
                most = Math.Max(most, nextPlace);
            }

            _around.Clear();
            foreach (Ground ground in _grounds)
                if (ground.Slot != _center && ground.IsNear(all, most, _lift)) _around.Add(ground);
        }

        _near.Clear();
        foreach (Ground ground in _around)
            if (ground.IsNear(box, place, _lift)) _near.Add(ground.Slot);
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
}
