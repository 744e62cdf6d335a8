namespace Gjk.Demo.Tests.Import;

/// <summary>Meshes that a scene names: in itself, in an asset, in a model, or nowhere.</summary>
public sealed class UnityMeshTests
{
    private static readonly Vector3[] Tetrahedron = [new(0, 0, 0), new(4, 0, 0), new(0, 2, 0), new(0, 0, 1)];

    private static readonly int[] Faces = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];

    private static readonly string Asset = UnityText.Guid(0xA5), Model = UnityText.Guid(0x0B);

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void AMeshAssetIsRead(int format)
    {
        using var directory = new TempDirectory();
        var mesh = new UnityText();
        mesh.Mesh(4300000, "tetra", Tetrahedron, Faces, format);
        mesh.Save(directory, "Assets/tetra.asset", Asset);
        Imported imported = Imported.Quietly(SceneWith(directory, $"{{fileID: 4300000, guid: {Asset}, type: 2}}"));
        Assert.Equal(4, imported["first"].Shape.Hull!.VertexCount);
        Imported.AssertBounds(imported["first"], new(0), new(4, 2, 1));
        Imported.AssertBounds(imported["second"], new(10, 0, 0), new(14, 2, 1));

        // Both share one mesh.
        Assert.Equal(["tetra"], imported.Meshes);
    }

    [Fact]
    public void AMeshOfTheSceneItselfIsRead()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        UnityObject one = text.Object("one");
        text.MeshFilter(one, "{fileID: 4711}");
        text.Mesh(4711, "own", [.. Tetrahedron, Tetrahedron[1]], Faces);
        Imported imported = Imported.Quietly(text.Save(directory, "scene.unity"));
        Assert.Equal(Tetrahedron, imported.Vertices("own").Order(VectorOrder));
    }

    [Fact]
    public void AConcaveMeshIsNamedWithItsShareOfTheHull()
    {
        using var directory = new TempDirectory();
        Vector3[] notched = [.. Tetrahedron, new(0.5f, 0.25f, 0.125f)];
        int[] faces = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 4, 2, 3, 4, 3, 1, 4];
        var text = new UnityText();
        text.MeshFilter(text.Object("one"), "{fileID: 4711}");
        int line = text.NextLine;
        text.Mesh(4711, "notched", notched, faces);
        string scene = text.Save(directory, "scene.unity");
        Assert.Equal(
            $"{scene}:{line}: fileID 4711 (Mesh): warning: it is not convex: it fills 37.5 % of its hull's volume; "
            + "as a convex shape it is its hull",
            Assert.Single(Imported.Of(scene).Lines));
    }

    /// <summary>Unity mirrors x, because its axes are left-handed.</summary>
    [Fact]
    public void AnObjFileIsMirroredAndScaled()
    {
        using var directory = new TempDirectory();
        SaveModel(directory, "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", """
            ModelImporter:
              meshes:
                globalScale: 2
                globalScale: 10
            """);
        Imported imported = Imported.Quietly(SceneWith(directory, $"{{fileID: -777, guid: {Model}, type: 3}}"));
        Imported.AssertBounds(imported["first"], new(-10, 0, 0), new(0, 20, 30));
    }

    /// <summary>Old .meta files repeat keys, which YamlDotNet's own documents refuse. The last one counts.</summary>
    [Theory]
    [InlineData("""
        ModelImporter:
          fileIDToRecycleName:
            4300000: wrong
            4300002: low
            4300000: high
        """)]
    [InlineData("""
        ModelImporter:
          internalIDToNameTable:
          - first:
              1: 4300000
            second: low
          - first:
              43: 4300000
            second: high
        """)]
    public void APartOfAnObjFileIsFoundByTheMetaFile(string meta)
    {
        using var directory = new TempDirectory();
        SaveModel(directory, "v 0 0 0\nv 0 1 0\nv 0 0 1\ng low\nf 1 2 3\nv 0 9 0\ng high\nf 1 4 3\n", meta);
        Imported imported = Imported.Quietly(SceneWith(directory, $"{{fileID: 4300000, guid: {Model}, type: 3}}"));
        Imported.AssertBounds(imported["first"], new(0), new(0, 9, 1));
        Imported unknown = Imported.Of(SceneWith(directory, $"{{fileID: 4300004, guid: {Model}, type: 3}}"));
        Assert.Contains("2 parts, and its .meta file does not say which has the fileID 4300004", unknown.Lines[0]);
    }

    [Theory]
    [InlineData("{fileID: 0}", "it has no mesh")]
    [InlineData("{fileID: 4711}", "there is no mesh with the fileID 4711")]
    [InlineData("{fileID: 10299, guid: 0000000000000000e000000000000000, type: 0}", "built-in mesh 10299 is not known")]
    [InlineData("{fileID: 1, guid: 000000000000000000000000000000ff, type: 3}", "there is no asset with the GUID")]
    [InlineData("{fileID: 1, guid: 00000000000000000000000000000f0f, type: 3}", "car.fbx: only Unity can read")]
    [InlineData("{fileID: many}", "fileID: \"many\" is not a whole number")]
    public void AMeshThatCannotBeReadIsListed(string mesh, string reason)
    {
        using var directory = new TempDirectory();
        Directory.CreateDirectory(directory.File("Assets"));
        directory.Write("Assets/car.fbx", "");
        directory.Write("Assets/car.fbx.meta", "guid: 00000000000000000000000000000f0f\n");
        string scene = SceneWith(directory, mesh);
        Imported imported = Imported.Of(scene);
        string line = Assert.Single(imported.Lines);
        Assert.Contains("(MeshFilter) of \"first\": ", line);
        Assert.Contains(reason, line);
        Assert.EndsWith("; and 1 more", line);
        Assert.Equal(2, imported.Result.MissingCount);
    }

    [Theory]
    [InlineData("m_VertexCount: 4", "m_VertexCount: 40", "40 vertices do not fit")]
    [InlineData("m_VertexCount: 4", "m_VertexCount: 0", "no vertices")]
    [InlineData("m_VertexCount: 4", "m_VertexCount: 99999999999", "99999999999 vertices")]
    [InlineData("indexCount: 12", "indexCount: 15", "more indices than m_IndexBuffer")]
    [InlineData("baseVertex: 0", "baseVertex: 1", "there is no vertex 4")]
    [InlineData("path: ", "path: tetra.resS", "in another file, tetra.resS")]
    [InlineData("dimension: 3", "dimension: 2", "three coordinates")]
    [InlineData("format: 0", "format: 7", "the format 7")]
    [InlineData("_typelessdata: 00", "_typelessdata: xy", "not hexadecimal")]
    [InlineData("m_SubMeshes:", "m_CompressedMesh: {m_Vertices: {m_NumItems: 9}}\n  m_SubMeshes:", "compressed")]
    [InlineData("0000803f", "0000807f", "is not finite")]
    public void ADamagedMeshIsListed(string good, string bad, string reason)
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.MeshFilter(text.Object("one"), "{fileID: 4711}");
        text.Mesh(4711, "own", Tetrahedron, Faces);
        string written = text.ToString();
        Assert.Contains(good, written);
        string scene = directory.Write("scene.unity", written.Replace(good, bad));
        string listed = Assert.Single(Imported.Of(scene).Lines);
        Assert.Contains("fileID 4711 (Mesh): ", listed);
        Assert.Contains(reason, listed);
    }

    /// <summary>The plane is 10 by 10 and the quad 1 by 1, as the Editor makes them.</summary>
    [Fact]
    public void TheFlatBuiltInMeshesHaveTheirSizes()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.MeshFilter(text.Object("plane"), UnityText.Cube.Replace("10202", "10209"));
        text.MeshFilter(text.Object("quad"), UnityText.Cube.Replace("10202", "10210"));
        text.MeshFilter(text.Object("cylinder"), UnityText.Cube.Replace("10202", "10206"));
        text.MeshFilter(text.Object("capsule"), UnityText.Cube.Replace("10202", "10208"));
        Imported imported = Imported.Quietly(text.Save(directory, "flat.unity"));
        Imported.AssertBounds(imported["plane"], new(-5, 0, -5), new(5, 0, 5));
        Imported.AssertBounds(imported["quad"], new(-0.5f, -0.5f, 0), new(0.5f, 0.5f, 0));
        Imported.AssertBounds(imported["cylinder"], new(-0.5f, -1, -0.5f), new(0.5f, 1, 0.5f));
        Imported.AssertBounds(imported["capsule"], new(-0.5f, -1, -0.5f), new(0.5f, 1, 0.5f));
        Assert.Equal(ShapeKind.Cylinder, imported["cylinder"].Shape.Kind);
        Assert.Equal(ShapeKind.Capsule, imported["capsule"].Shape.Kind);
    }

    private static readonly System.Collections.Generic.IComparer<Vector3> VectorOrder =
        System.Collections.Generic.Comparer<Vector3>.Create(
            (a, b) => System.Array.IndexOf(Tetrahedron, a) - System.Array.IndexOf(Tetrahedron, b));

    private static void SaveModel(TempDirectory directory, string obj, string importer)
    {
        Directory.CreateDirectory(directory.File("Assets"));
        directory.Write("Assets/model.obj", obj);
        directory.Write("Assets/model.obj.meta", $"fileFormatVersion: 2\nguid: {Model}\n{importer}\n");
    }

    /// <summary>Two objects with the same mesh, ten apart.</summary>
    private static string SceneWith(TempDirectory directory, string mesh)
    {
        var text = new UnityText();
        text.MeshFilter(text.Object("first"), mesh);
        text.MeshFilter(text.Object("second", position: new Vector3(10, 0, 0)), mesh);
        return text.Save(directory, "Assets/scene.unity");
    }
}
