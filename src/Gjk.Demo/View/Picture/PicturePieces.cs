namespace Gjk.Demo.View;

/// <summary>The bodies of a picture. Each is convex, because what it hides is: an object, or one triangle or part of an
/// object that is not convex.</summary>
internal static class PicturePieces
{
    /// <summary>The most bodies of a scene that is not convex: a larger file is slow to show, and its triangles are
    /// dots.</summary>
    public const int Most = 20_000;

    /// <exception cref="RefusedException">The scene has too many triangles and parts.</exception>
    public static void Check(Scene scene, string name)
    {
        if (scene.IsConvex) return;
        long pieces = 0;
        foreach (SceneObject one in scene.Objects) pieces += one.Any.PartCount;
        if (pieces <= Most) return;
        throw new RefusedException(
            $"{name}: --svg: {pieces} triangles and parts are more than the {Most} that a picture can show");
    }

    /// <param name="scene">The scene.</param>
    /// <param name="shapes">Its shapes.</param>
    /// <param name="drawn">From the world to the units of the picture.</param>
    /// <param name="eye">The position of the eye in these units.</param>
    public static PictureBody[] Of(Scene scene, ShapeTable shapes, Func<Double3, Double3> drawn, in Double3 eye)
    {
        var bodies = new List<PictureBody>(scene.Objects.Length);
        for (int i = 0; i < scene.Objects.Length; i++)
        {
            RigidPose pose = scene.Objects[i].Pose;
            int part = scene.Objects[i].IsConvex ? -1 : 0;
            foreach (ShapeMesh mesh in Meshes(scene.Objects[i].Any, shapes.Meshes[shapes.OfObject[i]]))
                bodies.Add(new PictureBody(mesh, v => drawn(v + pose.Position), pose.Rotation, eye, (i, part++)));
        }

        return bodies.ToArray();
    }

    /// <summary>The triangles and parts at which an object is nearest to another, or overlaps it.</summary>
    /// <param name="results">The answers.</param>
    /// <param name="nearest">The pair of each object with its nearest partner, or -1.</param>
    public static HashSet<(int Object, int Part)> Lit(SceneResults results, int[] nearest)
    {
        var lit = new HashSet<(int Object, int Part)>();
        if (results.PartA.Length == 0) return lit;
        int next = 0;
        foreach ((int a, int b) in results.Pairs)
        {
            int pair = next++;
            if (!results.Overlaps(pair) && nearest[a] != pair && nearest[b] != pair) continue;
            if (results.PartA[pair] >= 0) lit.Add((a, results.PartA[pair]));
            if (results.PartB[pair] >= 0) lit.Add((b, results.PartB[pair]));
        }

        return lit;
    }

    private static IEnumerable<ShapeMesh> Meshes(AnyShape shape, ShapeMesh whole)
    {
        if (shape.Kind == AnyShapeKind.Convex) yield return whole;
        for (int i = 0; i < shape.Compound?.PartCount; i++) yield return ShapeMesh.Of(shape.Compound.GetPart(i));
        for (int i = 0; i < shape.Mesh?.TriangleCount; i++)
        {
            shape.Mesh.GetTriangle(i, out int a, out int b, out int c);
            Vector3[] corners = [whole.Vertices[a], whole.Vertices[b], whole.Vertices[c]];
            yield return ShapeMesh.Of(new ConvexHull(corners), isSmooth: false);
        }
    }
}
