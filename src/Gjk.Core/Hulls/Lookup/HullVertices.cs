namespace Gjk.Core;

/// <summary>The corners of a hull as its look-up reads them. Immutable.</summary>
internal sealed class HullVertices
{
    /// <summary>Coordinates by axis, counted from <see cref="Origin"/>.</summary>
    public readonly float[] X, Y, Z;

    /// <summary>What <see cref="X"/>, <see cref="Y"/> and <see cref="Z"/> are counted from. No coordinate exceeds four
    /// half extents, so a support is as exact far from the local origin as near it.</summary>
    public readonly Vector3 Origin;

    /// <summary>How many there are.</summary>
    public readonly int Count;

    /// <summary>What they span: 0 a point, 1 a segment, 2 a flat polygon, 3 a solid.</summary>
    public readonly int Dimension;

    /// <summary>The smallest axis-aligned box around them.</summary>
    public readonly Aabb Bounds;

    /// <summary>The middle of <see cref="Bounds"/>.</summary>
    public Double3 Center => ((Double3)Bounds.Min + Bounds.Max) * 0.5;

    /// <param name="points">The corners, in the order of their ids.</param>
    /// <param name="dimension">What they span.</param>
    /// <param name="bounds">The box around them.</param>
    /// <param name="origin">What to count coordinates from.</param>
    public HullVertices(Vector3[] points, int dimension, in Aabb bounds, Vector3 origin)
    {
        (Count, Dimension, Bounds, Origin) = (points.Length, dimension, bounds, origin);
        (X, Y, Z) = (new float[Count], new float[Count], new float[Count]);
        for (int i = 0; i < Count; i++)
        {
            Vector3 point = points[i];
            X[i] = point.X - origin.X;
            Y[i] = point.Y - origin.Y;
            Z[i] = point.Z - origin.Z;
        }
    }

    /// <summary>A vertex in the hull's own frame. The sum is a float again: the one that <see cref="Origin"/> was
    /// subtracted from.</summary>
    public void GetVertex(int id, out Double3 point) => Double3.Write(
        (float)(Origin.X + X[id]), (float)(Origin.Y + Y[id]), (float)(Origin.Z + Z[id]), out point);

    public Vector3 GetVertex(int id) => new(Origin.X + X[id], Origin.Y + Y[id], Origin.Z + Z[id]);

#if NET
    /// <summary>The vertices measured from <see cref="Center"/>: x, y, z and a 0 each.</summary>
    public double[] Centered()
    {
        double[] centered = new double[4 * Count];
        for (int id = 0; id < Count; id++)
        {
            Double3 p = (Double3)GetVertex(id) - Center;
            (centered[4 * id], centered[4 * id + 1], centered[4 * id + 2]) = (p.X, p.Y, p.Z);
        }

        return centered;
    }
#endif
}
