using System;
using System.Reflection;
using Gjk.Unity.Editor;
using UnityEditor;
using UnityEngine;
using UnityStubs;

namespace Gjk.Unity.Checks;

/// <summary>What the inspectors, the window and the gizmos show.</summary>
[Collection(nameof(OneScene))]
public sealed class EditorTests : IDisposable
{
    private readonly GameObject _box = new("box"), _ball = new("ball");

    public EditorTests()
    {
        _box.AddComponent<BoxCollider>();
        _ball.AddComponent<SphereCollider>();
        _ball.transform.localPosition = new Vector3(3, 0, 0);
        EditorGUILayout.Drawn.Clear();
    }

    public void Dispose()
    {
        UnityEngine.Object.DestroyImmediate(_box);
        UnityEngine.Object.DestroyImmediate(_ball);
        Selection.gameObjects = [];
        Application.isPlaying = false;
    }

    [Fact]
    public void TheInspectorShowsDistanceNormalAndIterations()
    {
        var component = _box.AddComponent<ConvexDistance>();
        var inspector = new ConvexDistanceEditor { target = component };
        inspector.OnInspectorGUI();
        Assert.Equal(["Warning: There is no target."], EditorGUILayout.Drawn);
        component.Target = _ball;
        EditorGUILayout.Drawn.Clear();
        inspector.OnInspectorGUI();
        Assert.Equal("Distance: 2", EditorGUILayout.Drawn[0]);
        Assert.StartsWith("Normal: (1.0000, ", EditorGUILayout.Drawn[1], StringComparison.Ordinal);
        Assert.StartsWith("Iterations: ", EditorGUILayout.Drawn[^1], StringComparison.Ordinal);
        _ball.transform.localPosition = new Vector3(0.75f, 0, 0);
        EditorGUILayout.Drawn.Clear();
        inspector.OnInspectorGUI();
        Assert.Equal("Depth: 0.25", EditorGUILayout.Drawn[0]);
    }

    [Fact]
    public void TheSensorsInspectorListsWhatIsNear()
    {
        var sensor = _box.AddComponent<ProximitySensor>();
        sensor.Radius = 2.5f;
        sensor.Root = _ball;
        sensor.Rescan();
        sensor.Sense();
        var inspector = new ProximitySensorEditor { target = sensor };
        inspector.OnInspectorGUI();
        Assert.Equal(["Info: The sensor looks around while the game plays."], EditorGUILayout.Drawn);
        Application.isPlaying = true;
        EditorGUILayout.Drawn.Clear();
        inspector.OnInspectorGUI();
        Assert.Contains("Near: 1", EditorGUILayout.Drawn);
        Assert.Contains("ball: 2", EditorGUILayout.Drawn);
    }

    /// <summary>What was near in the last frame may have been destroyed since.</summary>
    [Fact]
    public void ADestroyedNeighbourIsShownAsSuch()
    {
        var sensor = _box.AddComponent<ProximitySensor>();
        sensor.Radius = 2.5f;
        sensor.Root = _ball;
        sensor.Rescan();
        sensor.Sense();
        UnityEngine.Object.DestroyImmediate(_ball);
        Application.isPlaying = true;
        new ProximitySensorEditor { target = sensor }.OnInspectorGUI();
        Assert.Contains("destroyed: 2", EditorGUILayout.Drawn);
    }

    [Theory]
    [InlineData(typeof(ProximitySensorEditor))]
    [InlineData(typeof(ConvexDistanceEditor))]
    public void SeveralObjectsCanBeEditedAtOnce(Type type)
    {
        Assert.NotEmpty(type.GetCustomAttributes(typeof(CanEditMultipleObjects), false));
        var inspector = (UnityEditor.Editor)Activator.CreateInstance(type)!;
        inspector.targets = [_box.AddComponent<ConvexDistance>(), _ball.AddComponent<ConvexDistance>()];
        Application.isPlaying = true;
        inspector.OnInspectorGUI();
        Assert.Empty(EditorGUILayout.Drawn);
    }

    /// <summary>A mesh that was imported again may be another one, whatever is compared.</summary>
    [Fact]
    public void AnImportForgetsAllHulls()
    {
        var mesh = Tests.TestMeshes.Cube();
        var filter = _box.AddComponent<MeshFilter>();
        filter.sharedMesh = mesh;
        Gjk.Core.ConvexHull first = GjkShapes.From(filter).Shape.Hull!;
        Import([]);
        Assert.Same(first, GjkShapes.From(filter).Shape.Hull);
        Import(["Assets/cube.fbx"]);
        Assert.NotSame(first, GjkShapes.From(filter).Shape.Hull);
    }

    private static void Import(string[] assets) => typeof(MeshReimport)
        .GetMethod("OnPostprocessAllAssets", BindingFlags.Static | BindingFlags.NonPublic)!
        .Invoke(null, [assets, Array.Empty<string>(), Array.Empty<string>(), Array.Empty<string>()]);

    [Fact]
    public void TheWindowMeasuresTheTwoSelected()
    {
        var window = new MeasureWindow();
        Call(window, "OnEnable");
        Call(window, "OnGUI");
        Assert.StartsWith("Info: Select two objects", EditorGUILayout.Drawn[0], StringComparison.Ordinal);
        Selection.gameObjects = [_box, _ball];
        EditorGUILayout.Drawn.Clear();
        Call(window, "OnGUI");
        Assert.Equal(["A: box", "B: ball", "Distance: 2"], EditorGUILayout.Drawn[..3]);
        SceneView.Draw();
        Call(window, "OnDisable");
    }

    [Fact]
    public void TheGizmoJoinsTheClosestPoints()
    {
        var component = _box.AddComponent<ConvexDistance>();
        component.Target = _ball;
        Messages.Send(component, "OnDrawGizmos");
        Assert.Equal(new Vector3(0.5f, 0, 0), Gizmos.LastLine[0]);
        Assert.Equal(new Vector3(2.5f, 0, 0), Gizmos.LastLine[1]);
        Assert.Equal(Color.white, Gizmos.color);
        _ball.transform.localPosition = new Vector3(0.75f, 0, 0);
        Messages.Send(component, "OnDrawGizmos");
        Assert.Equal(Color.red, Gizmos.color);
    }

    [Fact]
    public void EnterAndExitAreToldOnceAndProblemsLoggedOnce()
    {
        var component = _box.AddComponent<ConvexDistance>();
        string told = "";
        component.Entered.AddListener(() => told += "in ");
        component.Exited.AddListener(() => told += "out ");
        int warnings = Debug.WarningCount;
        Messages.Send(component, "LateUpdate");
        Messages.Send(component, "LateUpdate");
        Assert.Equal(warnings + 1, Debug.WarningCount);
        component.Target = _ball;
        foreach (float x in new[] { 3, 0.75f, 0.5f, 3, 0 })
        {
            _ball.transform.localPosition = new Vector3(x, 0, 0);
            Messages.Send(component, "LateUpdate");
        }

        Messages.Send(component, "OnDisable");
        Assert.Equal("in out in out ", told);
    }

    private static void Call(object owner, string method) =>
        ((Action)Delegate.CreateDelegate(typeof(Action), owner, method))();
}
