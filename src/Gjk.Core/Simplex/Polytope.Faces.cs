using System;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <remarks>The normals and heights of faces.</remarks>
internal unsafe partial struct Polytope
{
    /// <summary>Writes a face; its twins are still to be joined.</summary>
    /// <param name="index">Where.</param>
    /// <param name="a">A vertex.</param>
    /// <param name="b">The next one.</param>
    /// <param name="c">The last one.</param>
    /// <param name="beside">The normal of the face across the edge from a to b.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly void SetFace(int index, int a, int b, int c, in Vector3D beside)
    {
        ref PolytopeFace face = ref _faces[index];
        face.Vertices[0] = (ushort)a;
        face.Vertices[1] = (ushort)b;
        face.Vertices[2] = (ushort)c;
        if (_cutCount > 0 && (IsDirection(a) || IsDirection(b) || IsDirection(c)))
        {
            SetOpenFace(index, beside);
            return;
        }

        Vector3D p = _vertices[a].W, q = _vertices[b].W, r = _vertices[c].W;
        Vector3D normal = Vector3D.Cross(q - p, r - p);
        double squared = normal.LengthSquared;
        normal *= 1 / Math.Sqrt(squared);
        double least = Heights(normal, p, q, r, out double most);
        if (!(most - least <= _level)) least = Mend(p, q, r, beside, ref normal);
        face.Normal = normal;
        _heights[index] = least;
    }

    /// <summary>
    /// Turns a face's normal to its point that is nearest the origin, along which its height is the most. A new face
    /// lies with the vertex and a face that was taken away on one side of a plane, so it is no nearer the origin than
    /// that one was; where its height is less, its own normal is rounding, as between vertices that nearly coincide.
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private readonly void Raise(int index)
    {
        ref PolytopeFace face = ref _faces[index];
        Vector3D p = _vertices[face.Vertices[0]].W, q = _vertices[face.Vertices[1]].W;
        Vector3D r = _vertices[face.Vertices[2]].W;
        Vector3D nearest = ClosestPointWeights.Triangle(p, q, r).PointOf(p, q, r, default);
        Vector3D normal = nearest * (1 / nearest.Length);
        double height = Heights(normal, p, q, r, out _);
        if (!(height > _heights[index])) return;
        face.Normal = normal;
        _heights[index] = height;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Heights(in Vector3D normal, in Vector3D p, in Vector3D q, in Vector3D r, out double most)
    {
        double a = Vector3D.Dot(normal, p), b = Vector3D.Dot(normal, q), c = Vector3D.Dot(normal, r);
        double larger = a > b ? a : b, smaller = a < b ? a : b;
        most = larger > c ? larger : c;
        return smaller < c ? smaller : c;
    }

    /// <summary>
    /// The normal of a needle, in 106 bits; where even that is none, that of the neighbour. Returns the height.
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static double Mend(in Vector3D p, in Vector3D q, in Vector3D r, in Vector3D beside, ref Vector3D normal)
    {
        VectorDD origin = p;
        var cross = (Vector3D)VectorDD.Cross((VectorDD)q - origin, (VectorDD)r - origin);
        double length = cross.Length;
        normal = length > 0 ? cross * (1 / length) : beside;
        return Heights(normal, p, q, r, out _);
    }
}
