using System;
using System.Collections.Generic;
using System.Reflection;
using Gjk.Samples;
using UnityEngine;
using UnityStubs;

namespace Gjk.Unity.Checks;

/// <summary>The two samples, a few frames of each.</summary>
[Collection(nameof(OneScene))]
public sealed class SampleTests : IDisposable
{
    private readonly List<GameObject> _roots = [];

    public void Dispose()
    {
        foreach (GameObject root in _roots) UnityEngine.Object.DestroyImmediate(root);
        Camera.main = null;
    }

    [Fact]
    public void TheVisualizerPaintsWhatIntersectsAndDrawsLines()
    {
        GameObject root = Root("visualizer");
        MeshFilter[] cubes = [Cube(root, 0), Cube(root, 0.75f), Cube(root, 3)];
        var sample = root.AddComponent<Visualizer>();
        Debug.LineCount = 0;
        Messages.Send(sample, "Update");
        Assert.Equal(new Color[] { Color.red, Color.red, Color.green }, Array.ConvertAll(cubes, Paint));
        Assert.True(Debug.LineCount > 2, "two pairs are apart, and the search of the first is drawn");
        Messages.Send(sample, "OnGUI");
    }

    [Fact]
    public void TheVisualizersObjectsFollowTheMouse()
    {
        GameObject root = Root("visualizer"), eye = Root("eye");
        MeshFilter cube = Cube(root, 0);
        eye.transform.localPosition = new Vector3(0.1f, 0.2f, -5);
        Camera.main = eye.AddComponent<Camera>();
        var sample = root.AddComponent<Visualizer>();
        Messages.Send(sample, "Update");
        Mouse(sample, EventType.MouseDown);
        eye.transform.localPosition += new Vector3(2, 1, 0);
        Mouse(sample, EventType.MouseDrag);
        Assert.True((cube.transform.position - new Vector3(2, 1, 0)).magnitude < 1e-5f, $"{cube.transform.position}");
        Mouse(sample, EventType.MouseUp);
        eye.transform.localPosition += new Vector3(2, 1, 0);
        Mouse(sample, EventType.MouseDrag);
        Assert.True((cube.transform.position - new Vector3(2, 1, 0)).magnitude < 1e-5f, $"{cube.transform.position}");
    }

    [Fact]
    public void TheMeasureTestShowsItsFigures()
    {
        GameObject root = Root("measure"), cubes = Root("cubes"), spheres = Root("spheres");
        for (int i = 0; i < 20; i++) Cube(cubes, i == 1 ? 0.5f : i * 2);
        root.SetActive(false);
        var sample = root.AddComponent<MeasureTest>();
        Set(sample, "_cubes", cubes);
        Set(sample, "_spheres", spheres);
        root.SetActive(true);
        Messages.Send(sample, "OnEnable");
        Assert.True(cubes.activeSelf && !spheres.activeSelf);
        for (int frame = 0; frame < 60; frame++) Messages.Send(sample, "Update");
        Messages.Send(sample, "OnGUI");
        Assert.StartsWith("190 calls a frame, 1 pairs intersect\n", GUILayout.LastLabel, StringComparison.Ordinal);
        Assert.EndsWith(" loops per call", GUILayout.LastLabel, StringComparison.Ordinal);
    }

    private static void Mouse(MonoBehaviour sample, EventType type)
    {
        Event.current = new Event { type = type };
        Messages.Send(sample, "OnGUI");
    }

    private static void Set(object sample, string field, object value) =>
        sample.GetType().GetField(field, BindingFlags.Instance | BindingFlags.NonPublic)!.SetValue(sample, value);

    private static Color Paint(MeshFilter filter) => filter.GetComponent<Renderer>().material.color;

    private GameObject Root(string name)
    {
        var root = new GameObject(name);
        _roots.Add(root);
        return root;
    }

    private static MeshFilter Cube(GameObject parent, float x)
    {
        var cube = new GameObject("cube");
        cube.transform.SetParent(parent.transform, false);
        cube.transform.localPosition = new Vector3(x, 0, 0);
        cube.AddComponent<Renderer>();
        var filter = cube.AddComponent<MeshFilter>();
        filter.sharedMesh = Tests.TestMeshes.Cube();
        return filter;
    }
}
