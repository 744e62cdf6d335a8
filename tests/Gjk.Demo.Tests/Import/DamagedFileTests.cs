using System;
using System.IO;
using System.Numerics;
using System.Text;
using Gjk.Demo.Tests.Support;
using Gjk.Import;
using Xunit;

namespace Gjk.Demo.Tests.Import;

/// <summary>
/// Files with a few bytes exchanged, cut off or put in. Each is imported or refused. It never ends in another
/// exception, which the user would see as an internal error.
/// </summary>
public sealed class DamagedFileTests
{
    private const int Seed = 88, Files = 400;

    private const string Obj = "o one\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf -4//1 -3 4\nf 1/1 4 3\nf 2 3 4\n";

    private const string Ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        + "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        + "0 0 0\n1 0 0\n0 2 0\n0 0 3\n3 0 1 2\n";

    private const string Stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        + "endloop\nendfacet\nendsolid a\n";

    [Theory]
    [InlineData("a.obj")]
    [InlineData("a.ply")]
    [InlineData("a.stl")]
    [InlineData("a.glb")]
    [InlineData("a.unity")]
    public void ADamagedFileIsImportedOrRefused(string name)
    {
        using var directory = new TempDirectory();
        byte[] good = Good(name);
        string file = directory.File(name);
        File.WriteAllBytes(file, good);
        Assert.NotEmpty(Imported.Of(file).Names);
        var random = new Random(Seed);
        int refused = 0;
        for (int i = 0; i < Files; i++)
        {
            byte[] bad = Damage(good, random);
            File.WriteAllBytes(file, bad);
            try
            {
                if (Importer.Read(file).MissingCount > 0) refused++;
            }
            catch (ImportException)
            {
                refused++;
            }
            catch (Exception e)
            {
                Assert.Fail($"seed {Seed}, {name} {i}: {e}\n{Convert.ToBase64String(bad)}");
            }
        }

        Assert.InRange(refused, Files / 10, Files);
    }

    private static byte[] Damage(byte[] good, Random random)
    {
        byte[] bad = [.. good];
        for (int k = random.Next(1, 4); k > 0 && bad.Length > 1; k--)
        {
            int at = random.Next(bad.Length);
            bad = random.Next(4) switch
            {
                0 => [.. bad[..at], .. bad[Math.Min(bad.Length, at + random.Next(1, 9))..]],
                1 => [.. bad[..at], .. bad[random.Next(bad.Length)..]],
                2 => [.. bad[..at], bad[random.Next(bad.Length)], .. bad[at..]],
                _ => [.. bad[..at], (byte)random.Next(256), .. bad[(at + 1)..]],
            };
        }

        return bad;
    }

    private static byte[] Good(string name)
    {
        if (name == "a.glb") return GlbTests.Good();
        if (name != "a.unity") return Encoding.ASCII.GetBytes(name == "a.obj" ? Obj : name == "a.ply" ? Ply : Stl);
        var text = new UnityText();
        UnityObject top = text.Object("top", scale: new Vector3(2, 1, 1));
        UnityObject one = text.Object("one", top, rotation: new Quaternion(0, 0, 0.6f, 0.8f));
        text.MeshFilter(one, "{fileID: 77}");
        text.Mesh(77, "own", [new(0, 0, 0), new(4, 0, 0), new(0, 2, 0), new(0, 0, 1)], [0, 2, 1, 0, 1, 3]);
        text.Capsule(text.Object("two", one), 0.5f, 3, 2);
        return Encoding.UTF8.GetBytes(text.ToString());
    }
}
