namespace Gjk.Demo.Tests.Import;

/// <summary>Unity's colliders under scale, off their object's centre, and switched off.</summary>
public sealed class ColliderTests
{
    [Fact]
    public void ABoxFollowsTheScaleOfItsAxes()
    {
        Imported imported = Of(text => text.Box(
            text.Object("box", position: new(1, 2, 3), scale: new(2, -3, 4)), new(1, 2, 0.5f), new(0.5f, 1, -1)));
        Imported.AssertBounds(imported["box"], new(1, -4, -2), new(3, 2, 0));
        Assert.Equal(ShapeKind.Box, imported["box"].Shape.Kind);
    }

    [Fact]
    public void ASphereFollowsTheLargestScale()
    {
        Imported imported = Of(text => text.Ball(
            text.Object("ball", scale: new(1, -3, 2)), 0.5f, new Vector3(1, 1, 1)));
        Imported.AssertBounds(imported["ball"], new(-0.5f, -4.5f, 0.5f), new(2.5f, -1.5f, 3.5f));
    }

    /// <summary>The radius follows the larger scale across the axis, the height that along it.</summary>
    [Theory]
    [InlineData(0, 4, 3, 3)]
    [InlineData(1, 3, 6, 3)]
    [InlineData(2, 2, 2, 8)]
    public void ACapsuleLiesAlongItsDirection(int direction, float x, float y, float z)
    {
        Imported imported = Of(text => text.Capsule(
            text.Object("capsule", scale: new(2, 3, direction == 1 ? 2 : direction == 0 ? 1 : 4)),
            direction == 0 ? 1 : direction == 1 ? 1.5f : 2 / 3f, 4, direction));
        float half = direction switch
        {
            0 => x,
            1 => y,
            _ => z,
        };
        Vector3 corner = direction switch
        {
            0 => new(half, 3, 3),
            1 => new(3, half, 3),
            _ => new(2, 2, half),
        };
        Imported.AssertBounds(imported["capsule"], -corner, corner);
    }

    [Fact]
    public void ALowCapsuleIsABall()
    {
        Imported imported = Of(text => text.Capsule(text.Object("low"), 0.75f, 1, 1, new(0, 1, 0)));
        Assert.Equal(ShapeKind.Sphere, imported["low"].Shape.Kind);
        Imported.AssertBounds(imported["low"], new(-0.75f, 0.25f, -0.75f), new(0.75f, 1.75f, 0.75f));
    }

    /// <summary>A character stands upright however its object is turned; its width follows x and z.</summary>
    [Fact]
    public void ACharacterIsAnUprightCapsule()
    {
        Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2);
        Imported imported = Of(text => text.Component(
            text.Object("player", position: new(5, 0, 0), rotation: turn, scale: new(3, 2, 1)).GameObject, 143,
            "CharacterController", "m_Height: 4", "m_Radius: 0.5", "m_SkinWidth: 0.08",
            "m_Center: {x: 0, y: 1, z: 0}"));
        Assert.Equal(ShapeKind.Capsule, imported["player"].Shape.Kind);
        Imported.AssertBounds(imported["player"], new(1.5f, -4, -1.5f), new(4.5f, 4, 1.5f));
    }

    /// <summary>With Convex ticked the hull is meant: no warning, and no surface.</summary>
    [Theory]
    [InlineData(1, "\"type\": \"mesh\"")]
    [InlineData(0, "\"type\": \"surface\"")]
    public void AConvexMeshColliderStaysAHull(int convex, string type)
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        UnityObject one = text.Object("open");
        text.Component(one.GameObject, 64, "MeshCollider", $"m_Convex: {convex}", "m_Mesh: {fileID: 77}");
        text.Mesh(77, "own", [new(0, 0, 0), new(4, 0, 0), new(0, 2, 0), new(0, 0, 1)], [0, 2, 1, 0, 1, 3]);
        string scene = text.Save(directory, "scene.unity");
        Assert.Equal(1 - convex, Imported.Of(scene).Lines.Count);
        DemoRun run = DemoRun.Of("import", scene, "--concave");
        run.AssertDone();
        Assert.Contains(type, run.Out);
    }

    [Fact]
    public void AMeshColliderIsItsMesh()
    {
        Imported imported = Of(text =>
        {
            UnityObject one = text.Object("cube", scale: new(2, 1, 1));
            text.Component(one.GameObject, 64, "MeshCollider", "m_Convex: 1", "m_Mesh: " + UnityText.Cube);
        });
        Imported.AssertBounds(imported["cube"], new(-1, -0.5f, -0.5f), new(1, 0.5f, 0.5f));
    }

    /// <summary>An object's mesh is what is seen; its colliders are what is touched.</summary>
    [Fact]
    public void CollidersComeBeforeTheMesh()
    {
        Imported imported = Of(text =>
        {
            UnityObject one = text.Object("both");
            text.MeshFilter(one, UnityText.Cube);
            text.Ball(one, 1);
            text.Box(one, new(4, 4, 4));
        });
        Assert.Equal(["both (SphereCollider)", "both (BoxCollider)"], imported.Names);
    }

    [Fact]
    public void WithoutAnEnabledColliderTheMeshCounts()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        UnityObject one = text.Object("off");
        text.MeshFilter(one, UnityText.Cube);
        text.Ball(one, 3);
        string scene = directory.Write(
            "off.unity", text.ToString().Replace("m_Enabled: 1\n  m_Radius", "m_Enabled: 0\n  m_Radius"));
        Imported.AssertBounds(Imported.Quietly(scene)["off"], new(-0.5f), new(0.5f));
    }

    /// <summary>Under skew a box keeps only what is left along its own axes.</summary>
    [Fact]
    public void ABoxUnderSkewFollowsTheLossyScale()
    {
        Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 4);
        Imported imported = Of(text => text.Box(
            text.Object("box", text.Object("stretched", scale: new(3, 1, 1)), rotation: turn)));

        // Along its own x and y the matrix leaves (3 + 1) / 2, and the box is turned by 45 degrees.
        float half = MathF.Sqrt(2);
        Imported.AssertBounds(imported["box"], new(-half, -half, -0.5f), new(half, half, 0.5f));
    }

    [Theory]
    [InlineData("m_Direction: 1", "m_Direction: 3", "m_Direction 3 is not an axis")]
    [InlineData("m_Radius: 0.5", "m_Radius: .inf", "m_Radius: \".inf\" is not a finite number")]
    [InlineData("m_Radius: 0.5", "m_Radius: 1e39", "not a finite number")]
    [InlineData("m_Radius: 0.5", "m_Radios: 0.5", "m_Radius is missing")]
    [InlineData("m_Center: {x: 0, y: 0", "m_Center: {x: 0, v: 0", "m_Center.y is missing")]
    [InlineData("m_Radius: 0.5", "m_Radius: -3e38\n  x: 0", "too large for a float")]
    [InlineData("w: 1}", "w: 0}", "m_LocalRotation has no length")]
    public void ACapsuleThatCannotBeReadIsListed(string good, string bad, string reason)
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        UnityObject one = text.Object("one", scale: new(2, 1, 1));
        int line = text.NextLine;
        long id = text.Capsule(one, 0.5f, 9, 1);
        string written = text.ToString();
        Assert.Contains(good, written);
        string scene = directory.Write("bad.unity", written.Replace(good, bad));
        string listed = Assert.Single(Imported.Of(scene).Lines);
        Assert.StartsWith($"{scene}:{line}: fileID {id} (CapsuleCollider) of \"one\": ", listed);
        Assert.Contains(reason, listed);
    }

    private static Imported Of(Action<UnityText> write)
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        write(text);
        return Imported.Quietly(text.Save(directory, "colliders.unity"));
    }
}
