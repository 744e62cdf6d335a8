using System.Text;
using Gjk.Import;

namespace Gjk.Demo.Tests.Import;

/// <summary>OBJ files: parts, the ways to name a vertex, and what is refused.</summary>
public sealed class ObjTests
{
    private const string Corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

    private const string Tetrahedron = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

    [Fact]
    public void EachObjectAndGroupIsAPart()
    {
        Imported imported = Of(Corners + "o one\n" + Tetrahedron + "v 9 0 0\no two\ng left\nf 1 3 2\nf 1 2 4\ng right\n"
            + "f 2 3 5\nf 1 5 2\ng left\nf 1 4 3\nf 2 3 4\no empty\ng default\n");
        Assert.Equal(["one", "two/left", "two/right"], imported.Names);
        Imported.AssertBounds(imported["one"], new(0), new(1));
        Imported.AssertBounds(imported["two/left"], new(0), new(1));
        Imported.AssertBounds(imported["two/right"], new(0), new(9, 1, 0));
    }

    [Theory]
    [InlineData(Tetrahedron, AnyShapeKind.Solid, true)]
    [InlineData("f 1 3 2\nf 1 2 4\nf 1 4 3\n", AnyShapeKind.Surface, false)]
    [InlineData("", AnyShapeKind.Convex, true)]
    public void APartIsWhatItsTrianglesAre(string faces, AnyShapeKind kind, bool hasInside)
    {
        using var directory = new TempDirectory();
        ImportedObject part = Importer.Read(directory.Write("a.obj", Corners + faces)).Objects[0];
        AnyShape shape = part.ToAnyShape();
        Assert.Equal(kind, shape.Kind);
        var inside = new Vector3(0.2f);
        Assert.Equal(hasInside, ConcaveQuery.Contains(shape, part.Pose, inside, new ConcaveScratch()));
    }

    [Theory]
    [InlineData("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")]
    [InlineData("f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n")]
    [InlineData("f 1/1 3/2 2/3\nf 1//1 2//1 4//1\nf 1/1/1 4/2/1 3/3/1\nf 2 3/ 4\n")]
    [InlineData("f 1 3 \\\n2\nf 1 \\\r\n 2\\\n 4 # a comment\n\n\tf\t1 4 3\r\nf 2 3 4")]
    public void FacesNameVerticesInManyWays(string faces)
    {
        // If a corner were mistaken, the mesh would not be closed, and a warning would say so.
        using var directory = new TempDirectory();
        string text = "# made by hand\nmtllib a.mtl\n" + Corners + faces;
        Imported imported = Imported.Quietly(directory.Write("a.obj", text));
        Assert.Equal(4, imported.Scene.Objects[0].Shape.Hull!.VertexCount);
    }

    [Fact]
    public void CopiesOfAVertexAreWelded()
    {
        using var directory = new TempDirectory();
        string text = Corners + Corners.Replace("v 0 0 0", "v -0 0 -0.0")
            + "f 1 3 2\nf 5 6 8\nf 1 8 7\nf 6 7 4\nv 5 5 5\n";
        Imported imported = Imported.Quietly(directory.Write("a.obj", text));

        // The last vertex belongs to no face.
        Assert.Equal(
            [new(0, 0, 0), new(0, 1, 0), new(1, 0, 0), new(0, 0, 1)], imported.Vertices("default"));
    }

    [Fact]
    public void NumbersAreRoundedOnceAndMayBeFollowedByAWeight()
    {
        Imported imported = Of("v 1.00000005960464477540 1e-45 -16777217.0000000001 1\nv 0 0 0 0.5 0.5 1\nl 1 2\n");
        Assert.Contains(new Vector3(1.0000001f, float.Epsilon, -16777218f), imported.Vertices("default"));
    }

    /// <summary>What is behind a position is not read, and programs write what they have: as C, C# and others name
    /// it.</summary>
    [Theory]
    [InlineData("nan nan nan")]
    [InlineData("0.5 NaN -nan 1")]
    [InlineData("inf -inf +Infinity")]
    [InlineData("-nan(ind) NAN(0x1) 1e39")]
    [InlineData("nan")]
    public void AColourOrWeightMayBeAnything(string colour)
    {
        Imported imported = Of($"v 1 2 3 {colour}\nv 4 5 6 1 1 1\nl 1 2\n");
        Assert.Equal([new(1, 2, 3), new(4, 5, 6)], imported.Vertices("default"));
    }

    [Fact]
    public void PointsWithoutFacesAreAPartToo()
    {
        using var directory = new TempDirectory();
        Imported imported = Imported.Of(directory.Write("a.obj", "o cloud\n" + Corners + "o more\nv 7 7 7\n"));
        Assert.Equal(["cloud", "more"], imported.Names);
        Assert.Contains("the part \"cloud\" has no faces", Assert.Single(imported.Lines));
    }

    [Theory]
    [InlineData("", "there are no vertices in it")]
    [InlineData("v 1 2\n", ":1: a vertex needs three coordinates, but has 2")]
    [InlineData("v 1 2 three\n", ":1: \"three\" is not a number")]
    [InlineData("v 1 2 1e39\n", ":1: 1e39 is too large for a float")]
    [InlineData("v 1 2 3 abc def\n", ":1: a vertex has 3 numbers, 4, 6 or 7, but this one has 5")]
    [InlineData("v 1 2 3 abc\n", ":1: \"abc\" is not a number")]
    [InlineData("v 2 2 2 v 9 9 9\n", ":1: \"v\" is not a number")]
    [InlineData("v 1 2 3\rv 1 2\r", ":2: a vertex needs three coordinates")]
    [InlineData("v 0 0 0\nf 1/1/1/1 1 1\n", ":2: \"1/1/1/1\" is not a corner")]
    [InlineData("v 0 0 0\nf 1/a 1 1\n", ":2: \"1/a\" is not a corner")]
    [InlineData("\u00FF\u00FEv\0 \0", "it is UTF-16 text; save it as UTF-8")]
    [InlineData("v\0 \0001\0", "it is UTF-16 text")]
    [InlineData("v 1 2 nan\n", ":1: \"nan\" is not a number")]
    [InlineData("v 1 inf 3 1 1 1\n", ":1: \"inf\" is not a number")]
    [InlineData("v 1 2 Infinity nan nan nan\n", ":1: Infinity is too large for a float")]
    [InlineData("v 1 2 3 nano 0 0\n", ":1: \"nano\" is not a number")]
    [InlineData("v 0 0 0\nf 1 1 0\n", ":2: there is no vertex 0: 1 came before")]
    [InlineData("v 0 0 0\nf 1 1 -2\n", ":2: there is no vertex -2")]
    [InlineData("v 0 0 0\nf 1 1 2\nv 0 0 0\n", ":2: there is no vertex 2")]
    [InlineData("v 0 0 0\nf 1 1 1.5\n", ":2: \"1.5\" is not a whole number")]
    [InlineData("v 0 0 0\nf 1 1 99999999999\n", ":2: \"99999999999\" is not a whole number")]
    [InlineData("v 0 0 0\nf 1 1 -2147483648\n", ":2: there is no vertex -2147483648")]
    [InlineData("v 0 0 0\nl 2\n", ":2: there is no vertex 2")]
    [InlineData("v 0 0 0\\\n\ncstype bezier\n", ":3: \"cstype\": curves and surfaces are not read")]
    [InlineData("\u0089PNG\n", "is not a statement of an OBJ file")]
    public void WhatIsWrongIsNamedWithItsLine(string text, string part)
    {
        using var directory = new TempDirectory();
        string file = directory.File("bad.obj");
        File.WriteAllBytes(file, Encoding.Latin1.GetBytes(text));
        Imported.Refused(file, file, part);
    }

    /// <summary>Old Macs end a line with a carriage return alone; a comment ends there, too.</summary>
    [Theory]
    [InlineData("\r")]
    [InlineData("\n")]
    [InlineData("\r\n")]
    public void AnyLineEndIsRead(string end)
    {
        using var directory = new TempDirectory();
        string text = ("# by hand\no one\n" + Corners + "f 1 3 \\\n2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n").Replace("\n", end);
        Imported imported = Imported.Quietly(directory.Write("a.obj", text));
        Assert.Equal(4, imported.Scene.Objects.Single().Shape.Hull!.VertexCount);
        Assert.Equal(12, imported.Result.Meshes[0].Triangles.Count);
    }

    /// <summary>Programs write statements of their own.</summary>
    [Fact]
    public void UnknownStatementsAreCountedAndPassedOver()
    {
        using var directory = new TempDirectory();
        string file = directory.Write("a.obj", "t 0 0\nvw 1 2\n" + Corners + "vt 0 0 # t\nt 1 1\n" + Tetrahedron);
        Imported imported = Imported.Of(file);
        Assert.Equal(
            $"{file}:1: warning: \"t\" is not a statement of an OBJ file, and is passed over; and 2 more",
            Assert.Single(imported.Lines));
        Assert.Equal(0, imported.Result.MissingCount);
        Assert.Equal(3, imported.Result.Problems[0].Count);
        Assert.Single(imported.Names);
    }

    private static Imported Of(string text)
    {
        using var directory = new TempDirectory();
        Imported imported = Imported.Of(directory.Write("a.obj", text));
        Assert.All(imported.Lines, l => Assert.Matches("is not closed|do not fill its outline|no faces", l));
        Assert.Equal(imported.Names.Distinct(), imported.Names);
        return imported;
    }
}
