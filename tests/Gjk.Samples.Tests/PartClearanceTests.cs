using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Threading;
using System.Threading.Tasks;
using Gjk.Core;
using PartClearance;
using Xunit;

namespace Gjk.Samples.Tests;

public sealed class PartClearanceTests : IDisposable
{
    private const string Sample = "PartClearance", Header = "a,b,status,clearance,ax,ay,az,bx,by,bz";

    private const string TetrahedronStl =
        "solid t\nfacet normal 0 0 0\nouter loop\n vertex 0 0 0\n vertex 1 0 0\n\tvertex 0 1 0\nendloop\nendfacet\n"
        + "facet normal 0 0 0\nouter loop\n vertex 0 0 0\n vertex 1 0 0\n vertex 0 0 1\nendloop\nendfacet\n"
        + "endsolid t\n";

    private readonly string _folder = Directory.CreateTempSubdirectory("gjk-samples-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void MadePartsAreAnsweredAsAllPairsAre()
    {
        const float within = 3;
        string parts = Path.Combine(_folder, "parts"), csv = Path.Combine(_folder, "clearance.csv");
        SampleProcess.Run(Sample, "--make", parts).AssertDone();
        Assert.Equal(500, Directory.GetFiles(parts).Length);
        SampleRun run = SampleProcess.Run(Sample, parts, "--within", "3", "--out", csv);
        run.AssertDone();
        Assert.Equal("", run.Out);
        string[] rows = File.ReadAllLines(csv);
        Assert.Equal($"500 parts, {rows.Length - 1} pairs within 3\n", run.Error);
        Assert.Equal(Header, rows[0]);

        List<Part> all = PartReader.ReadFolder(parts, false, _ => { }, CancellationToken.None);
        ConvexShape[] shapes = [.. all.Select(p => p.Shape.Convex)];
        var expected = new List<string>();
        for (int a = 0; a < shapes.Length; a++)
        {
            for (int b = a + 1; b < shapes.Length; b++)
            {
                DistanceResult r = ConvexQuery.SignedDistance(
                    shapes[a], RigidPose.Identity, shapes[b], RigidPose.Identity);
                if (r.Distance <= within) expected.Add(Row(all[a].Name, all[b].Name, r));
            }
        }

        Assert.Equal(expected, rows[1..]);
        Assert.InRange(rows.Count(l => l.Contains(",Separated,")), 20, 2000);
        Assert.InRange(rows.Count(l => l.Contains(",Overlapping,-")), 5, 1000);
        Assert.Contains(rows, l => l.Contains(".obj,") && l.Contains(".stl,"));
    }

    /// <summary>Links of a chain: what their triangles say, pair by pair, and what their hulls would.</summary>
    [Fact]
    public void LinksOfAChainAreClearAndTheirHullsAreNot()
    {
        string links = Path.Combine(_folder, "links");
        SampleProcess.Run(Sample, "--make", links, "--concave").AssertDone();
        List<Part> all = PartReader.ReadFolder(links, true, _ => { }, CancellationToken.None);
        Assert.Equal(10, all.Count);
        Assert.All(all, part => Assert.Equal((AnyShapeKind.Solid, 10_000), (part.Shape.Kind, part.Shape.PartCount)));
        SampleRun run = SampleProcess.Run(Sample, links, "--within", "1", "--concave");
        run.AssertDone();
        Assert.Equal("10 parts, 9 pairs within 1\n", run.Error);
        for (int i = 0; i + 1 < all.Count; i++)
        {
            string[] row = run.Lines[i + 1].Split(',');
            Assert.Equal([$"link{i}.obj", $"link{i + 1}.obj", "Separated"], row[..3]);
            Assert.InRange(float.Parse(row[3], CultureInfo.InvariantCulture), 0.49f, 0.55f);
        }

        SampleRun hulls = SampleProcess.Run(Sample, links, "--within", "1");
        Assert.Equal(9, hulls.Lines.Count(line => line.Contains(",Overlapping,-")));
    }

    [Fact]
    public void FilesAreReadAsTheirFormatsSay()
    {
        // A cube of two objects in one file, a tetrahedron as text, and the same one as a binary file, moved by 3.
        Write("a.obj", "v 9 9 9 1\no left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 2 3 4 5\no right, far\n"
            + "v 2 0 0\nv 3 0 0\nv 2 1 0\nv 2 0 1 0.5 0.5 0.5\nf 6 7 8 9\n");
        Write("b.STL", TetrahedronStl.Replace("vertex ", "vertex -"));
        File.WriteAllBytes(Path.Combine(_folder, "c.stl"), BinaryStl(new(0, 0, 3), new(1, 0, 3), new(0, 1, 4)));
        Write("notes.txt", "v x");
        SampleRun run = SampleProcess.Run(Sample, _folder, "--within", "1.5");
        run.AssertDone();
        Assert.Equal([Header, "a.obj/left,\"a.obj/right, far\",Separated,1,1,0,0,2,0,0"], run.Lines[..2]);

        // They share a whole triangle: any point of it is right, if both have the same.
        Assert.StartsWith("a.obj/left,b.STL,Overlapping,0,", run.Lines[2]);
        string[] points = run.Lines[2].Split(',')[4..];
        Assert.Equal(points[..3], points[3..]);
        Assert.Equal(3, run.Lines.Length);
        Assert.Equal("4 parts, 2 pairs within 1.5\n", run.Error);
    }

    [Theory]
    [InlineData("p.obj", "v 0 0 0\nv 1 2\n", "p.obj:2: a vertex needs three coordinates")]
    [InlineData("p.obj", "o a\nv 1 2 1e99\n", "p.obj:2: 1e99 is too large")]
    [InlineData("p.obj", "o a\nf 1 2 3\n", "p.obj:2: there is no vertex 1")]
    [InlineData("p.stl", "solid\nvertex 1 2 x\n", "p.stl:2: must be \"facet\"")]
    [InlineData("p.stl", "solid\nendsolid\n", "p.stl:2: the solid")]
    [InlineData("p.stl", "", "p.stl: not an STL file")]
    [InlineData("p.txt", "v 1 2 3\n", "it has no ")]
    public void BadFilesAreRefusedWithTheirPlace(string name, string text, string reason)
    {
        Write(name, text);
        string csv = Path.Combine(_folder, "out.csv");
        SampleProcess.Run(Sample, _folder, "--out", csv).AssertRefused(reason);
        Assert.Equal(name, Path.GetFileName(Assert.Single(Directory.GetFiles(_folder))));
    }

    [Fact]
    public void ATruncatedBinaryFileAndANumberThatIsNoneAreRefused()
    {
        byte[] good = BinaryStl(Vector3.Zero, Vector3.UnitX, Vector3.UnitY);
        File.WriteAllBytes(Path.Combine(_folder, "p.stl"), good[..^1]);
        SampleProcess.Run(Sample, _folder).AssertRefused("134 bytes, but it has 133");
        BitConverter.TryWriteBytes(good.AsSpan(96), float.NaN);
        File.WriteAllBytes(Path.Combine(_folder, "p.stl"), good);
        SampleProcess.Run(Sample, _folder).AssertRefused("p.stl: ");
    }

    [Theory]
    [InlineData("FOLDER")]
    [InlineData("--within x: must be a number, at least 0", "FOLDER", "--within", "x")]
    [InlineData("--within -1: must be a number, at least 0", "FOLDER", "--within", "-1")]
    [InlineData("--within NaN: must be a number, at least 0", "FOLDER", "--within", "NaN")]
    [InlineData("--bogus: there is no such option", "--bogus", "FOLDER")]
    [InlineData("nowhere: there is no such folder", "FOLDER/nowhere")]
    [InlineData("out.csv", "FOLDER", "--out", "FOLDER/nowhere/out.csv")]
    [InlineData("the folder is not empty", "--make", "FOLDER")]
    public void WrongArgumentsAreRefused(string reason, params string[] args)
    {
        Write("p.stl", TetrahedronStl);
        SampleProcess.Run(Sample, [.. args.Select(a => a.Replace("FOLDER", _folder))]).AssertRefused(reason);
        Assert.Single(Directory.GetFiles(_folder));
    }

    [Fact]
    public async Task AnInterruptEndsTheWorkAndLeavesNoFile()
    {
        if (OperatingSystem.IsWindows()) return;

        // The list of the folder waits at a pipe that nobody writes to, so the signal comes in the midst of the work.
        string[] names = ["a.obj", "b.obj"];
        foreach (string name in names) Process.Start("mkfifo", [Path.Combine(_folder, name)]).WaitForExit();
        string csv = Path.Combine(_folder, "out.csv");
        using Process sample = SampleProcess.Start(Sample, _folder, "--out", csv);
        Task<FileStream> opening = Task.Run(() =>
            File.Open(Path.Combine(_folder, "a.obj"), FileMode.Open, FileAccess.Write, FileShare.ReadWrite));
        Assert.True(await Task.WhenAny(opening, Task.Delay(SampleProcess.Patience)) == opening, "Nobody reads.");
        await using (var writer = new StreamWriter(await opening))
        {
            await writer.WriteAsync("v 0 0 0\n");
            await writer.FlushAsync();
            Process.Start("kill", ["-INT", $"{sample.Id}"]).WaitForExit();

            // The handler of the signal runs on a thread of its own.
            await Task.Delay(500);
        }

        Assert.Equal(130, SampleProcess.Finish(sample).ExitCode);
        Assert.Equal(names, Directory.GetFiles(_folder).Select(Path.GetFileName).Order());
    }

    [Fact]
    public void TheReadmeShowsTheOutput()
    {
        string parts = Path.Combine(_folder, "parts");
        SampleProcess.Run(Sample, "--make", parts).AssertDone();
        SampleRun run = SampleProcess.Run(Sample, parts);
        Readme.AssertShows(Sample, [.. run.Lines, run.Error.TrimEnd('\n')], l => l);
    }

    private static string Row(string a, string b, DistanceResult r)
    {
        var numbers = new[] { r.Distance, r.PointA.X, r.PointA.Y, r.PointA.Z, r.PointB.X, r.PointB.Y, r.PointB.Z };
        return $"{a},{b},{r.Status}," + string.Join(',', numbers.Select(
            n => (n == 0 ? 0 : n).ToString(CultureInfo.InvariantCulture)));
    }

    private static byte[] BinaryStl(params Vector3[] corners)
    {
        using var stream = new MemoryStream();
        using var writer = new BinaryWriter(stream);
        writer.Write(new byte[80]);
        writer.Write(1);
        foreach (Vector3 v in corners.Prepend(Vector3.Zero))
            for (int i = 0; i < 3; i++) writer.Write(v[i]);
        writer.Write((short)0);
        return stream.ToArray();
    }

    private void Write(string name, string text) => File.WriteAllText(Path.Combine(_folder, name), text);
}
