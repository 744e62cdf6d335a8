namespace Gjk.Core;

/// <summary>A node of a <see cref="HullTree"/>, two cache lines long.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct HullTreeNode
{
    /// <summary>The turned box: per axis the centre and the three half sides as vectors, in stretched units.</summary>
    public double CenterX, FirstX, SecondX, ThirdX;

    /// <summary>Their y.</summary>
    public double CenterY, FirstY, SecondY, ThirdY;

    /// <summary>Their z.</summary>
    public double CenterZ, FirstZ, SecondZ, ThirdZ;

    /// <summary>The box along the axes, in the hull's coordinates.</summary>
    public float MinX, MaxX, MinY, MaxY, MinZ, MaxZ;

    /// <summary>The least id of a vertex inside.</summary>
    public int LeastId;

    /// <summary>The first of the two children, which are neighbours, or ~block for a leaf.</summary>
    public int Next;
}
