namespace Gjk.Import;

/// <summary>Cuts one ear of a polygon after the other: a corner that turns left, and whose triangle holds no other
/// corner. All decisions are exact. Not thread-safe.</summary>
/// <remarks>Whether a corner is an ear changes only when a neighbour is cut, so each cut asks two corners again. If any
/// corner lies in the triangle of a corner that turns left, then one does that does not turn left: the nearest to the
/// tip. These alone are looked at. They are sorted, so that a test sees a strip of the polygon.</remarks>
internal sealed class EarClipping
{
    /// <summary>An outline that crosses itself may have no ear. So many times a corner that is none is cut, and all
    /// others are asked again; then they are cut in order, which bounds the time.</summary>
    private const int MostForced = 64;

    /// <summary>Corners. A shorter strip is not worth making shorter.</summary>
    private const int ShortStrip = 32;

    private readonly Queue<int> _open = new();
    private PolygonCorners _corners = null!;
    private int[] _next = [], _previous = [], _strip = [];
    private float[] _stripU = [];

    /// <summary>Waiting in <see cref="_open"/>; cut away; not turning left.</summary>
    private bool[] _isOpen = [], _isCut = [], _isBlocking = [];
    private int _any, _left, _stripCount, _blocking, _forced;

    /// <summary>Returns false if the outline is not simple, as far as its ears tell.</summary>
    /// <param name="corners">At least three.</param>
    /// <param name="triangles">Receives three vertices for each triangle.</param>
    public bool Append(PolygonCorners corners, List<int> triangles)
    {
        Begin(corners);
        bool isSimple = true;
        while (_left > 3)
        {
            if (_open.Count == 0)
            {
                isSimple &= !Force(triangles);
                continue;
            }

            int corner = _open.Dequeue();
            _isOpen[corner] = false;
            if (!_isCut[corner] && IsEar(corner)) Cut(corner, triangles);
        }

        if (_left < 3 || corners.IsSame(_previous[_any], _next[_any])) return isSimple;
        Append(_any, triangles);
        return isSimple && Turn(_any) >= 0;
    }

    private void Begin(PolygonCorners corners)
    {
        _corners = corners;
        _left = corners.Count;
        _any = _forced = _stripCount = 0;
        _open.Clear();
        if (_next.Length < _left) Resize(_left);
        for (int i = 0; i < _left; i++)
        {
            _next[i] = i + 1 < _left ? i + 1 : 0;
            _previous[i] = i > 0 ? i - 1 : _left - 1;
            _isCut[i] = false;
            _isOpen[i] = true;
            _open.Enqueue(i);
        }

        for (int i = 0; i < _left; i++)
        {
            _isBlocking[i] = Turn(i) <= 0;
            if (!_isBlocking[i]) continue;
            _stripU[_stripCount] = corners.U(i);
            _strip[_stripCount++] = i;
        }

        _blocking = _stripCount;
        Array.Sort(_stripU, _strip, 0, _stripCount);
    }

    private void Resize(int count)
    {
        (_next, _previous, _strip, _stripU) = (new int[count], new int[count], new int[count], new float[count]);
        (_isOpen, _isCut, _isBlocking) = (new bool[count], new bool[count], new bool[count]);
    }

    private int Turn(int corner) => _corners.Turn(_previous[corner], corner, _next[corner]);

    private bool IsEar(int corner)
    {
        int before = _previous[corner], after = _next[corner];
        if (Turn(corner) <= 0) return false;
        float minU = Math.Min(_corners.U(corner), Math.Min(_corners.U(before), _corners.U(after)));
        float maxU = Math.Max(_corners.U(corner), Math.Max(_corners.U(before), _corners.U(after)));
        float minV = Math.Min(_corners.V(corner), Math.Min(_corners.V(before), _corners.V(after)));
        float maxV = Math.Max(_corners.V(corner), Math.Max(_corners.V(before), _corners.V(after)));
        for (int i = FirstFrom(minU); i < _stripCount && _stripU[i] <= maxU; i++)
        {
            int other = _strip[i];
            if (!_isBlocking[other] || _corners.V(other) < minV || _corners.V(other) > maxV) continue;
            if (other == before || other == corner || other == after) continue;
            if (IsInTheWay(before, corner, after, other)) return false;
        }

        return true;
    }

    /// <summary>The first place in the strip with this u or more.</summary>
    private int FirstFrom(float u)
    {
        int low = 0, high = _stripCount;
        while (low < high)
        {
            int middle = (low + high) / 2;
            if (_stripU[middle] < u) low = middle + 1;
            else high = middle;
        }

        return low;
    }

    /// <summary>Does a corner lie in the triangle a, b, c? Where it lies upon a corner of it, as at the end of a
    /// bridge, its edges tell on which side its outline is.</summary>
    private bool IsInTheWay(int a, int b, int c, int other)
    {
        if (IsUpon(other, a)) return Enters(a, b, c, other);
        if (IsUpon(other, b)) return Enters(b, c, a, other);
        if (IsUpon(other, c)) return Enters(c, a, b, other);
        return _corners.Turn(a, b, other) >= 0 && _corners.Turn(b, c, other) >= 0 && _corners.Turn(c, a, other) >= 0;
    }

    private bool IsUpon(int a, int b) => _corners.U(a) == _corners.U(b) && _corners.V(a) == _corners.V(b);

    /// <summary>True if an edge of the other corner leads between the sides from the tip to a and b.</summary>
    private bool Enters(int tip, int a, int b, int other) =>
        IsBetween(tip, a, b, _previous[other]) || IsBetween(tip, a, b, _next[other]);

    private bool IsBetween(int tip, int a, int b, int end) =>
        _corners.Turn(tip, a, end) > 0 && _corners.Turn(tip, end, b) > 0;

    /// <summary>Cuts a corner that is no ear. Returns false if all that is left lies on a line, and so has no
    /// area.</summary>
    private bool Force(List<int> triangles)
    {
        if (_forced++ >= MostForced)
        {
            Cut(_any, triangles);
            _open.Clear();
            return true;
        }

        int corner = _any;
        bool isBent = false;
        for (int i = 0; i < _left && Turn(corner) <= 0; i++)
        {
            isBent |= Turn(corner) < 0;
            corner = _next[corner];
        }

        isBent |= Turn(corner) > 0;
        Cut(corner, triangles);
        for (int i = 0; i < _left; i++)
        {
            Open(_any);
            _any = _next[_any];
        }

        return isBent;
    }

    private void Cut(int corner, List<int> triangles)
    {
        int before = _previous[corner], after = _next[corner];
        Append(corner, triangles);
        Unlink(corner);
        Settle(before);
        if (!_isCut[after]) Settle(after);
        if (_stripCount > ShortStrip && 2 * _blocking < _stripCount) Shorten();
    }

    private void Append(int corner, List<int> triangles)
    {
        triangles.Add(_corners.Vertex(_previous[corner]));
        triangles.Add(_corners.Vertex(corner));
        triangles.Add(_corners.Vertex(_next[corner]));
    }

    /// <summary>A neighbour was cut. Where the outline goes back to the corner it came from, which is so when one side
    /// of a pinch is done, both ways go: they have no area.</summary>
    private void Settle(int corner)
    {
        while (_left > 3 && _corners.IsSame(_previous[corner], _next[corner]))
        {
            int before = _previous[corner];
            Unlink(_next[corner]);
            Unlink(corner);
            corner = before;
        }

        if (_isBlocking[corner] && Turn(corner) > 0) Unblock(corner);
        Open(corner);
    }

    private void Open(int corner)
    {
        if (_isOpen[corner]) return;
        _isOpen[corner] = true;
        _open.Enqueue(corner);
    }

    private void Unlink(int corner)
    {
        _next[_previous[corner]] = _next[corner];
        _previous[_next[corner]] = _previous[corner];
        _isCut[corner] = true;
        _left--;
        if (_any == corner) _any = _next[corner];
        if (_isBlocking[corner]) Unblock(corner);
    }

    private void Unblock(int corner)
    {
        _isBlocking[corner] = false;
        _blocking--;
    }

    private void Shorten()
    {
        int kept = 0;
        for (int i = 0; i < _stripCount; i++)
        {
            if (!_isBlocking[_strip[i]]) continue;
            _stripU[kept] = _stripU[i];
            _strip[kept++] = _strip[i];
        }

        _stripCount = kept;
    }
}
