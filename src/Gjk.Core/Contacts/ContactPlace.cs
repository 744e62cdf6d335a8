namespace Gjk.Core;

/// <summary>A place in the plane across the normal where both shapes have a surface.</summary>
internal struct ContactPlace
{
    /// <summary>The place in the plane.</summary>
    public double U, V;

    /// <summary>Its name.</summary>
    public long Id;

    /// <summary>How many corners it is the middle of.</summary>
    public int Count;

    /// <summary>The corner that it is exactly at; -1 where it is at none.</summary>
    public int CornerA, CornerB;

    /// <summary>The edge on which it lies; -1 at the other's corner.</summary>
    public int EdgeA, EdgeB;

    /// <summary>Whether nearly parallel edges cross here.</summary>
    public bool IsFlat;

    /// <summary>Moves it to a corner of one of the two.</summary>
    public void MoveTo(in FlatCorner corner, int ofA, int ofB)
    {
        (U, V, CornerA, CornerB) = (corner.U, corner.V, ofA, ofB);
        IsFlat = false;
    }

    /// <summary>Takes in another corner with the same name.</summary>
    public void Join(in ContactPlace other)
    {
        U += other.U;
        V += other.V;
        Count++;
        CornerA = -1;
        CornerB = -1;
    }

    /// <summary>From the sum of its corners to their middle.</summary>
    public void TakeMiddle()
    {
        if (Count == 1) return;
        U /= Count;
        V /= Count;
    }
}
