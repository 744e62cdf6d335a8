namespace Gjk.Exact.Meshes;

/// <summary>Points and triangles as they are given: what a mesh is made of, and what an oracle reads.</summary>
/// <param name="Points">The vertices.</param>
/// <param name="Indices">Three for each triangle.</param>
public sealed record TriangleSoup(Vector3[] Points, int[] Indices)
{
    /// <summary>How many triangles there are.</summary>
    public int Count => Indices.Length / 3;

    /// <summary>A corner of a triangle.</summary>
    public Vector3 Corner(int triangle, int corner) => Points[Indices[3 * triangle + corner]];

    public TriangleMesh Build() => new(Points, Indices);

    public TriangleSoup Moved(Func<Vector3, Vector3> to) => this with { Points = Array.ConvertAll(Points, p => to(p)) };

    /// <summary>These triangles and then those.</summary>
    public TriangleSoup And(TriangleSoup other) =>
        new([.. Points, .. other.Points], [.. Indices, .. other.Indices.Select(i => i + Points.Length)]);

    /// <summary>Without some triangles in a row, and without the points that no other one has.</summary>
    public TriangleSoup Without(int first, int count)
    {
        int[] left = [.. Indices.Take(3 * first), .. Indices.Skip(3 * (first + count))];
        var places = new Dictionary<int, int>();
        foreach (int i in left) places.TryAdd(i, places.Count);
        return new TriangleSoup([.. places.Keys.Select(i => Points[i])], [.. left.Select(i => places[i])]);
    }
}
