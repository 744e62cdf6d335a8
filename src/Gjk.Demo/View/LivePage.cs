using System;
using System.Collections.Generic;
using System.IO;
using System.Net;
using System.Text;
using Gjk.Demo.Play;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.View;

/// <summary>
/// Adds the library to the page of a scene, so that its bodies can be dragged and their answers follow. It makes the
/// page 3 MB larger, and each frame of a drag must answer all pairs of a body, so it is only done on request and only
/// for small scenes.
/// </summary>
internal static class LivePage
{
    /// <summary>The most objects: a browser answers the 199 pairs of a body in about a sixtieth of a second.</summary>
    public const int MostObjects = 200;

    private const string Policy = "script-src 'unsafe-inline'", End = "</body>";

    /// <exception cref="RefusedException">The scene is too large.</exception>
    public static void Check(Scene scene, string name)
    {
        if (scene.Objects.Length <= MostObjects) return;
        throw new RefusedException(
            $"{name}: --live: {scene.Objects.Length} objects are more than the {MostObjects} that a page can follow");
    }

    /// <param name="stream">Where to write.</param>
    /// <param name="page">The page of the scene.</param>
    /// <param name="scene">The scene.</param>
    /// <param name="pairs">Its pairs, as the page has them.</param>
    public static void Write(Stream stream, ReadOnlySpan<byte> page, Scene scene, ScenePairs pairs)
    {
        string text = Encoding.UTF8.GetString(page);
        int policy = text.IndexOf(Policy, StringComparison.Ordinal) + Policy.Length;
        int end = text.LastIndexOf(End, StringComparison.Ordinal);
        if (policy < Policy.Length || end < policy) throw new InvalidOperationException("The page has a new form.");
        Add(stream, text.AsSpan(0, policy));
        Add(stream, " 'wasm-unsafe-eval'");
        Add(stream, text.AsSpan(policy, end - policy));
        Add(stream, "<script type=\"application/json\" id=\"live\">");
        using (PageData data = Data(scene, pairs)) stream.Write(data.Text);
        Add(stream, "</script>\n<script type=\"application/json\" id=\"runtime\">");
        stream.Write(BrowserRuntime.Files());
        string notices = WebUtility.HtmlEncode(BrowserRuntime.Notices());
        Add(stream, $"</script>\n<template id=\"notices\">{notices}</template>\n");
        foreach (string script in (IEnumerable<string>)[.. BrowserRuntime.Scripts(), ScriptPage.Asset("live.js")])
            Add(stream, $"<script type=\"module\">{script}</script>\n");
        Add(stream, text.AsSpan(end));
        stream.Flush();
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

    private static void Add(Stream stream, ReadOnlySpan<char> text)
    {
        byte[] bytes = new byte[Encoding.UTF8.GetByteCount(text)];
        stream.Write(bytes, 0, Encoding.UTF8.GetBytes(text, bytes));
    }
}
