using System.Collections.Generic;
using System.IO;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Text.Json;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.View;

/// <summary>The page of a scene, with the shapes, and the poses and answers of every frame.</summary>
internal static class ScenePage
{
    public static void Write(Stream stream, Scene scene, ShapeTable shapes, SceneResults results)
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
        data.Array<float>("normal", results.Normal);
        data.Array<int>("overlapping", results.Overlapping);
        data.Array("contactCounts", results.Contacts.Counts);
        data.Array("contactPoints", results.Contacts.Points);
        json.WriteEndObject();
        HtmlPage.Write(
            stream, scene.Name,
            [
                ("objects", scene.Objects.Length), ("pairs", scene.Pairs.Count), ("listed", results.Pairs.Count),
                ("frames", scene.Frames), ("overlapping", results.Overlapping[0]),
            ],
            data.Text);
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
        data.Json.WriteEndObject();
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
