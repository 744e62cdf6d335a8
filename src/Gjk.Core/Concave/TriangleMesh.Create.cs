using System.Diagnostics.CodeAnalysis;

namespace Gjk.Core;

public sealed partial class TriangleMesh
{
    /// <summary>Count: between more lines of a grid there may be no float.</summary>
    private const int MostLines = 1 << 22;

    /// <summary>Builds a mesh, or says why it cannot.</summary>
    /// <param name="vertices">Finite points in the local frame; they need not all be used. Copied.</param>
    /// <param name="indices">Three for each triangle, at least one triangle. Copied.</param>
    /// <param name="mesh">The mesh, or null.</param>
    /// <param name="reason">Null, or what is wrong with the lists, in one sentence.</param>
    /// <returns>True when there is a mesh.</returns>
    public static bool TryCreate(
        IReadOnlyList<Vector3>? vertices, IReadOnlyList<int>? indices, [NotNullWhen(true)] out TriangleMesh? mesh,
        [NotNullWhen(false)] out string? reason)
    {
        mesh = null;
        reason = vertices is null || indices is null
            ? "There is no list of vertices, or none of indices."
            : Refusal(vertices, indices, out _, out _);
        if (reason is not null) return false;
        mesh = new TriangleMesh(vertices!, indices!);
        return true;
    }

    /// <summary>A height field: a surface over the cells of a grid, which keeps the heights alone and no list of
    /// triangles.</summary>
    /// <param name="heights">Row by row, all finite: vertex i is at x = (i % columns) · spacing.X, y = heights[i], z =
    /// (i / columns) · spacing.Y, x and z rounded to float. Copied.</param>
    /// <param name="columns">How many heights a row has; at least 2, and there are at least 2 whole rows.</param>
    /// <param name="spacing">Between columns, along x, and between rows, along z; positive.</param>
    /// <returns>A mesh with two triangles for each cell, row by row, cut from the cell's corner with the greater x to
    /// that with the greater z: 2 · cell is the one at the least x and z. Both look up along y. Its answers are those
    /// of the mesh of the same triangles, to the last bit. For holes make a mesh of the triangles that are
    /// there.</returns>
    /// <exception cref="ArgumentNullException">The list is null.</exception>
    /// <exception cref="ArgumentException">The heights are no grid, or one of them is NaN or infinite.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The spacing is not positive and finite, or the grid leaves the
    /// range of float, or it has more than 4,194,304 columns or rows.</exception>
    public static TriangleMesh FromHeights(IReadOnlyList<float> heights, int columns, Vector2 spacing)
    {
        Guard.NotNull(heights, nameof(heights));
        int rows = columns > 0 ? heights.Count / columns : 0;
        if (columns < 2 || rows < 2 || rows * columns != heights.Count)
        {
            throw new ArgumentException(
                $"{heights.Count} heights are no grid of at least 2 rows of {columns}.", nameof(heights));
        }

        float[] copy = new float[heights.Count];
        for (int i = 0; i < copy.Length; i++)
        {
            copy[i] = heights[i];
            if (!Guard.IsFinite(copy[i]))
                throw new ArgumentException($"Height {i} is NaN or infinite; make a mesh for holes.", nameof(heights));
        }

        if (!IsSpacing(spacing.X, columns) || !IsSpacing(spacing.Y, rows))
            throw new ArgumentOutOfRangeException(nameof(spacing), spacing, "The grid has no such spacing.");
        return new TriangleMesh(new TriangleList(copy, columns, spacing), new MeshTopology(columns, rows), Vector3.One);
    }

    private static bool IsSpacing(float spacing, int lines) =>
        spacing > 0 && Guard.IsFinite(spacing * lines) && lines <= MostLines;

    /// <summary>The same triangles with their vertices moved, as those of a body that bends.</summary>
    /// <param name="vertices">As many as there are, finite. Copied.</param>
    /// <returns>A mesh with the same triangle numbers and scale. Its tree keeps its form and is fitted to the new
    /// places, which is faster than a new one; build anew where triangles have moved far from their
    /// neighbours.</returns>
    /// <exception cref="ArgumentNullException">The list is null.</exception>
    /// <exception cref="ArgumentException">There are more or fewer vertices, or one is not finite.</exception>
    public TriangleMesh WithVertices(IReadOnlyList<Vector3> vertices)
    {
        if (Guard.NotNull(vertices, nameof(vertices)).Count != VertexCount)
            throw new ArgumentException($"There must be {VertexCount} vertices.", nameof(vertices));
        int[] corners = _list.CopyIndices();
        string? reason = Refusal(vertices, corners, out Vector3[] points, out corners);
        if (reason is not null) throw new ArgumentException(reason, nameof(vertices));
        MeshTopology topology = _topology.WithVertices(points, corners);
        return new TriangleMesh(new TriangleList(points, corners), topology, Scale, Tree);
    }

    private static string? Refusal(
        IReadOnlyList<Vector3> vertices, IReadOnlyList<int> indices, out Vector3[] points, out int[] corners)
    {
        points = new Vector3[Math.Max(vertices.Count, 0)];
        corners = new int[Math.Max(indices.Count, 0)];
        for (int i = 0; i < points.Length; i++)
        {
            points[i] = vertices[i];
            if (!Guard.IsFinite(points[i])) return $"Vertex {i} has a coordinate that is NaN or infinite.";
        }

        if (corners.Length == 0) return "At least one triangle is needed.";
        if (corners.Length % 3 != 0) return $"There are {corners.Length} indices, which is not a multiple of 3.";
        for (int i = 0; i < corners.Length; i++)
        {
            corners[i] = indices[i];
            if ((uint)corners[i] < (uint)points.Length) continue;
            return $"Triangle {i / 3} names vertex {corners[i]}, but there are {points.Length}, counted from 0.";
        }

        return null;
    }
}
