namespace Gjk.Demo.Tests.Import;

/// <summary>What is no scene is refused in one line. What a scene has and cannot be read is listed.</summary>
public sealed class UnityRefusalTests
{
    [Theory]
    [InlineData("%\0Y\0A\0M\0L\0", "it is UTF-16 text")]
    [InlineData("", "must begin with %YAML")]
    [InlineData("UnityFS\0\0", "Force Text")]
    [InlineData("%YAML 1.1\n--- !u!1\nGameObject:\n", ":2: not a header of Unity")]
    [InlineData("%YAML 1.1\n--- !u!one &7\n", ":2: not a header")]
    [InlineData("%YAML 1.1\n--- !u!1 &7 striped\n", ":2: not a header")]
    [InlineData("%YAML 1.1\n--- !u!1 &99999999999999999999\n", ":2: not a header")]
    [InlineData("%YAML 1.1\n--- !u!1 &7\nGameObject:\n--- !u!1 &7\n", ":4: fileID 7 appears twice, first in line 2")]
    [InlineData("%YAML 1.1\n<<<<<<< HEAD\n--- !u!1 &7\nGameObject:\n--- \n", ":5: not a header")]
    public void WhatIsNoSceneIsRefused(string text, string part)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("bad.unity", text);
        Imported.Refused(scene, scene, part);
    }

    [Theory]
    [InlineData("BoxCollider:\n  m_Size: {x: 1", "not valid YAML at line ")]
    [InlineData("BoxCollider:\n  m_GameObject: &a {fileID: 1}\n  m_Size: *a", "it has an alias")]
    [InlineData("BoxCollider:\n  [a, b]: c", "the name of a field is not a text")]
    [InlineData("BoxCollider: {}\nOther: {}", "must be one object")]
    [InlineData("", "must be one object")]
    [InlineData("BoxCollider:\n  m_GameObject: {fileID: 8}", "its GameObject 8 is not in the file")]
    [InlineData("BoxCollider:\n<<<<<<< HEAD\n  m_GameObject: {fileID: 8}", "not valid YAML at line ")]
    [InlineData("BoxCollider:\n  m_GameObject: 5", "its GameObject 0 is not in the file")]
    public void ADamagedObjectIsListedAndTheOthersAreRead(string body, string reason)
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.Box(text.Object("good"));
        int line = text.NextLine;
        text.Add(65, 4711, body);
        text.Box(text.Object("better"));
        string scene = text.Save(directory, "scene.unity");
        Imported imported = Imported.Of(scene);
        Assert.Equal(["good", "better"], imported.Names);
        string listed = Assert.Single(imported.Lines);
        Assert.StartsWith($"{scene}:{line}: fileID 4711 (BoxCollider): ", listed);
        Assert.Contains(reason, listed);
    }

    [Fact]
    public void ShapesOfOtherKindsAreListed()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        (int ClassId, string Type)[] kinds =
        [
            (137, "SkinnedMeshRenderer"), (143, "CharacterController"), (146, "WheelCollider"),
            (154, "TerrainCollider"), (61, "BoxCollider2D"),
        ];
        foreach ((int classId, string type) in kinds) text.Component(text.Object(type).GameObject, classId, type);
        text.Component(text.Object("off", isActive: false).GameObject, 154, "TerrainCollider");
        UnityObject both = text.Object("both");
        text.Component(both.GameObject, 137, "SkinnedMeshRenderer");
        text.Ball(both, 1);
        Imported imported = Imported.Of(text.Save(directory, "scene.unity"));
        Assert.Equal(["both"], imported.Names);
        Assert.Equal(
            kinds.Select(k => $"({k.Type}) of \"{k.Type}\""),
            imported.Lines.Select(l => l[l.IndexOf('(')..(l.LastIndexOf('"') + 1)]));
    }

    [Fact]
    public void WhatALayoutPlacesIsListed()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        long canvas = text.NewId();
        text.Add(1, canvas, "GameObject:\n  m_Name: canvas\n  m_IsActive: 1");
        UnityObject layout = text.Transform(canvas, 0, classId: 224);
        text.Box(text.Object("below", layout));
        string listed = Assert.Single(Imported.Of(text.Save(directory, "scene.unity")).Lines);
        Assert.Contains("(BoxCollider) of \"below\": a RectTransform places it", listed);
    }

    [Fact]
    public void ALoopOfParentsEnds()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        long one = text.NewId(), two = text.NewId();
        foreach (long id in new[] { one, two }) text.Add(1, id, $"GameObject:\n  m_Name: {id}\n  m_IsActive: 1");
        UnityObject first = text.Transform(one, two + 2);
        UnityObject second = text.Transform(two, first.Transform);
        Assert.Equal(two + 2, second.Transform);
        text.Box(first);
        Assert.Contains("below itself", Assert.Single(Imported.Of(text.Save(directory, "loop.unity")).Lines));
    }

    [Theory]
    [InlineData("\r\n")]
    [InlineData("\r")]
    public void WindowsLinesAndAByteOrderMarkAreRead(string end)
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.Box(text.Object("\"A \\u00e9 \\\" name\""));
        string scene = directory.Write("scene.unity", "\uFEFF" + text.ToString().Replace("\n", end));
        Assert.Equal(["A \u00e9 \" name"], Imported.Quietly(scene).Names);
    }

    [Fact]
    public void CharactersOutsideTheBasicPlaneAreRead()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.Box(text.Object("\"\\uD83D\\uDE00\""));
        text.Box(text.Object("\"\\U0001F600\""));
        text.Box(text.Object("\"half \\uD83D\""));
        Imported imported = Imported.Of(text.Save(directory, "scene.unity"));
        Assert.Equal(["\U0001F600", "\U0001F600 #2"], imported.Names);
        Assert.Contains("(GameObject): not valid YAML", imported.Lines[0]);
    }

    /// <summary>A value within values, deeper than the stack allows.</summary>
    [Fact]
    public void DeepYamlDoesNotEndTheProcess()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.Box(text.Object("good"));
        text.Add(65, 4711, "BoxCollider:\n  deep: " + new string('[', 200_000));
        string scene = text.Save(directory, "deep.unity");
        DemoRun run = DemoRun.Of("import", scene, "--out", directory.File("scene.json"));
        Assert.Equal(1, run.ExitCode);
        Assert.Contains("fileID 4711 (BoxCollider): ", run.Error, StringComparison.Ordinal);
        Assert.True(File.Exists(directory.File("scene.json")));
    }
}
