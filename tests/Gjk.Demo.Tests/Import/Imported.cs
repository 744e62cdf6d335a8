using Gjk.Demo.Import;
using Gjk.Demo.Scenes;
using Gjk.Import;

namespace Gjk.Demo.Tests.Import;

/// <summary>A file as <c>import</c> makes a scene of it, written and read again by the reader of the other
/// commands.</summary>
internal sealed class Imported
{
    private Imported(Scene scene, ImportResult result)
    {
        Scene = scene;
        Result = result;
        Lines = [.. result.Problems.Select(p => p.ToString())];
    }

    public Scene Scene { get; }

    public ImportResult Result { get; }

    public IEnumerable<string> Meshes => Result.Meshes.Select(m => m.Name);

    /// <summary>What is printed on standard error.</summary>
    public IReadOnlyList<string> Lines { get; }

    public IEnumerable<string?> Names => Scene.Objects.Select(o => o.Name);

    public SceneObject this[string name] => Scene.Objects.Single(o => o.Name == name);

    public IReadOnlyList<Vector3> Vertices(string mesh) => Result.Meshes.Single(m => m.Name == mesh).Vertices;

    public static Imported Of(string file, string? project = null)
    {
        ImportResult result = Importer.Read(file, project);
        using var directory = new TempDirectory();
        string json = directory.File("scene.json");
        using (FileStream stream = File.Create(json))
            SceneJson.Write(stream, Path.GetFileNameWithoutExtension(file), result, false, CancellationToken.None);
        Scene scene = SceneFile.Load(json, CancellationToken.None);
        Assert.Equal(
            result.Objects.Select(o => (o.Name, o.Pose, o.ToConvexShape().ToString())),
            scene.Objects.Select(o => (o.Name!, o.Pose, o.Shape.ToString())));
        return new Imported(scene, result);
    }

    /// <summary>As <see cref="Of"/>, and nothing is said about the file.</summary>
    public static Imported Quietly(string file, string? project = null)
    {
        Imported imported = Of(file, project);
        Assert.Empty(imported.Lines);
        return imported;
    }

    /// <summary>Asserts that the file is refused, with these parts in the message.</summary>
    public static void Refused(string file, params string[] parts)
    {
        var refused = Assert.Throws<ImportException>(() => Importer.Read(file));
        foreach (string part in parts) Assert.Contains(part, refused.Message);
    }

    /// <summary>How far an object reaches in a direction of length 1, in the world.</summary>
    public static double Reach(SceneObject one, in Double3 direction)
    {
        Affine turn = TurnD.From(one.Pose.Rotation).ToAffine();
        Double3 inward = turn.TurnBack(direction);
        one.Shape.Support(inward, out Double3 point);
        return Double3.Dot(inward, point + one.Shape.Center) + one.Shape.Margin
            + Double3.Dot(direction, one.Pose.Position);
    }

    /// <summary>Asserts how far an object reaches along the axes.</summary>
    public static void AssertBounds(SceneObject one, Vector3 min, Vector3 max)
    {
        const double tolerance = 1e-6;
        Double3[] axes = [new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)];
        double size = Math.Max(min.Length(), max.Length());
        for (int i = 0; i < 3; i++)
        {
            Assert.Equal(max[i], Reach(one, axes[i]), tolerance * size);
            Assert.Equal(min[i], -Reach(one, -axes[i]), tolerance * size);
        }
    }
}
