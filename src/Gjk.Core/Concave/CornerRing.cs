namespace Gjk.Core;

/// <summary>The sides of a mesh's triangles that begin at one place, one by one.</summary>
internal ref struct CornerRing
{
    private readonly TriangleList _list;
    private readonly int[] _around;
    private readonly int _first;
    private int _step;

    public CornerRing(TriangleList list, int[] around, int side)
    {
        (_list, _around, _step) = (list, around, 0);
        _first = list.IsGrid ? list.Corner(side) : side;
        Current = -1;
    }

    /// <summary>Three times a triangle, and its corner that is at the place.</summary>
    public int Current { get; private set; }

    public bool MoveNext()
    {
        if (!_list.IsGrid)
        {
            Current = Current < 0 ? _first : _around[Current];
            return _step++ == 0 || Current != _first;
        }

        while (_step < 6)
        {
            Current = _list.SideInGrid(_first, _step++);
            if (Current >= 0) return true;
        }

        return false;
    }
}
