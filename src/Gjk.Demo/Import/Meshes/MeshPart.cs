using System;
using System.Collections.Generic;
using System.Numerics;

namespace Gjk.Demo.Import.Meshes;

/// <summary>A part of a mesh file: the shape of one object. No two of its vertices are the same.</summary>
internal sealed class MeshPart
{
    private MeshPart(string name, Vector3[] vertices, int[] triangles)
    {
        Name = name;
        Vertices = vertices;
        Triangles = triangles;
    }

    public string Name { get; }

    /// <summary>At least one.</summary>
    public Vector3[] Vertices { get; }

    /// <summary>Three indices each. Empty if the file has only points.</summary>
    public int[] Triangles { get; }

    /// <summary>
    /// Welds exact copies. Files repeat a vertex for every normal or texture coordinate that it has, and an STL for
    /// every triangle. Vertices that no triangle uses are dropped if there are triangles.
    /// </summary>
    /// <param name="name">The part's name.</param>
    /// <param name="vertices">As in the file.</param>
    /// <param name="triangles">Three indices each; may be empty.</param>
    public static MeshPart Weld(string name, ReadOnlySpan<Vector3> vertices, IReadOnlyList<int> triangles)
    {
        var distinct = new List<Vector3>();
        var known = new Dictionary<Vector3, int>();
        if (triangles.Count == 0)
        {
            foreach (Vector3 vertex in vertices) IndexOf(vertex, distinct, known);
            return new MeshPart(name, [.. distinct], []);
        }

        var welded = new int[triangles.Count];
        for (int i = 0; i < welded.Length; i++) welded[i] = IndexOf(vertices[triangles[i]], distinct, known);
        return new MeshPart(name, [.. distinct], welded);
    }

    private static int IndexOf(Vector3 vertex, List<Vector3> distinct, Dictionary<Vector3, int> known)
    {
        // -0 and 0 are equal and have one hash, so they are one vertex.
        if (known.TryGetValue(vertex, out int index)) return index;
        known.Add(vertex, distinct.Count);
        distinct.Add(vertex);
        return distinct.Count - 1;
    }
}
