using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using Gjk.Core.Tests.Support;
using Gjk.Import;

namespace Gjk.Demo.Tests.Import;

/// <summary>Hundreds of damaged files of every kind: bytes exchanged, cut out, doubled or put in. Each is imported or
/// refused, in one line for each thing that is wrong. What is neither refused nor told of is there: a count of the
/// file's own words says so. It never ends in another exception, which the user would see as an internal
/// error.</summary>
public sealed partial class DamagedFileTests
{
    private const int Seed = 88, Files = 1000;

    private const string Obj = "o one\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf -4//1 -3 4\nf 1/1 4 3\nf 2 3 4\n";

    private const string Stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        + "endloop\nendfacet\nendsolid a\n";

    [Theory]
    [InlineData("a.obj")]
    [InlineData("text a.ply")]
    [InlineData("a.ply")]
    [InlineData("text a.stl")]
    [InlineData("a.stl")]
    [InlineData("a.glb")]
    [InlineData("a.gltf")]
    [InlineData("a.unity")]
    public void ADamagedFileIsImportedOrRefused(string name)
    {
        using var directory = new TempDirectory();
        byte[] good = Good(name);
        string file = directory.File(name);
        File.WriteAllBytes(file, good);
        Assert.NotEmpty(Imported.Of(file).Names);
        var random = new Rng(Seed);
        int told = 0, files = Budget.Whole(Files);
        for (int i = 0; i < files; i++)
        {
            byte[] bad = Damage(good, random);
            string seed = $"seed {Seed}, {name} {i}:\n{Encoding.Latin1.GetString(bad)}\n";
            if (Read(file, bad, seed) is not { } result) told++;
            else if (result.Problems.Count > 0) told++;
            else if (Expected(name, bad) is { } expected && result.Objects.Count > 0)
                Assert.True(expected == Found(name, result), $"{seed}{expected} expected, {Found(name, result)} found");
        }

        Assert.InRange(told, files / 10, files);
    }

    /// <summary>A file that ends early is refused or told of, wherever it ends.</summary>
    [Theory]
    [InlineData("a.ply")]
    [InlineData("a.stl")]
    [InlineData("a.glb")]
    [InlineData("a.gltf")]
    public void AFileThatIsCutOffIsNotTakenForWhole(string name)
    {
        using var directory = new TempDirectory();
        byte[] good = Good(name);
        for (int length = 0; length < good.Length; length++)
        {
            ImportResult? result = Read(directory.File(name), good[..length], $"{length} bytes: ");
            Assert.True(result is null || result.Problems.Count > 0, $"{length} of {good.Length} bytes");
        }
    }

    /// <summary>Null if it is refused.</summary>
    private static ImportResult? Read(string file, byte[] bytes, string seed)
    {
        File.WriteAllBytes(file, bytes);
        try
        {
            ImportResult result = Importer.Read(file);
            foreach (ImportProblem problem in result.Problems) AssertIsOneLine(problem.ToString(), seed);
            return result;
        }
        catch (ImportException e)
        {
            AssertIsOneLine(e.Message, seed);
            Assert.True(e.Message.Contains(Path.GetFileName(file)), seed + e.Message);
        }
        catch (Exception e) when (e is not Xunit.Sdk.XunitException)
        {
            Assert.Fail(seed + e);
        }

        return null;
    }

    private static void AssertIsOneLine(string line, string seed) =>
        Assert.True(line.Length > 0 && !line.Any(char.IsControl), seed + line);

    private static int Found(string name, ImportResult result) => name == "a.unity"
        ? result.Objects.Count
        : result.Objects.Sum(o => o.Shape.Mesh!.Triangles.Count / 3);

    /// <summary>How many triangles or shapes the words of a file name; null if that is not told by words.</summary>
    private static int? Expected(string name, byte[] bytes)
    {
        string text = Encoding.Latin1.GetString(bytes);
        string[][] lines =
        [
            .. text.Replace("\\\n", " ").Split('\n', '\r').Select(l => l.Split(name == "a.obj" ? '#' : '\0')[0])
                .Select(l => l.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries)).Where(w => w.Length > 0),
        ];
        switch (name)
        {
            case "a.obj":
                return lines.Where(w => w[0] is "f" or "fo").Sum(Triangles);
            case "text a.stl":
                return lines.Count(w => w[0].Equals("facet", StringComparison.OrdinalIgnoreCase));
            case "text a.ply":
                return lines.SkipWhile(w => w[0] != "end_header").Skip(1 + 2 + 4).Sum(w => int.Parse(w[2]) - 2);
            case "a.stl":
                return (bytes.Length - 84) / 50;
            case "a.gltf":
                using (var json = JsonDocument.Parse(bytes))
                {
                    return json.RootElement.TryGetProperty("accessors", out JsonElement all)
                        && all[1].TryGetProperty("count", out JsonElement count)
                        ? count.GetInt32() / 3
                        : null;
                }

            case "a.unity" when ActiveOwner().Count(text) == ActiveOwner().Count(Encoding.Latin1.GetString(Good(name))):
                return ShapeHeader().Count(text);
            default:
                return null;
        }
    }

    /// <summary>Of a face of a.obj. A corner that is the next one, too, adds none.</summary>
    private static int Triangles(string[] face)
    {
        string[] corners = [.. face.Skip(1).Select(w => w.Split('/')[0])];
        return corners.Where((c, i) => c != corners[(i + 1) % corners.Length]).Count() - 2;
    }

    [GeneratedRegex(@"^--- +!u!(33|64|65|135|136|143) ", RegexOptions.Multiline)]
    private static partial Regex ShapeHeader();

    /// <summary>What decides whether an object is in the scene, and whether another shape of it comes first.</summary>
    [GeneratedRegex(@"^(GameObject:|  m_IsActive: 1|  m_Enabled: 1|  m_GameObject: \{fileID: \d+\})$",
        RegexOptions.Multiline)]
    private static partial Regex ActiveOwner();

    private static byte[] Damage(byte[] good, Rng random)
    {
        byte[] bad = [.. good];
        for (int k = 1 + random.Below(3); k > 0 && bad.Length > 1; k--)
        {
            int at = random.Below(bad.Length);
            bad = random.Below(4) switch
            {
                0 => [.. bad[..at], .. bad[Math.Min(bad.Length, at + 1 + random.Below(8))..]],
                1 => [.. bad[..at], .. bad[random.Below(bad.Length)..]],
                2 => [.. bad[..at], bad[random.Below(bad.Length)], .. bad[at..]],
                _ => [.. bad[..at], (byte)random.Below(256), .. bad[(at + 1)..]],
            };
        }

        return bad;
    }

    private static byte[] Good(string name)
    {
        switch (name)
        {
            case "a.obj":
                return Encoding.ASCII.GetBytes(Obj);
            case "text a.stl":
                return Encoding.ASCII.GetBytes(Stl);
            case "a.stl":
                return StlTests.Good();
            case "text a.ply":
                return PlyTests.Write("ascii", "float", "int");
            case "a.ply":
                return PlyTests.Write("binary_little_endian", "float", "int");
            case "a.glb":
                return GlbTests.Good();
            case "a.gltf":
                return GlbTests.GoodText();
        }

        var text = new UnityText();
        UnityObject top = text.Object("top", scale: new Vector3(2, 1, 1));
        UnityObject one = text.Object("one", top, rotation: new Quaternion(0, 0, 0.6f, 0.8f));
        text.MeshFilter(one, "{fileID: 77}");
        int[] faces = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
        text.Mesh(77, "own", [new(0, 0, 0), new(4, 0, 0), new(0, 2, 0), new(0, 0, 1)], faces);
        text.Capsule(text.Object("two", one), 0.5f, 3, 2);
        return Encoding.UTF8.GetBytes(text.ToString());
    }
}
