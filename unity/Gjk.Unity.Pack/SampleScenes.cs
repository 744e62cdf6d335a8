using System;
using System.Collections.Generic;
using System.Numerics;
using Gjk.Core;
using Gjk.Exact.Scenes;

namespace Gjk.Unity.Pack;

/// <summary>The scenes of the samples.</summary>
public static class SampleScenes
{
    private const string VisualizerScene = "Samples~/Visualizer/Visualizer.unity";
    private const string VisualizerScript = "Samples~/Visualizer/Visualizer.cs";
    private const string MeasureScene = "Samples~/MeasureTest/MeasureTest.unity";
    private const string MeasureScript = "Samples~/MeasureTest/MeasureTest.cs";

    private const string JobsScene = "Samples~/Jobs/Jobs.unity";
    private const string JobsScript = "Samples~/Jobs/ParallelDistances.cs";

    private const string BenchmarkScene = "Samples~/Benchmark/Benchmark.unity";
    private const string BenchmarkScript = "Samples~/Benchmark/Benchmark.cs";

    public static IReadOnlyList<string> Paths { get; } = [VisualizerScene, MeasureScene, JobsScene, BenchmarkScene];

    /// <summary>The path and the text of each.</summary>
    public static IEnumerable<(string Path, string Text)> All(GuidList guids)
    {
        yield return (VisualizerScene, Visualizer(guids[VisualizerScript]));
        yield return (MeasureScene, MeasureTest(guids[MeasureScript]));
        yield return (JobsScene, Resting("Jobs", guids[JobsScript], BuiltInScenes.Spheres(), "_useLibrary: 0"));
        yield return (BenchmarkScene, Resting("Benchmark", guids[BenchmarkScript], BuiltInScenes.Cubes()));
    }

    /// <summary>Six objects, two pairs of which intersect.</summary>
    private static string Visualizer(string script)
    {
        var scene = new SceneWriter();
        AddStage(scene, new Vector3(0, 0.5f, -7));
        int root = scene.Add("Visualizer", Vector3.Zero);
        scene.AddScript(root, script, "_showSearch: 1", "_searchedPair: 4");
        (string Name, SceneWriter.BuiltInMesh Mesh, Vector3 Position, float Turn)[] objects =
        [
            ("Cube (1)", SceneWriter.BuiltInMesh.Cube, new(-2, 0, 0), 0.4f),
            ("Cube (2)", SceneWriter.BuiltInMesh.Cube, new(-1.25f, 0.5f, 0.25f), 1.1f),
            ("Sphere", SceneWriter.BuiltInMesh.Sphere, new(0.5f, 1.5f, 0), 0),
            ("Capsule", SceneWriter.BuiltInMesh.Capsule, new(2, 0, 0.5f), 0.7f),
            ("Cylinder", SceneWriter.BuiltInMesh.Cylinder, new(2.5f, -0.5f, 0.25f), -0.6f),
            ("Cube (3)", SceneWriter.BuiltInMesh.Cube, new(0.25f, -1.5f, 0), 0.9f),
        ];
        foreach ((string name, SceneWriter.BuiltInMesh mesh, Vector3 position, float turn) in objects)
        {
            scene.AddMesh(scene.Add(name, position, Turned(new Vector3(1, 2, 3), turn), root), mesh);
        }

        return scene.ToString();
    }

    /// <summary>The experiment's objects where the demo has them; the spheres rest until they are asked for.</summary>
    private static string MeasureTest(string script)
    {
        var scene = new SceneWriter();
        AddStage(scene, new Vector3(4, 1, -10));
        int root = scene.Add("MeasureTest", Vector3.Zero);
        int cubes = scene.Add("Cubes", Vector3.Zero, parent: root);
        int spheres = scene.Add("Spheres", Vector3.Zero, parent: root, isActive: false);
        scene.AddScript(root, script, $"_cubes: {{fileID: {cubes}}}", $"_spheres: {{fileID: {spheres}}}");
        AddAll(scene, BuiltInScenes.Cubes(), cubes, SceneWriter.BuiltInMesh.Cube);
        AddAll(scene, BuiltInScenes.Spheres(), spheres, SceneWriter.BuiltInMesh.Sphere);
        return scene.ToString();
    }

    /// <summary>The objects of one of the experiment's scenes, below a script.</summary>
    private static string Resting(string name, string script, BuiltInScene objects, params string[] fields)
    {
        var scene = new SceneWriter();
        AddStage(scene, new Vector3(4, 1, -10));
        int root = scene.Add(name, Vector3.Zero);
        scene.AddScript(root, script, fields);
        bool isCube = objects.Name == "cubes";
        AddAll(scene, objects, root, isCube ? SceneWriter.BuiltInMesh.Cube : SceneWriter.BuiltInMesh.Sphere);
        return scene.ToString();
    }

    private static void AddAll(SceneWriter scene, BuiltInScene source, int parent, SceneWriter.BuiltInMesh mesh)
    {
        for (int i = 0; i < source.Poses.Count; i++)
        {
            RigidPose pose = source.Poses[i];
            scene.AddMesh(scene.Add(source.ObjectNames[i], pose.Position, pose.Rotation, parent), mesh);
        }
    }

    private static void AddStage(SceneWriter scene, Vector3 eye)
    {
        scene.AddCamera(scene.Add("Main Camera", eye, tag: "MainCamera"));
        scene.AddLight(scene.Add("Directional Light", new Vector3(0, 3, 0), Turned(Vector3.UnitX, MathF.PI / 4)));
    }

    /// <summary>A rotation to six digits, so that the file does not depend on a machine's sine.</summary>
    private static Quaternion Turned(Vector3 axis, float angle)
    {
        var q = Quaternion.CreateFromAxisAngle(Vector3.Normalize(axis), angle);
        return new Quaternion(MathF.Round(q.X, 6), MathF.Round(q.Y, 6), MathF.Round(q.Z, 6), MathF.Round(q.W, 6));
    }
}
