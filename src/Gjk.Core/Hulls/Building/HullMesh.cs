namespace Gjk.Core;

/// <summary>What building a hull yields: the strict corners in the order of first occurrence, and a closed surface of
/// triangles over them.</summary>
internal sealed class HullMesh
{
    /// <summary>0 point, 1 segment, 2 flat polygon, 3 solid.</summary>
    public readonly int Dimension;

    /// <summary>Indices into the distinct points, ascending.</summary>
    public readonly int[] Corners;

    /// <summary>Three corner numbers (not point indices) a triangle, counter-clockwise seen from outside; empty below
    /// dimension 2.</summary>
    public readonly int[] Triangles;

    /// <param name="dimension">0 to 3.</param>
    /// <param name="corners">Point indices, ascending.</param>
    /// <param name="triangles">Point indices, which are renumbered in place.</param>
    /// <param name="pointCount">How many distinct points there are.</param>
    public HullMesh(int dimension, int[] corners, int[] triangles, int pointCount)
    {
        int[] number = new int[pointCount];
        for (int i = 0; i < corners.Length; i++) number[corners[i]] = i;
        for (int i = 0; i < triangles.Length; i++) triangles[i] = number[triangles[i]];
        Dimension = dimension;
        Corners = corners;
        Triangles = triangles;
    }
}
