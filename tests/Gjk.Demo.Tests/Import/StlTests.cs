using System.Text;

namespace Gjk.Demo.Tests.Import;

/// <summary>STL files, text and binary.</summary>
public sealed class StlTests
{
    private static readonly Vector3[] Corners = [new(0, 0, 0), new(1, 0, 0), new(0, 2, 0), new(0, 0, 3)];

    private static readonly int[] Faces = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];

    [Fact]
    public void EachSolidOfATextIsAPart()
    {
        using var directory = new TempDirectory();
        string first = Solid("the first");
        string file = directory.Write("two.stl", first + Solid("") + first.ToUpperInvariant());
        Imported imported = Imported.Quietly(file);
        Assert.Equal(["the first", "two", "THE FIRST"], imported.Names);
        foreach (Gjk.Demo.Scenes.SceneObject one in imported.Scene.Objects)
            Imported.AssertBounds(one, new(0), new(1, 2, 3));
        Assert.All(imported.Result.Meshes, m => Assert.Equal(4, m.Vertices.Count));
    }

    /// <summary>Some programs begin the title of a binary file with the word that marks a text.</summary>
    [Theory]
    [InlineData("made by hand")]
    [InlineData("solid made by hand")]
    public void ABinaryFileIsRead(string title)
    {
        using var directory = new TempDirectory();
        string file = directory.File("part.stl");
        File.WriteAllBytes(file, Binary(title, [.. Faces.Select(i => Corners[i])]));
        Imported imported = Imported.Quietly(file);
        Assert.Equal(["part"], imported.Names);
        Assert.Equal([Corners[0], Corners[2], Corners[1], Corners[3]], imported.Vertices("part"));
    }

    [Fact]
    public void AnEmptySolidIsPassedOver()
    {
        using var directory = new TempDirectory();
        string file = directory.Write("two.stl", "solid none\nendsolid none\n" + Solid("one") + "solid\nendsolid\n");
        Imported imported = Imported.Of(file);
        Assert.Equal(["one"], imported.Names);
        Assert.Equal(
            $"{file}:2: warning: the solid \"none\" has no triangles, and is left out; and 1 more",
            Assert.Single(imported.Lines));
    }

    [Theory]
    [InlineData("made by hand")]
    [InlineData("solid made by hand")]
    public void BytesBehindTheTrianglesArePassedOver(string title)
    {
        using var directory = new TempDirectory();
        string file = directory.File("part.stl");
        File.WriteAllBytes(file, [.. Binary(title, [.. Faces.Select(i => Corners[i])]), 1, 2, 3]);
        Imported imported = Imported.Of(file);
        Assert.Equal(["part"], imported.Names);
        Assert.Contains("3 bytes behind its 4 triangles", Assert.Single(imported.Lines));

        // A file that is cut off is none of text, whatever its title begins with.
        File.WriteAllBytes(file, Binary(title, [.. Faces.Select(i => Corners[i])])[..^1]);
        Imported.Refused(file, "4 triangles need 284 bytes, but it has 283");
    }

    [Fact]
    public void CarriageReturnsEndLines()
    {
        using var directory = new TempDirectory();
        string file = directory.Write("mac.stl", "\uFEFF" + Solid("one").Replace("\n", "\r"));
        Assert.Equal(["one"], Imported.Quietly(file).Names);
    }

    [Theory]
    [InlineData("solid a\nfacet normal 0 0 1 outer\n", ":2: there is more behind \"facet\": \"outer\"")]
    [InlineData("solid a\nfacet normal 0 0 1\nouter loop vertex\n", ":3: there is more behind \"outer\"")]
    [InlineData("", "neither begins with \"solid\" nor has the 84 bytes")]
    [InlineData("hello", "neither begins with \"solid\"")]
    [InlineData("solid a\nendsolid a\n", ":2: the solid \"a\" has no triangles")]
    [InlineData("solid a\n", "the file ends before \"endsolid\"")]
    [InlineData("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", ":4: a vertex needs three coordinates")]
    [InlineData("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n", ":4: \"x\" is not a number")]
    [InlineData("solid a\nfacet normal 0 0 1\nvertex 0 0 0\n", ":3: must be \"outer\", but is \"vertex\"")]
    [InlineData("solid a\nfacet normal 0 0 1\nouter loop\n", "must be \"vertex\"")]
    [InlineData("solid a\nhello\n", ":2: must be \"facet\" or \"endsolid\", but is \"hello\"")]
    public void WhatIsWrongIsNamedWithItsLine(string text, string part)
    {
        using var directory = new TempDirectory();
        string file = directory.Write("bad.stl", text);
        Imported.Refused(file, file, part);
    }

    [Fact]
    public void ABinaryFileMustHaveItsTriangles()
    {
        using var directory = new TempDirectory();
        string file = directory.File("bad.stl");
        byte[] good = Binary("title", [.. Faces.Select(i => Corners[i])]);
        File.WriteAllBytes(file, good[..^1]);
        Imported.Refused(file, "4 triangles need 284 bytes, but it has 283");
        File.WriteAllBytes(file, [.. good[..80], 255, 255, 255, 255, .. good[84..]]);
        Imported.Refused(file, "4294967295 triangles need 214748364834 bytes");
        File.WriteAllBytes(file, good[..84]);
        Imported.Refused(file, "4 triangles need");
        File.WriteAllBytes(file, [.. good[..80], 0, 0, 0, 0]);
        Imported.Refused(file, "there are no triangles");
        File.WriteAllBytes(file, Binary("title", [Corners[0], Corners[1], new(0, float.NaN, 0)]));
        Imported.Refused(file, "triangle 0: a coordinate is not a finite number");
    }

    /// <summary>A binary file without a fault.</summary>
    internal static byte[] Good() => Binary("made by hand", [.. Faces.Select(i => Corners[i])]);

    private static string Solid(string name)
    {
        var text = new StringBuilder($"solid {name}\n");
        for (int i = 0; i < Faces.Length; i += 3)
        {
            text.Append(" facet normal 0 0 0\n  outer loop\n");
            for (int k = i; k < i + 3; k++)
                text.Append(FormattableString.Invariant($"   vertex {Corners[Faces[k]].X} {Corners[Faces[k]].Y:E6}"))
                    .Append(FormattableString.Invariant($" {Corners[Faces[k]].Z}\n"));
            text.Append("  endloop\n endfacet\n");
        }

        return text.Append($"endsolid {name}\n").ToString();
    }

    private static byte[] Binary(string title, Vector3[] corners)
    {
        using var bytes = new MemoryStream();
        using var writer = new BinaryWriter(bytes);
        writer.Write(Encoding.ASCII.GetBytes(title.PadRight(80)));
        writer.Write(corners.Length / 3);
        for (int i = 0; i < corners.Length; i++)
        {
            if (i % 3 == 0) writer.Write(new byte[12]);
            writer.Write(corners[i].X);
            writer.Write(corners[i].Y);
            writer.Write(corners[i].Z);
            if (i % 3 == 2) writer.Write((ushort)0);
        }

        writer.Flush();
        return bytes.ToArray();
    }
}
