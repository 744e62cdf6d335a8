using Gjk.Demo.Play;

namespace Gjk.Demo.View;

/// <summary>Adds the library to the page of a scene, so that its bodies can be dragged and their answers follow. It
/// makes the page 3 MB larger, and each frame of a drag must answer all pairs of a body, so it is only done on request
/// and only for small scenes.</summary>
internal static class LivePage
{
    /// <summary>The most objects: a browser answers the 199 pairs of a body in about a sixtieth of a second.</summary>
    public const int MostObjects = 200;

    /// <exception cref="RefusedException">The scene is too large.</exception>
    public static void Check(Scene scene, string name)
    {
        if (scene.Objects.Length <= MostObjects) return;
        throw new RefusedException(
            $"{name}: --live: {scene.Objects.Length} objects are more than the {MostObjects} that a page can follow");
    }

    /// <summary>Writes the end of the body: what the scene's own data leave out, the library and its script.</summary>
    /// <param name="stream">Where to write.</param>
    /// <param name="scene">The scene.</param>
    /// <param name="pairs">Its pairs, as the page has them.</param>
    public static void Write(Stream stream, Scene scene, ScenePairs pairs)
    {
        PageText.Add(stream, "<script type=\"application/json\" id=\"live\">");
        using (PageData data = Data(scene, pairs)) stream.Write(data.Text);
        PageText.Add(stream, "</script>\n");
        string[] scripts = [.. BrowserRuntime.Scripts(), PageText.Asset("live.js")];
        BrowserRuntime.Write(stream, BrowserRuntime.Notices(), scripts);
    }

    private static PageData Data(Scene scene, ScenePairs pairs)
    {
        var data = new PageData();
        data.Json.WriteStartObject();
        data.Array<int>("shapeOf", PlayData.WriteShapes(data.Json, scene.Objects));
        var gaps = new List<float>();
        foreach ((int a, int b) in pairs)
            gaps.Add(SceneContacts.MostGapOf(scene.Objects[a].Shape, scene.Objects[b].Shape));
        data.Array<float>("mostGaps", gaps.ToArray());
        data.Json.WriteEndObject();
        return data;
    }
}
