namespace Gjk.Demo.Tests.Import;

/// <summary>Prefabs with overrides, in scenes and in each other, in the form of today and of old projects.</summary>
public sealed partial class PrefabTests
{
    private static readonly string Crate = UnityText.Guid(0xC0), Stack = UnityText.Guid(0x57);

    [Fact]
    public void AnInstanceTakesItsOverrides()
    {
        using var directory = new TempDirectory();
        UnityObject lid = SaveCrate(directory, out UnityObject root);
        var text = new UnityText();
        UnityObject group = text.Object("group", position: new(0, 0, 100));
        text.Instance(
            5000, Crate, group.Transform,
            [
                (root.Transform, "m_LocalPosition.x", "10"), (root.Transform, "m_LocalScale.y", "2"),
                (root.GameObject, "m_Name", "big crate"), (lid.GameObject, "m_Layer", "3"),
                (424242, "m_Materials.Array.data[0]", "{fileID: 2100000, guid: " + UnityText.Guid(9) + ", type: 2}"),
            ]);
        text.Instance(5001, Crate, 0, [(lid.GameObject, "m_IsActive", "0")]);
        Imported imported = Imported.Quietly(text.Save(directory, "Assets/scene.unity"));
        Assert.Equal(["big crate", "lid", "crate"], imported.Names);
        Imported.AssertBounds(imported["big crate"], new(9.5f, -1, 99.5f), new(10.5f, 1, 100.5f));
        Imported.AssertBounds(imported["lid"], new(9.75f, 1.5f, 99.75f), new(10.25f, 2.5f, 100.25f));
        Imported.AssertBounds(imported["crate"], new(-0.5f), new(0.5f));
    }

    /// <summary>An object of the scene hangs below the prefab, and a collider was added to it.</summary>
    [Fact]
    public void StrippedDocumentsJoinTheSceneToThePrefab()
    {
        using var directory = new TempDirectory();
        UnityObject lid = SaveCrate(directory, out UnityObject root);
        var text = new UnityText();
        text.Instance(5000, Crate, 0, [(root.Transform, "m_LocalPosition.x", "10")]);
        text.Stripped(4, 5001, "Transform", root.Transform, Crate, 5000);
        text.Stripped(1, 5002, "GameObject", lid.GameObject, Crate, 5000);
        text.Stripped(114, 5003, "MonoBehaviour", 77, Crate, 5000);
        var prefabRoot = new UnityObject(0, 5001);
        text.ScriptCollider(text.Object("below", prefabRoot, new(0, 5, 0)), UnityText.Cube);
        text.Ball(new UnityObject(5002, 0), 0.5f);
        Imported imported = Imported.Quietly(text.Save(directory, "Assets/scene.unity"));
        Assert.Equal(["crate", "lid", "below"], imported.Names);
        Imported.AssertBounds(imported["below"], new(9.5f, 4.5f, -0.5f), new(10.5f, 5.5f, 0.5f));

        // The lid has a collider now, so its mesh no longer counts.
        Imported.AssertBounds(imported["lid"], new(9.75f, 0.75f, -0.25f), new(10.25f, 1.25f, 0.25f));
    }

    /// <summary>Overrides of nested objects use numbers that are in no file.</summary>
    [Fact]
    public void PrefabsNest()
    {
        using var directory = new TempDirectory();
        UnityObject lid = SaveCrate(directory, out UnityObject root);
        var stack = new UnityText();
        UnityObject pile = stack.Object("pile");
        stack.Instance(7000, Crate, pile.Transform, [(root.Transform, "m_LocalPosition.y", "1")]);
        stack.Instance(-7001, Crate, pile.Transform, [(root.Transform, "m_LocalPosition.y", "3")]);
        stack.Save(directory, "Assets/Stack.prefab", Stack);
        var text = new UnityText();
        text.Instance(
            8000, Stack, 0,
            [
                (pile.Transform, "m_LocalPosition.z", "-4"),
                ((-7001 ^ root.Transform) & long.MaxValue, "m_LocalPosition.x", "2"),
                ((7000 ^ lid.GameObject) & long.MaxValue, "m_IsActive", "0"),
            ]);
        Imported imported = Imported.Quietly(text.Save(directory, "Assets/scene.unity"));
        Assert.Equal(["crate", "crate #2", "lid"], imported.Names);
        Assert.Equal(new Vector3(0, 1, -4), imported["crate"].Pose.Position);
        Assert.Equal(new Vector3(2, 3, -4), imported["crate #2"].Pose.Position);
        Assert.Equal(new Vector3(2, 4, -4), imported["lid"].Pose.Position);

        // The prefab itself can be imported, too.
        Assert.Equal(
            ["crate", "lid", "crate #2", "lid #2"], Imported.Quietly(directory.File("Assets/Stack.prefab")).Names);
    }

    /// <summary>A variant is a prefab that is an instance of another one, with changes of its own.</summary>
    [Fact]
    public void AVariantKeepsItsChanges()
    {
        using var directory = new TempDirectory();
        UnityObject lid = SaveCrate(directory, out UnityObject root);
        var variant = new UnityText();
        variant.Instance(
            300, Crate, 0, [(lid.GameObject, "m_IsActive", "0"), (root.GameObject, "m_Name", "open crate")]);
        variant.Save(directory, "Assets/Open.prefab", Stack);
        var text = new UnityText();
        text.Instance(5000, Stack, 0, [((300 ^ root.Transform) & long.MaxValue, "m_LocalPosition.x", "7")]);
        text.Instance(5001, Stack, 0, []);
        string scene = text.Save(directory, "Assets/scene.unity");

        // Some versions name the object by the file that it was first written in.
        File.WriteAllText(scene, File.ReadAllText(scene) + $"""
            --- !u!1001 &5002
            PrefabInstance:
              m_Modification:
                m_TransformParent: {UnityText.Ref(0)}
                m_Modifications:
                - target: {UnityText.Ref(root.Transform, Crate)}
                  propertyPath: m_LocalPosition.x
                  value: 9
                  objectReference: {UnityText.Ref(0)}
              m_SourcePrefab: {UnityText.Ref(100100000, Stack)}

            """);
        Imported imported = Imported.Quietly(scene);
        Assert.Equal(["open crate", "open crate #2", "open crate #3"], imported.Names);
        Assert.Equal([7f, 0, 9], imported.Scene.Objects.Select(o => o.Pose.Position.X));
    }

    /// <summary>Old prefab files hold a document about themselves.</summary>
    [Fact]
    public void AnOldPrefabFileIsNoInstanceOfItself()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.Add(1001, 100100000, "Prefab:\n  m_Modification: {}\n  m_ParentPrefab: {fileID: 0}");
        text.Box(text.Object("old"));
        Assert.Equal(["old"], Imported.Quietly(text.Save(directory, "old.prefab")).Names);
    }

    [Fact]
    public void WhatAnInstanceRemovesIsGone()
    {
        using var directory = new TempDirectory();
        UnityObject lid = SaveCrate(directory, out UnityObject root);
        var text = new UnityText();
        text.Instance(
            5000, Crate, 0, [], $"\n    m_RemovedGameObjects:\n    - {UnityText.Ref(lid.GameObject, Crate)}");
        string mesh = UnityText.Ref(root.Transform + 1, Crate);
        text.Instance(5001, Crate, 0, [], $"\n    m_RemovedComponents:\n    - {mesh}");
        Assert.Equal(["crate", "lid"], Imported.Quietly(text.Save(directory, "Assets/scene.unity")).Names);
    }

    /// <summary>The mesh of an override may lie in the file that holds the instance.</summary>
    [Fact]
    public void AnOverrideMayNameAnotherMesh()
    {
        using var directory = new TempDirectory();
        SaveCrate(directory, out UnityObject root);
        var text = new UnityText();
        text.Mesh(77, "tip", [new(0, 0, 0), new(8, 0, 0), new(0, 8, 0)], [0, 1, 2]);
        text.Instance(
            5000, Crate, 0,
            [(root.Transform + 1, "m_Mesh", "{fileID: 77}"), (root.Transform + 4, "m_Mesh", UnityText.Sphere)]);
        Imported imported = Imported.Quietly(text.Save(directory, "Assets/scene.unity"));
        Imported.AssertBounds(imported["crate"], new(0), new(8, 8, 0));
    }

    [Fact]
    public void OldScenesNameTheirPrefabsDifferently()
    {
        using var directory = new TempDirectory();
        SaveCrate(directory, out UnityObject root);
        var text = new UnityText();
        text.Instance(5000, Crate, 0, [(root.Transform, "m_LocalPosition.x", "10")]);
        text.Stripped(4, 5001, "Transform", root.Transform, Crate, 5000);
        text.ScriptCollider(text.Object("below", new UnityObject(0, 5001)), UnityText.Cube);
        string old = text.ToString()
            .Replace("m_SourcePrefab", "m_ParentPrefab").Replace("PrefabInstance:\n", "Prefab:\n")
            .Replace("m_CorrespondingSourceObject", "m_PrefabParentObject")
            .Replace("m_PrefabInstance", "m_PrefabInternal");
        Imported imported = Imported.Quietly(directory.Write("Assets/old.unity", old));
        Assert.Equal([10f, 10, 10], imported.Scene.Objects.Select(o => o.Pose.Position.X));
    }

    [Fact]
    public void PrefabsThatCannotBeReadAreListed()
    {
        using var directory = new TempDirectory();
        SaveCrate(directory, out _);
        directory.Write("Assets/model.fbx", "");
        directory.Write("Assets/model.fbx.meta", $"guid: {UnityText.Guid(1)}\n");
        var self = new UnityText();
        self.Instance(1, UnityText.Guid(2), 0, []);
        self.Save(directory, "Assets/self.prefab", UnityText.Guid(2));
        var text = new UnityText();
        int line = text.NextLine;
        text.Instance(5000, UnityText.Guid(3), 0, []);
        text.Instance(5001, UnityText.Guid(1), 0, []);
        text.Instance(5002, UnityText.Guid(2), 0, []);
        text.Instance(5003, Crate, 0, [(99, "m_LocalPosition.x", "1"), (99, "m_Color.r", "1")]);
        text.ScriptCollider(text.Object("lost", new UnityObject(0, 4711)), UnityText.Cube);
        string scene = text.Save(directory, "Assets/scene.unity");
        Imported imported = Imported.Of(scene);
        Assert.Equal(["crate", "lid"], imported.Names);
        Assert.Equal(5, imported.Lines.Count);
        Assert.StartsWith($"{scene}:{line}: fileID 5000 (PrefabInstance): there is no asset", imported.Lines[0]);
        Assert.Contains("model.fbx: only Unity can make a prefab of a model", imported.Lines[1]);
        Assert.Contains("self.prefab: the prefab holds itself", imported.Lines[2]);
        Assert.Contains("warning: its override of m_LocalPosition.x is ignored", imported.Lines[3]);
        Assert.Contains("there is no Transform 4711", imported.Lines[4]);
    }

    [Fact]
    public void WithoutAProjectAPrefabIsListed()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.Instance(5000, Crate, 0, []);
        string scene = text.Save(directory, "scene.unity");
        Assert.Contains("--project", Assert.Single(Imported.Of(scene).Lines));

        // Named, the project is found from anywhere.
        SaveCrate(directory, out _);
        Assert.Equal(["crate", "lid"], Imported.Quietly(scene, directory.Path).Names);
    }

    /// <summary>A chain of prefabs that each hold the next one twice must end, not fill the memory.</summary>
    [Fact]
    public void AFloodOfPrefabsIsRefused()
    {
        using var directory = new TempDirectory();
        SaveCrate(directory, out _);
        for (int i = 0; i < 30; i++)
        {
            string below = i == 0 ? Crate : UnityText.Guid(100 + i - 1);
            var text = new UnityText();
            for (int k = 0; k < 16; k++) text.Instance(5000 + k, below, 0, []);
            text.Save(directory, $"Assets/{i}.prefab", UnityText.Guid(100 + i));
        }

        Imported.Refused(directory.File("Assets/29.prefab"), "its prefabs have more than");
    }

    /// <summary>A cube with a lid of half its size on top.</summary>
    private static UnityObject SaveCrate(TempDirectory directory, out UnityObject root)
    {
        var text = new UnityText();
        root = text.Object("crate");
        text.MeshFilter(root, UnityText.Cube);
        UnityObject lid = text.Object("lid", root, new Vector3(0, 1, 0), scale: new Vector3(0.5f));
        text.MeshFilter(lid, UnityText.Cube);
        text.Save(directory, Path.Combine("Assets", "Crate.prefab"), Crate);
        return lid;
    }
}
