using System.Globalization;
using System.Text;
using Gjk.Import;

namespace Gjk.Demo.Tests.Import;

/// <summary>Faces of files that are no triangles: concave polygons, strips, and what is too small for one.</summary>
public sealed class FaceTests
{
    private static readonly Vector3[] Corners =
    [
        new(0, 0, 0), new(3, 0, 0), new(3, 1, 0), new(1, 1, 0), new(1, 3, 0), new(0, 3, 0),
        new(0, 0, 1), new(3, 0, 1), new(3, 1, 1), new(1, 1, 1), new(1, 3, 1), new(0, 3, 1),
    ];

    private static readonly int[][] Faces =
    [
        [2, 1, 0, 5, 4, 3], [8, 9, 10, 11, 6, 7], [0, 1, 7, 6], [1, 2, 8, 7], [2, 3, 9, 8], [3, 4, 10, 9],
        [4, 5, 11, 10], [5, 0, 6, 11],
    ];

    /// <summary>A fan over the notch of the L would fill it: the point would be 0.5 away.</summary>
    [Theory]
    [InlineData("l.obj")]
    [InlineData("l.ply")]
    public void ALIsNotFilled(string name)
    {
        using var directory = new TempDirectory();
        string file = directory.Write(name, name == "l.obj" ? Obj() : Ply());
        ImportResult read = Importer.Read(file);
        Assert.Contains("is not convex", Assert.Single(read.Problems).What);
        ImportedObject one = Assert.Single(read.Objects);
        Assert.True(new TriangleMesh(one.Shape.Mesh!.Vertices, one.Shape.Mesh.Triangles).HasInside);
        AnyShape point = AnyShape.Of(ConvexShape.Point()), solid = one.ToAnyShape();
        float Distance(float x, float y, float z) => ConcaveQuery.Distance(
            solid, one.Pose, point, new RigidPose(Quaternion.Identity, new Vector3(x, y, z)), new ConcaveScratch())
            .Result.Distance;
        Assert.Equal(0.7f, Distance(1.7f, 2.1f, 0.5f), 1e-6f);
        Assert.Equal(0.2f, Distance(1.2f, 2.6f, 0.4f), 1e-6f);
        Assert.Equal(0, Distance(0.5f, 2, 0.5f));

        DemoRun run = DemoRun.Of("import", file, "--concave");
        run.AssertDone();
        Assert.Equal("", run.Error);
        Assert.Contains("\"type\": \"surface\"", run.Out);
        Assert.Contains("\"solid\": true", run.Out);
    }

    [Theory]
    [InlineData("ascii", "0 1 2 3 -1 2 1 4", new[] { 0, 1, 2, 1, 3, 2, 2, 1, 4 })]
    [InlineData("ascii", "-1 0 1 -1 -1 0 1 2 -1", new[] { 0, 1, 2 })]
    [InlineData("binary_little_endian", "0 1 2 3 -1 2 1 4", new[] { 0, 1, 2, 1, 3, 2, 2, 1, 4 })]
    public void StripsAreFaces(string format, string strip, int[] expected)
    {
        using var directory = new TempDirectory();
        string file = directory.File("strips.ply");
        string header = $"ply\nformat {format} 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
            + "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n";
        float[] numbers = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1, 0, 0, 2];
        int[] indices = [.. strip.Split(' ').Select(w => int.Parse(w, CultureInfo.InvariantCulture))];
        byte[] rows =
        [
            .. numbers.SelectMany(BitConverter.GetBytes), .. BitConverter.GetBytes(indices.Length),
            .. indices.SelectMany(BitConverter.GetBytes),
        ];
        if (format == "ascii")
        {
            IEnumerable<string> lines = numbers.Chunk(3).Select(v => string.Join(' ', v) + "\n");
            rows = Encoding.ASCII.GetBytes($"{string.Concat(lines)}{indices.Length} {strip}\n");
        }

        File.WriteAllBytes(file, [.. Encoding.ASCII.GetBytes(header), .. rows]);
        ImportedMesh mesh = Assert.Single(Importer.Read(file).Meshes);
        Vector3 Given(int vertex) => new(numbers[3 * vertex], numbers[3 * vertex + 1], numbers[3 * vertex + 2]);
        Assert.Equal(expected.Select(Given), mesh.Triangles.Select(i => mesh.Vertices[i]));
        DemoRun run = DemoRun.Of("import", file, "--concave");
        run.AssertDone();
        if (expected.Length > 3) Assert.Contains("\"type\": \"surface\"", run.Out);
    }

    /// <summary>What a colour says is not asked, whatever its words are; a position must be a number.</summary>
    [Theory]
    [InlineData("nan", true)]
    [InlineData("-nan(ind)", true)]
    [InlineData("inf", true)]
    [InlineData("1e99", true)]
    [InlineData("0.5", true)]
    [InlineData("nan", false)]
    public void AColourIsNoPosition(string word, bool isColour)
    {
        using var directory = new TempDirectory();
        string row = isColour ? $"1 2 3 {word}" : $"1 {word} 3 0";
        string file = directory.Write(
            "a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
            + $"property float red\nend_header\n{row}\n");
        if (isColour) Assert.Equal([new(1, 2, 3)], Imported.Quietly(file).Vertices("a"));
        else Imported.Refused(file, ":9: \"nan\" is not a number");
    }

    [Theory]
    [InlineData("f 1 2\nf 1\nf 1 2 2 1\n", ":5: warning: a face of fewer than three corners is left out; and 2 more")]
    [InlineData("f 1 2 4 3\n", ":5: warning: the outline of a face crosses or touches itself, so its triangles may")]
    public void OddFacesAreTold(string odd, string told)
    {
        using var directory = new TempDirectory();
        string file = directory.Write("a.obj", $"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n{odd}f 1 2 3 4\n");
        Imported imported = Imported.Of(file);
        Assert.StartsWith(file + told, imported.Lines[0]);
        Assert.True(imported.Result.Meshes[0].Triangles.Count >= 6);
    }

    private static string Obj() =>
        string.Concat(Corners.Select(v => FormattableString.Invariant($"v {v.X} {v.Y} {v.Z}\n")))
        + string.Concat(Faces.Select(f => $"f {string.Join(' ', f.Select(i => i + 1))}\n"));

    private static string Ply() =>
        "ply\nformat ascii 1.0\nelement vertex 12\nproperty float x\nproperty float y\nproperty float z\n"
        + "element face 8\nproperty list uchar int vertex_indices\nend_header\n"
        + string.Concat(Corners.Select(v => FormattableString.Invariant($"{v.X} {v.Y} {v.Z}\n")))
        + string.Concat(Faces.Select(f => $"{f.Length} {string.Join(' ', f)}\n"));
}
