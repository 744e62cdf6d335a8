using System;
using System.Collections.Generic;
using System.Reflection;
using Gjk.Samples;
using UnityEngine;
using UnityEngine.Rendering;
using UnityStubs;

namespace Gjk.Unity.Checks;

/// <summary>The samples, a few frames of each.</summary>
[Collection(nameof(OneScene))]
public sealed class SampleTests : IDisposable
{
    private readonly List<GameObject> _roots = [];

    public void Dispose()
    {
        foreach (GameObject root in _roots) UnityEngine.Object.DestroyImmediate(root);
        Camera.main = null;
        Input.IsHeld = false;
        Input.Pressed = default;
        GraphicsSettings.currentRenderPipeline = null;
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
        Input.IsHeld = true;
        Messages.Send(sample, "Update");
        eye.transform.localPosition += new Vector3(2, 1, 0);
        Messages.Send(sample, "Update");
        Assert.True((cube.transform.position - new Vector3(2, 1, 0)).magnitude < 1e-5f, $"{cube.transform.position}");
        Input.IsHeld = false;
        Messages.Send(sample, "Update");
        eye.transform.localPosition += new Vector3(2, 1, 0);
        Messages.Send(sample, "Update");
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
        Assert.StartsWith("190 calls a frame, 1 pairs intersect\n", GUI.LastLabel, StringComparison.Ordinal);
        Assert.EndsWith(" loops per call\nspace bar: spheres", GUI.LastLabel, StringComparison.Ordinal);
        Input.Pressed = KeyCode.Space;
        Cube(spheres, 0);
        Messages.Send(sample, "Update");
        Assert.True(spheres.activeSelf && !cubes.activeSelf);
    }

    [Fact]
    public void KeysChooseThePairAndShowItsSearch()
    {
        GameObject root = Root("visualizer");
        for (int i = 0; i < 3; i++) Cube(root, 3 * i);
        var sample = root.AddComponent<Visualizer>();
        Messages.Send(sample, "OnGUI");
        Assert.EndsWith("S: the search of one pair on, N: next pair", GUI.LastLabel, StringComparison.Ordinal);
        Input.Pressed = KeyCode.S;
        Messages.Send(sample, "Update");
        Messages.Send(sample, "OnGUI");
        Assert.EndsWith("S: the search of one pair off, N: next pair", GUI.LastLabel, StringComparison.Ordinal);
        Input.Pressed = KeyCode.N;
        for (int pair = 1; pair < 5; pair++)
        {
            Messages.Send(sample, "Update");
            Assert.Equal(pair % 3, Get(sample, "_searchedPair"));
        }
    }

    /// <summary>With another pipeline than the built-in one, its material; where it has none, one with its
    /// shader.</summary>
    [Fact]
    public void ObjectsHaveAMaterialOfTheRenderPipeline()
    {
        var pipeline = new RenderPipelineAsset { defaultMaterial = new Material(), defaultShader = new Shader() };
        GraphicsSettings.currentRenderPipeline = pipeline;
        GameObject root = Root("visualizer");
        MeshFilter cube = Cube(root, 0);
        root.AddComponent<Visualizer>();
        Assert.Same(pipeline.defaultMaterial, cube.GetComponent<Renderer>().sharedMaterial);
        pipeline.defaultMaterial = null;
        GameObject other = Root("measure");
        MeshFilter second = Cube(other, 0);
        other.SetActive(false);
        var sample = other.AddComponent<MeasureTest>();
        Set(sample, "_cubes", other);
        Set(sample, "_spheres", root);
        Messages.Send(sample, "OnEnable");
        Assert.Same(pipeline.defaultShader, second.GetComponent<Renderer>().sharedMaterial.shader);
    }

    /// <summary>On job threads and by the library the same figure.</summary>
    [Fact]
    public void TheJobsFindTheLeastDistance()
    {
        GameObject root = Root("jobs");
        for (int i = 0; i < 12; i++) Cube(root, i * (i + 3));
        var sample = root.AddComponent<ParallelDistances>();
        foreach (bool isLibrary in new[] { false, true })
        {
            Set(sample, "_useLibrary", isLibrary);
            Messages.Send(sample, "Update");
            Assert.Equal(3, sample.Least);
        }
    }

    [Fact]
    public void TheBenchmarkShowsEachKindsTimeAndTheVersions()
    {
        GameObject root = Root("benchmark");
        for (int i = 0; i < 5; i++) Cube(root, 0.6f * i);
        var sample = root.AddComponent<Benchmark>();
        Messages.Send(sample, "OnEnable");
        Assert.Equal(10, sample.Pairs);
        Messages.Send(sample, "OnGUI");
        Assert.Equal("", GUI.LastLabel);
        for (int kind = 0; kind < 5; kind++)
        {
            Assert.Equal(double.PositiveInfinity, sample.Nanoseconds(kind));
            Messages.Send(sample, "Update");
            Assert.InRange(sample.Nanoseconds(kind), 1, 1e9);
        }

        Messages.Send(sample, "OnGUI");
        string[] lines = GUI.LastLabel.Split('\n');
        Assert.Matches(@"^Gjk 1\.\S+, Unity 2021\.3\.0f1, Mono$", lines[0]);
        Assert.Equal("10 pairs, ns per query:", lines[1]);
        Assert.Equal(7, lines.Length);
        Assert.Equal($"{sample.Nanoseconds(2):F0}  depth", lines[4]);
    }

    private static object Get(object sample, string field) =>
        sample.GetType().GetField(field, BindingFlags.Instance | BindingFlags.NonPublic)!.GetValue(sample)!;

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
