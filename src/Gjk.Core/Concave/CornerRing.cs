namespace Gjk.Core;

/// <summary>The sides of a mesh's triangles that begin at one place, one by one.</summary>
internal ref struct CornerRing(TriangleList list, int[] around, int side)
{
    private readonly int _first = list.IsGrid ? list.Corner(side) : side;
    private int _step;

    /// <summary>Three times a triangle, and its corner that is at the place.</summary>
    public int Current { get; private set; } = -1;

    public bool MoveNext()
    {
        if (!list.IsGrid)
        {
            Current = Current < 0 ? _first : around[Current];
            return _step++ == 0 || Current != _first;
        }

        while (_step < 6)
        {
            Current = list.SideInGrid(_first, _step++);
            if (Current >= 0) return true;
        }

        return false;
    }
}
