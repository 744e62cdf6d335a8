namespace Gjk.Demo.Replay;

/// <summary>A scene to replay: one of the report's, or one of the user's.</summary>
/// <param name="Scene">The objects, which rest, and the pairs.</param>
/// <param name="Vertices">Vertices in each object's mesh as given, where they are known and all the same.</param>
/// <param name="Published">What the report says of it, or null.</param>
internal sealed record ReplayScene(Scene Scene, int? Vertices, PublishedFigures? Published)
{
    /// <summary>Pairs of a user's scene. All their results are kept, and written if that is asked for.</summary>
    private const int MostPairs = 1_000_000;

    /// <summary>True if each shape is a mesh without scale, of which the search can be told from the rest.</summary>
    public bool HasPlainMeshes => Array.TrueForAll(
        Scene.Objects, o => o.Shape.Kind == ShapeKind.Mesh && o.Shape == ConvexShape.Mesh(o.Shape.Hull!));

    /// <summary>Vertices of each hull, if they are all the same.</summary>
    public int? HullVertices
    {
        get
        {
            int? count = Scene.Objects[0].Shape.Hull?.VertexCount;
            return HasPlainMeshes && Array.TrueForAll(Scene.Objects, o => o.Shape.Hull!.VertexCount == count)
                ? count
                : null;
        }
    }

    public static ReplayScene Of(BuiltInScene scene) =>
        new(Scene.From(scene), scene.Vertices.Count, PublishedFigures.Of(scene.Name));

    /// <exception cref="RefusedException">It has no pairs, or too many.</exception>
    public static ReplayScene Load(string file, CancellationToken cancel)
    {
        Scene scene = SceneFile.Load(file, cancel);
        if (scene.Pairs.Count is > 0 and <= MostPairs) return new ReplayScene(scene, null, null);
        throw new RefusedException(
            $"{InputFile.NameOf(file)}: $.pairs: {scene.Pairs.Count} pairs, but 1 to {MostPairs} can be replayed");
    }
}
