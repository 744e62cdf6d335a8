using System.Runtime.InteropServices;
using System.Text.Json;

namespace Gjk.Demo.View;

/// <summary>The page of a scene, with the shapes, and the poses and answers of every frame.</summary>
internal static class ScenePage
{
    /// <param name="stream">Where to write.</param>
    /// <param name="scene">The scene.</param>
    /// <param name="shapes">Its shapes.</param>
    /// <param name="results">The answers of every frame.</param>
    /// <param name="library">As <see cref="HtmlPage"/> takes it.</param>
    public static void Write(
        Stream stream, Scene scene, ShapeTable shapes, SceneResults results, Action<Stream>? library)
    {
        using var data = new PageData();
        Utf8JsonWriter json = data.Json;
        json.WriteStartObject();
        json.WriteString("kind", "scene");
        json.WriteString("name", scene.Name);
        json.WriteNumber("frames", scene.Frames);
        json.WriteNumber("objects", scene.Objects.Length);
        json.WriteNumber("pairs", results.Pairs.Count);
        json.WriteNumber("allPairs", scene.Pairs.Count);
        WriteNames(json, scene);
        data.Array<int>("shapeOf", shapes.OfObject);
        WriteShapes(data, shapes.Meshes);
        WritePairs(data, results.Pairs);
        data.Array<float>("poses", results.Poses);
        data.Array<byte>("status", results.Status);
        data.Array<ushort>("iterations", results.Iterations);
        data.Array<float>("distance", results.Distance);
        data.Array<float>("pointA", results.PointA);
        data.Array<float>("pointB", results.PointB);
        data.Array<float>("normal", results.Normal);
        if (results.PartA.Length > 0)
        {
            data.Array<int>("partA", results.PartA);
            data.Array<int>("partB", results.PartB);
        }

        data.Array<int>("overlapping", results.Overlapping);
        data.Array("contactCounts", results.Contacts.Counts);
        data.Array("contactPoints", results.Contacts.Points);
        if (scene.HasVelocities) WriteMotion(data, scene, results.Casts);
        json.WriteEndObject();
        HtmlPage.Write(
            stream, scene.Name,
            [
                ("objects", scene.Objects.Length), ("pairs", scene.Pairs.Count), ("listed", results.Pairs.Count),
                ("frames", scene.Frames), ("overlapping", results.Overlapping[0]),
            ],
            data.Text, library);
    }

    /// <summary>Writes a shape's surface in the form that both pages read.</summary>
    public static void WriteShape(PageData data, ShapeMesh mesh)
    {
        data.Json.WriteStartObject();
        data.Json.WriteNumber("dimension", mesh.Dimension);
        data.Json.WriteBoolean("smooth", mesh.IsSmooth);
        data.Array<float>("vertices", MemoryMarshal.Cast<Vector3, float>(mesh.Vertices));
        data.Array<int>("triangles", mesh.Triangles);
        data.Array<int>("edges", mesh.Edges);
        if (mesh.PartStarts.Length > 0) data.Array<int>("partStarts", mesh.PartStarts);
        data.Json.WriteEndObject();
    }

    /// <summary>What a scene at rest does not need.</summary>
    private static void WriteMotion(PageData data, Scene scene, SceneCasts casts)
    {
        var velocities = new Vector3[scene.Objects.Length];
        var turns = new byte[velocities.Length];
        for (int i = 0; i < velocities.Length; i++)
        {
            velocities[i] = scene.Objects[i].Velocity;
            turns[i] = (byte)(scene.Objects[i].AngularVelocity == Vector3.Zero ? 0 : 1);
        }

        data.Array<float>("velocities", MemoryMarshal.Cast<Vector3, float>(velocities));
        data.Array<byte>("turns", turns);
        data.Array("castIndices", casts.Indices);
        data.Array("casts", casts.Entries);
    }

    private static void WriteNames(Utf8JsonWriter json, Scene scene)
    {
        json.WriteStartArray("names");
        foreach (SceneObject o in scene.Objects) json.WriteStringValue(o.Name);
        json.WriteEndArray();
    }

    private static void WriteShapes(PageData data, IReadOnlyList<ShapeMesh> meshes)
    {
        data.Json.WriteStartArray("shapes");
        foreach (ShapeMesh mesh in meshes) WriteShape(data, mesh);
        data.Json.WriteEndArray();
    }

    private static void WritePairs(PageData data, ScenePairs pairs)
    {
        var a = new int[pairs.Count];
        var b = new int[pairs.Count];
        pairs.CopyTo(a, b);
        data.Array<int>("a", a);
        data.Array<int>("b", b);
    }
}
