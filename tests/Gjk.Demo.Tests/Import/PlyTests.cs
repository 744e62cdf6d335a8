using System.Text;

namespace Gjk.Demo.Tests.Import;

/// <summary>PLY files: text and both orders of bytes, with properties that are passed over.</summary>
public sealed class PlyTests
{
    private const string Header = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
        + "property float z\n";

    private static readonly Vector3[] Corners = [new(0, 0, 0), new(1, 0, 0), new(0, 2, 0), new(0, 0, 3)];

    private static readonly int[][] Faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

    [Theory]
    [InlineData("ascii", "float", "int")]
    [InlineData("ascii", "double", "uchar")]
    [InlineData("binary_little_endian", "float", "int")]
    [InlineData("binary_little_endian", "double", "ushort")]
    [InlineData("binary_big_endian", "float32", "uint8")]
    [InlineData("binary_big_endian", "float64", "int16")]
    [InlineData("binary_big_endian", "short", "uint32")]
    public void EveryFormatIsRead(string format, string coordinate, string index)
    {
        using var directory = new TempDirectory();
        string file = directory.File("tetra.ply");
        File.WriteAllBytes(file, Write(format, coordinate, index));
        Imported imported = Imported.Quietly(file);
        Assert.Equal(["tetra"], imported.Names);
        Imported.AssertBounds(imported["tetra"], new(0), new(1, 2, 3));
    }

    [Fact]
    public void ACloudOfPointsIsItsHull()
    {
        using var directory = new TempDirectory();
        string text = Header.Replace("vertex 1", "vertex 4") + "end_header\n0 0 0\n1 0 0\n0 2 0\n0 0 3\n";
        Imported imported = Imported.Of(directory.Write("cloud.ply", text));
        Assert.Contains("has no faces", Assert.Single(imported.Lines));
        Imported.AssertBounds(imported["cloud"], new(0), new(1, 2, 3));
    }

    /// <summary>Some programs end the lines of the header with a carriage return alone.</summary>
    [Theory]
    [InlineData("ascii", "\r")]
    [InlineData("ascii", "\r\n")]
    [InlineData("binary_little_endian", "\r")]
    [InlineData("binary_big_endian", "\r\n")]
    public void AnyLineEndIsRead(string format, string end)
    {
        using var directory = new TempDirectory();
        string file = directory.File("tetra.ply");
        byte[] good = Write(format, "float", "int");
        string text = Encoding.Latin1.GetString(good);
        int header = text.IndexOf("end_header\n", StringComparison.Ordinal) + "end_header\n".Length;
        string rows = format == "ascii" ? text[header..].Replace("\n", end) : text[header..];
        File.WriteAllBytes(file, Encoding.Latin1.GetBytes(text[..header].Replace("\n", end) + rows));
        Imported.AssertBounds(Imported.Quietly(file)["tetra"], new(0), new(1, 2, 3));
    }

    /// <summary>The first byte of the data is a line feed, which is no part of the line before it.</summary>
    [Fact]
    public void DataMayBeginWithALineFeed()
    {
        using var directory = new TempDirectory();
        string file = directory.File("points.ply");
        string header = "ply\rformat binary_little_endian 1.0\relement vertex 1\rproperty uchar red\rproperty float x\r"
            + "property float y\rproperty float z\rend_header\r";
        byte[] row = [(byte)'\n', .. new float[] { 1, 2, 3 }.SelectMany(BitConverter.GetBytes)];
        File.WriteAllBytes(file, [.. Encoding.ASCII.GetBytes(header), .. row]);
        Assert.Equal([new(1, 2, 3)], Imported.Quietly(file).Vertices("points"));
    }

    [Theory]
    [InlineData("4 0 0\n5 0 0\n", "a.ply:9: warning: lines behind its last element are passed over; and 1 more")]
    [InlineData("\n", null)]
    public void RowsThatTheHeaderDoesNotCountAreTold(string rest, string? told)
    {
        using var directory = new TempDirectory();
        Imported imported = Imported.Of(directory.Write("a.ply", Header + "end_header\n1 2 3\n" + rest));
        Assert.Equal(told is null ? 0 : 1, imported.Lines.Count);
        if (told is not null) Assert.EndsWith(told, imported.Lines[0]);
    }

    [Fact]
    public void BytesAndThinFacesAreTold()
    {
        using var directory = new TempDirectory();
        string file = directory.File("a.ply");
        File.WriteAllBytes(file, [.. Write("binary_big_endian", "float", "int"), 1, 2]);
        Assert.Contains("2 bytes behind its last element", Assert.Single(Imported.Of(file).Lines));
        string thin = Header + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n";
        Imported imported = Imported.Of(directory.Write("thin.ply", thin));
        Assert.Contains("face 0: warning: a face of fewer than three corners", Assert.Single(imported.Lines));
    }

    [Theory]
    [InlineData("", "must begin with \"ply\"")]
    [InlineData("plyx\n", ":1: not a PLY file")]
    [InlineData("ply\n", "the file ends before \"end_header\"")]
    [InlineData("ply\nend_header\n", "the header has no \"format\"")]
    [InlineData("ply\nformat utf8 1.0\nend_header\n", ":2: unknown format \"utf8\"")]
    [InlineData("ply\nformat ascii 1.0\nend_header\n", "there are no vertices")]
    [InlineData("ply\nformat ascii 1.0\nelement vertex -1\nend_header\n", ":3: -1 is not a number of elements")]
    [InlineData("ply\nformat ascii 1.0\nproperty float x\nend_header\n", ":3: \"property float x\" is not a line")]
    [InlineData("ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n", ":4: unknown type \"half\"")]
    [InlineData("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n", "x, y and z are needed")]
    [InlineData(Header + "end_header\n", "vertex 0: the file ends here")]
    [InlineData(Header + "end_header\n1 2\n", "vertex 0: line 8 has too few numbers")]
    [InlineData(Header + "end_header\n1 2 3 4\n", "vertex 0: line 8 has too many numbers")]
    [InlineData(Header + "end_header\n1 2 x\n", ":8: \"x\" is not a number")]
    [InlineData(Header + "end_header\n1 2 1e39\n", "1e39 is too large")]
    [InlineData(Header + "element face 1\nproperty list float int vertex_indices\n", "must be a whole number")]
    [InlineData(
        Header + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n3 0 0 1\n",
        "a face names vertex 1, but there are 1")]
    [InlineData(
        Header + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n3 0 0 -1\n",
        "face 0: there is no vertex -1")]
    [InlineData(
        Header + "element face 1\nproperty list char int vertex_indices\nend_header\n0 0 0\n-3 0 0 0\n",
        "face 0: the length of a list is not a number")]
    [InlineData(
        Header + "element face 1\nproperty list uint int vertex_indices\nend_header\n0 0 0\n4294967295 0 0\n",
        "face 0: line 11 has too few numbers")]
    public void WhatIsWrongIsNamed(string text, string part)
    {
        using var directory = new TempDirectory();
        string file = directory.Write("bad.ply", text);
        Imported.Refused(file, file, part);
    }

    [Fact]
    public void ABinaryFileThatEndsEarlyIsRefused()
    {
        using var directory = new TempDirectory();
        string file = directory.File("bad.ply");
        byte[] good = Write("binary_big_endian", "float", "int");
        File.WriteAllBytes(file, good[..^1]);
        Imported.Refused(file, "face 3: the file ends here");
        byte[] many = Encoding.Latin1.GetBytes(
            Encoding.Latin1.GetString(good).Replace("vertex 4", "vertex 2000000000", StringComparison.Ordinal));
        File.WriteAllBytes(file, many);
        Imported.Refused(file, "the file ends here");
    }

    /// <summary>A vertex has a colour too, an element that nobody knows comes first, and a face has a list
    /// more.</summary>
    internal static byte[] Write(string format, string coordinate, string index)
    {
        string header = $"ply\nformat {format} 1.0\ncomment by hand\nobj_info none\nelement camera 2\n"
            + "property list uchar float lens\nproperty char kind\nelement vertex 4\n"
            + $"property uchar red\nproperty {coordinate} x\nproperty {coordinate} y\nproperty {coordinate} z\n"
            + "element face 4\nproperty list uchar uchar flags\n"
            + $"property list uint8 {index} vertex_indices\nend_header\n";
        var rows = new List<(string Type, double Value)[]>();
        for (int i = 0; i < 2; i++) rows.Add([("uchar", 2), ("float", 0.5), ("float", 8), ("char", -1)]);
        foreach (Vector3 corner in Corners)
            rows.Add([("uchar", 255), (coordinate, corner.X), (coordinate, corner.Y), (coordinate, corner.Z)]);
        foreach (int[] face in Faces)
            rows.Add([("uchar", 1), ("uchar", 7), ("uchar", 3), .. face.Select(i => (index, (double)i))]);
        if (format == "ascii")
        {
            IEnumerable<string> lines = rows.Select(
                r => string.Join(" ", r.Select(n => FormattableString.Invariant($"{n.Value}"))) + "\n");
            return Encoding.ASCII.GetBytes(header + string.Concat(lines));
        }

        bool isBig = format == "binary_big_endian";
        return [.. Encoding.ASCII.GetBytes(header), .. rows.SelectMany(r => r.SelectMany(n => Bytes(n, isBig)))];
    }

    private static byte[] Bytes((string Type, double Value) number, bool isBig)
    {
        byte[] bytes = number.Type switch
        {
            "char" => [(byte)(sbyte)number.Value],
            "uchar" or "uint8" => [(byte)number.Value],
            "short" or "int16" => BitConverter.GetBytes((short)number.Value),
            "ushort" => BitConverter.GetBytes((ushort)number.Value),
            "int" => BitConverter.GetBytes((int)number.Value),
            "uint32" => BitConverter.GetBytes((uint)number.Value),
            "float" or "float32" => BitConverter.GetBytes((float)number.Value),
            _ => BitConverter.GetBytes(number.Value),
        };
        if (isBig) Array.Reverse(bytes);
        return bytes;
    }
}
