using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// The convex hull of a cloud of points: its corners without repeats, their neighbours, and the surface as triangles. Immutable; share one
/// between as many shapes and threads as you like.
/// </summary>
public sealed class ConvexHull
{
    /// <summary>Coordinates by axis, padded to a multiple of 8 with copies of vertex 0, which no tie can prefer to the original.</summary>
    internal readonly float[] X, Y, Z;

    /// <summary>Builds the hull of a cloud.</summary>
    /// <param name="points">At least one; repeats and points inside are fine.</param>
    /// <exception cref="ArgumentNullException">The list is null.</exception>
    /// <exception cref="ArgumentException">The list is empty, or a coordinate is NaN or infinite; the message names the index.</exception>
    public ConvexHull(IReadOnlyList<Vector3> points)
    {
        Guard.NotNull(points, nameof(points));
        if (points.Count == 0) throw new ArgumentException("At least one point is needed.", nameof(points));
        var seen = new HashSet<Vector3>();
        var kept = new List<Vector3>();
        for (int i = 0; i < points.Count; i++)
        {
            if (!Guard.IsFinite(points[i])) throw new ArgumentException($"Point {i} is not finite.", nameof(points));
            if (seen.Add(points[i] + Vector3.Zero)) kept.Add(points[i]);
        }

        VertexCount = kept.Count;
        int padded = (kept.Count + 7) / 8 * 8;
        X = new float[padded];
        Y = new float[padded];
        Z = new float[padded];
        var sum = default(Vector3D);
        for (int i = 0; i < padded; i++)
        {
            Vector3 p = kept[i < kept.Count ? i : 0];
            X[i] = p.X;
            Y[i] = p.Y;
            Z[i] = p.Z;
            if (i < kept.Count) sum += p;
        }

        Center = sum * (1.0 / kept.Count);
        foreach (Vector3 p in kept) BoundingRadius = Math.Max(BoundingRadius, (p - Center).Length);
    }

    /// <summary>How many corners the hull has.</summary>
    public int VertexCount { get; }

    /// <summary>The mean of the corners, which lies inside.</summary>
    public Vector3D Center { get; }

    /// <summary>The largest distance of a corner from <see cref="Center"/>.</summary>
    public double BoundingRadius { get; }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void GetVertex(int id, out Vector3D point) => point = new Vector3D(X[id], Y[id], Z[id]);
}
