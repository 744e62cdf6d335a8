using System.Text.Json;
using Gjk.Demo.View;

namespace Gjk.Demo.Play;

/// <summary>The bodies that a playground offers besides its own shapes, as the library's records.</summary>
internal static class PlayData
{
    /// <summary>The most bodies; a list of more has no use in a browser.</summary>
    public const int MostBodies = 5_000;

    private const int MotionSize = 13;

    /// <param name="data">Where to write.</param>
    /// <param name="scene">The bodies, or null.</param>
    public static void Write(PageData data, Scene? scene)
    {
        SceneObject[] objects = scene?.Objects ?? [];
        var motions = new List<float>(objects.Length * MotionSize);
        Utf8JsonWriter json = data.Json;
        json.WriteStartObject();
        json.WriteString("kind", "play");
        json.WriteString("name", scene?.Name ?? "playground");
        json.WriteStartArray("names");
        foreach (SceneObject o in objects) json.WriteStringValue(o.Name);
        json.WriteEndArray();
        foreach (SceneObject o in objects) AddMotion(motions, o);
        data.Array<int>("shapeOf", WriteShapes(json, objects));
        data.Array<float>("motions", motions.ToArray());
        json.WriteEndObject();
    }

    /// <summary>Writes the distinct shapes as records, as "shapes".</summary>
    /// <returns>The index of each object's shape.</returns>
    public static int[] WriteShapes(Utf8JsonWriter json, SceneObject[] objects)
    {
        var shapes = new Dictionary<ConvexShape, int>();
        var shapeOf = new int[objects.Length];
        json.WriteStartArray("shapes");
        for (int i = 0; i < objects.Length; i++)
        {
            ref readonly ConvexShape shape = ref objects[i].Shape;
            if (shapes.TryGetValue(shape, out shapeOf[i])) continue;
            shapes.Add(shape, shapeOf[i] = shapes.Count);
            json.WriteStringValue(RecordOf(shape));
        }

        json.WriteEndArray();
        return shapeOf;
    }

    /// <summary>A record whose first body has the shape; the page reads only that.</summary>
    private static string RecordOf(in ConvexShape shape)
    {
        RigidPose origin = RigidPose.Identity;
        return new QueryRecord(shape, origin, ConvexShape.Point(), origin).ToString();
    }

    private static void AddMotion(List<float> to, SceneObject o)
    {
        RigidPose pose = o.Pose;
        to.AddRange(
        [
            pose.Rotation.X, pose.Rotation.Y, pose.Rotation.Z, pose.Rotation.W,
            pose.Position.X, pose.Position.Y, pose.Position.Z,
            o.Velocity.X, o.Velocity.Y, o.Velocity.Z,
            o.AngularVelocity.X, o.AngularVelocity.Y, o.AngularVelocity.Z,
        ]);
    }
}
