using System.Diagnostics.CodeAnalysis;

namespace Gjk.Core;

public sealed partial class TriangleMesh
{
    /// <summary>Builds a mesh, or says why it cannot.</summary>
    /// <param name="vertices">Finite points in the local frame; they need not all be used. Copied.</param>
    /// <param name="indices">Three for each triangle, at least one triangle. Copied.</param>
    /// <param name="mesh">The mesh, or null.</param>
    /// <param name="reason">Null, or what is wrong with the lists, in one sentence.</param>
    /// <param name="workers">The threads to use; null for the caller's own. The mesh is the same.</param>
    /// <returns>True when there is a mesh.</returns>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public static bool TryCreate(
        IReadOnlyList<Vector3>? vertices, IReadOnlyList<int>? indices, [NotNullWhen(true)] out TriangleMesh? mesh,
        [NotNullWhen(false)] out string? reason, Workers? workers = null)
    {
        Workers.Check(workers);
        mesh = null;
        Vector3[] points = [];
        int[] corners = [];
        reason = vertices is null || indices is null
            ? "There is no list of vertices, or none of indices."
            : Refusal(vertices, indices, out points, out corners).Reason;
        if (reason is not null) return false;
        mesh = new TriangleMesh(ListsOf(points, corners), Vector3.One, workers: workers);
        return true;
    }

    /// <summary>The same triangles with their vertices moved, as those of a body that bends.</summary>
    /// <param name="vertices">As many as there are, finite. Copied.</param>
    /// <returns>A mesh with the same triangle numbers and scale, which is no height field. Its tree keeps its form and
    /// is fitted to the new places, which is faster than a new one; build anew where triangles have moved far from
    /// their neighbours.</returns>
    /// <exception cref="ArgumentNullException">The list is null.</exception>
    /// <exception cref="ArgumentException">There are more or fewer vertices, or one is not finite.</exception>
    public TriangleMesh WithVertices(IReadOnlyList<Vector3> vertices)
    {
        if (Guard.NotNull(vertices, nameof(vertices)).Count != VertexCount)
            throw new ArgumentException($"There must be {VertexCount} vertices.", nameof(vertices));
        int[] corners = _list.CopyIndices();
        string? reason = Refusal(vertices, corners, out Vector3[] points, out corners).Reason;
        if (reason is not null) throw new ArgumentException(reason, nameof(vertices));
        MeshTopology topology = _topology.WithVertices(points, corners);
        return new TriangleMesh((new TriangleList(points, corners), topology), Scale, Tree);
    }

    private static (TriangleList List, MeshTopology Topology) CheckLists(
        IReadOnlyList<Vector3> vertices, IReadOnlyList<int> indices, Workers? workers)
    {
        Workers.Check(workers);
        Guard.NotNull(vertices, nameof(vertices));
        Guard.NotNull(indices, nameof(indices));
        (string? reason, string? argument) = Refusal(vertices, indices, out Vector3[] points, out int[] corners);
        return reason is null ? ListsOf(points, corners) : throw new ArgumentException(reason, argument);
    }

    private static (TriangleList List, MeshTopology Topology) ListsOf(Vector3[] points, int[] corners) =>
        (new TriangleList(points, corners), new MeshTopology(points, corners));

    private static (string? Reason, string? Argument) Refusal(
        IReadOnlyList<Vector3> vertices, IReadOnlyList<int> indices, out Vector3[] points, out int[] corners)
    {
        points = new Vector3[Math.Max(vertices.Count, 0)];
        corners = new int[Math.Max(indices.Count, 0)];
        for (int i = 0; i < points.Length; i++)
        {
            points[i] = vertices[i];
            if (Guard.IsFinite(points[i])) continue;
            return ($"Vertex {i} has a coordinate that is NaN or infinite.", nameof(vertices));
        }

        if (corners.Length == 0) return ("At least one triangle is needed.", nameof(indices));
        if (corners.Length % 3 != 0)
            return ($"There are {corners.Length} indices, which is not a multiple of 3.", nameof(indices));
        for (int i = 0; i < corners.Length; i++)
        {
            corners[i] = indices[i];
            if ((uint)corners[i] < (uint)points.Length) continue;
            string names = $"Triangle {i / 3} names vertex {corners[i]}";
            return ($"{names}, but there are {points.Length}, counted from 0.", nameof(indices));
        }

        return default;
    }
}
