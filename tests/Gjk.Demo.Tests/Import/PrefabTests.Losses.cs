namespace Gjk.Demo.Tests.Import;

/// <summary>What prefabs and models lack is counted, and said where it is missed.</summary>
public sealed partial class PrefabTests
{
    /// <summary>Each instance loses what its prefab cannot bring. All are counted; the first is listed with its
    /// place.</summary>
    [Fact]
    public void EachLossIsCounted()
    {
        using var directory = new TempDirectory();
        var prefab = new UnityText();
        UnityObject root = prefab.Object("crate");
        prefab.Box(root);
        prefab.Component(root.GameObject, 146, "WheelCollider");
        prefab.Component(root.GameObject, 65, "BoxCollider", "m_Size: {x: 1");
        prefab.Save(directory, "Assets/Crate.prefab", Crate);
        var text = new UnityText();
        for (int i = 0; i < 3; i++) text.Instance(5000 + i, Crate, 0, []);
        for (int i = 0; i < 4; i++) text.Instance(6000 + i, UnityText.Guid(3), 0, []);
        Imported imported = Imported.Of(text.Save(directory, "Assets/scene.unity"));
        Assert.Equal(["crate", "crate #2", "crate #3"], imported.Names);
        Assert.Equal([3, 4, 3], imported.Result.Problems.Select(p => p.Count));
        Assert.Equal(10, imported.Result.MissingCount);
        Assert.Contains("(BoxCollider): not valid YAML", imported.Lines[0]);
        Assert.EndsWith("; and 2 more", imported.Lines[0]);
        Assert.Contains("fileID 6000 (PrefabInstance): there is no asset", imported.Lines[1]);
        Assert.Contains("of \"crate\": a WheelCollider is not read; and 2 more", imported.Lines[2]);
    }

    /// <summary>Colliders added to a model in the scene, and objects below it, in a prefab of it, too.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void WhatIsAddedToAModelSaysToWhichItBelongs(bool isVariant)
    {
        using var directory = new TempDirectory();
        Directory.CreateDirectory(directory.File("Assets"));
        string guid = UnityText.Guid(1), model = directory.Write("Assets/model.fbx", "");
        directory.Write("Assets/model.fbx.meta", $"guid: {guid}\n");
        if (isVariant)
        {
            var variant = new UnityText();
            variant.Instance(300, guid, 0, [(919132149155446097, "m_Name", "rock")]);
            variant.Save(directory, "Assets/rock.prefab", Stack);
            guid = Stack;
        }

        var text = new UnityText();
        text.Box(text.Object("good"));
        text.Instance(
            5000, guid, 0, [(77, "m_LocalPosition.x", "1"), (78, "m_LocalPosition.x", "1"), (77, "m_IsActive", "0")]);
        text.Stripped(4, 5001, "Transform", 77, guid, 5000);
        text.Stripped(1, 5002, "GameObject", 76, guid, 5000);
        var added = new UnityObject(5002, 5001);
        for (int i = 0; i < 3; i++) text.Box(added);
        text.Ball(text.Object("below", added), 1);
        string scene = text.Save(directory, "Assets/scene.unity");
        Imported imported = Imported.Of(scene);
        Assert.Equal(["good"], imported.Names);
        Assert.Equal(2, imported.Lines.Count);
        Assert.Contains("model.fbx: only Unity can make a prefab of a model", imported.Lines[0]);
        Assert.EndsWith($"(BoxCollider): it belongs to the model {model}; and 3 more", imported.Lines[1]);
        Assert.Equal(5, imported.Result.MissingCount);
    }
}
