using Gjk.Import;

namespace Gjk.Demo.Tests.Import;

/// <summary>Polygons become triangles with the same area, winding and outline, whatever their form and plane.</summary>
public sealed class PolygonTests
{
    /// <summary>Share of the sizes. The areas are sums of rounded doubles, and turned corners are floats.</summary>
    private const double Tolerance = 1e-5;

    /// <summary>Corners of outlines in the plane, counter-clockwise.</summary>
    public static TheoryData<string, int> Outlines => new()
    {
        { "star", 7 }, { "star", 300 }, { "comb", 3 }, { "comb", 60 }, { "spiral", 24 }, { "spiral", 250 },
        { "steps", 40 }, { "frame", 0 }, { "flat corners", 0 }, { "pinch", 0 }, { "two holes", 0 },
    };

    [Theory]
    [MemberData(nameof(Outlines))]
    public void TrianglesFillTheOutlineOnce(string kind, int size)
    {
        for (int seed = 0; seed < 12; seed++)
        {
            Vector2[] outline = Outline(kind, size, seed);
            Vector3[] flat = Array.ConvertAll(outline, p => new Vector3(p, 0.25f));
            AssertFilled(flat, $"{kind} {size}, seed {seed}", expectExact: true);
            Array.Reverse(flat);
            AssertFilled(flat, $"{kind} {size} reversed, seed {seed}", expectExact: true);

            // Along other axes the numbers are the same.
            AssertFilled(Array.ConvertAll(flat, p => new Vector3(p.Z, p.X, p.Y)), $"{kind} x, seed {seed}", true);
            AssertFilled(Array.ConvertAll(flat, p => new Vector3(p.Y, p.Z, p.X)), $"{kind} y, seed {seed}", true);
        }
    }

    [Theory]
    [InlineData("star", 300)]
    [InlineData("comb", 60)]
    [InlineData("spiral", 100)]
    public void AnyPlaneIsAsGood(string kind, int size)
    {
        var random = new Rng((ulong)size);
        for (int seed = 0; seed < 20; seed++)
        {
            Quaternion turn = Quaternion.Normalize(new Quaternion(
                Next(random), Next(random), Next(random), Next(random)));
            Vector3[] points = Array.ConvertAll(
                Outline(kind, size, seed), p => Vector3.Transform(new Vector3(p, 1), turn));
            AssertFilled(points, $"{kind} {size} turned, seed {seed}", expectExact: false);
        }
    }

    [Theory]
    [InlineData("comb", 2500)]
    [InlineData("star", 10_000)]
    [InlineData("spiral", 5000)]
    public void TenThousandCornersTakeNoTime(string kind, int size)
    {
        Vector3[] points = Array.ConvertAll(Outline(kind, size, 1), p => new Vector3(p, 0));
        Assert.InRange(points.Length, 9_000, 11_000);
        long before = System.Diagnostics.Stopwatch.GetTimestamp();
        Assert.Equal(PolygonFaults.None, Cut(points, out List<int> triangles));
        Assert.Equal(points.Length - 2, triangles.Count / 3);
        Assert.InRange(System.Diagnostics.Stopwatch.GetElapsedTime(before).TotalSeconds, 0, 5);
    }

    [Fact]
    public void OutlinesThatCrossAreToldAndKeepTheirArea()
    {
        Vector2[][] outlines =
        [
            [new(0, 0), new(4, 4), new(4, 0), new(0, 3)],
            [new(0, 0), new(2, 2), new(2, 0), new(0, 2)],
            [new(0, 0), new(4, 0), new(4, 3), new(1, 3), new(1, -1), new(0, -1)],
            [.. Enumerable.Range(0, 5).Select(i => Around(i * 2 / 5.0, 1))],

            // A band that turns by more than once, in which every piece turns left.
            [
                .. Enumerable.Range(0, 15).Select(i => Around(i / 12.7, 2)),
                .. Enumerable.Range(0, 15).Select(i => Around((14 - i) / 12.7, 1)),
            ],
        ];
        foreach (Vector2[] outline in outlines)
        {
            Vector3[] points = Array.ConvertAll(outline, p => new Vector3(p, 0));
            Assert.Equal(PolygonFaults.NotSimple, Cut(points, out List<int> triangles) & PolygonFaults.NotSimple);
            Assert.Equal(Area(points).Z, Sum(points, triangles).Z, Tolerance);
        }

        var random = new Rng(5);
        Vector3[] many = [.. Enumerable.Range(0, 3000).Select(_ => new Vector3(Next(random), Next(random), 0))];
        Assert.Equal(PolygonFaults.NotSimple, Cut(many, out List<int> all));
        Assert.Equal(Area(many).Z, Sum(many, all).Z, 1e-3);
    }

    /// <summary>Repetitions and spikes have no area; a line has none either.</summary>
    [Fact]
    public void WhatHasNoAreaDoesNoHarm()
    {
        Vector3[] square = [new(0, 0, 0), new(1, 0, 0), new(1, 1, 0), new(0, 1, 0), new(2, 1, 0)];
        int[][] polygons =
        [
            [0, 0, 1, 2, 3], [0, 1, 1, 1, 2, 3, 3, 0], [0, 1, 2, 4, 2, 3], [4, 2, 3, 0, 1, 2], [2, 3, 0, 1, 2, 4],
        ];
        foreach (int[] polygon in polygons)
        {
            var triangles = new List<int>();
            Assert.Equal(PolygonFaults.None, new PolygonTriangles().Append(square, polygon, triangles));
            Assert.Equal(2, Sum(square, triangles).Z);
            Assert.Equal(6, triangles.Count);
        }

        foreach (int[] thin in (int[][])[[], [0, 1], [0, 1, 0, 1], [2, 2, 2, 2, 2]])
        {
            var triangles = new List<int>();
            Assert.Equal(PolygonFaults.Thin, new PolygonTriangles().Append(square, thin, triangles));
            Assert.Empty(triangles);
        }

        Vector3[] line = [new(0, 0, 0), new(1, 1, 1), new(3, 3, 3), new(2, 2, 2), new(0.5f, 0.5f, 0.5f)];
        Assert.Equal(PolygonFaults.None, Cut(line, out List<int> flat));
        Assert.Equal(0, Sum(line, flat).Length);
    }

    /// <summary>Pins the two tolerances: four times more or less would turn one of these.</summary>
    [Theory]
    [InlineData(0, 1.5e-4f, false)]
    [InlineData(0, 3e-3f, true)]
    [InlineData(0, 8e-4f, true)]
    [InlineData(1e4f, 0.015f, false)]
    [InlineData(1e4f, 0.08f, true)]
    public void CornersOutOfThePlaneAreTold(float offset, float lift, bool isTold)
    {
        Vector3[] square = [new(0, 0, offset), new(1, 0, offset), new(1, 1, offset + lift), new(0, 1, offset)];
        PolygonFaults faults = Cut(square, out List<int> triangles);
        Assert.Equal(isTold ? PolygonFaults.NotFlat : PolygonFaults.None, faults);
        Assert.Equal(6, triangles.Count);
    }

    private static void AssertFilled(Vector3[] points, string what, bool expectExact)
    {
        PolygonFaults faults = Cut(points, out List<int> triangles);
        Assert.True(faults == PolygonFaults.None, $"{what}: {faults}");
        Double3 area = Area(points), sum = Sum(points, triangles);
        Assert.True((sum - area).Length <= Tolerance * area.Length, $"{what}: {sum} instead of {area}");
        double plain = 0;
        for (int i = 0; i < triangles.Count; i += 3)
        {
            Double3 a = points[triangles[i]], b = points[triangles[i + 1]], c = points[triangles[i + 2]];
            Double3 own = Double3.Cross(b - a, c - a);
            plain += own.Length;
            if (expectExact) Assert.True(Double3.Dot(own, area) > 0, $"{what}: triangle {i / 3} turns over");
        }

        // Triangles that all turn the same way, and have the outline's area, fill it and nothing else.
        Assert.True(plain <= area.Length * (1 + Tolerance), $"{what}: {plain} instead of {area.Length}");
        AssertOutline(points, triangles, what);
    }

    /// <summary>Every edge inside is used in both directions, and what is left over is the outline.</summary>
    private static void AssertOutline(Vector3[] points, List<int> triangles, string what)
    {
        var open = new Dictionary<(Vector3, Vector3), int>();
        void Add(int a, int b, int count)
        {
            (Vector3 p, Vector3 q) = (points[a], points[b]);
            bool isForward = (p.X, p.Y, p.Z).CompareTo((q.X, q.Y, q.Z)) < 0;
            (Vector3, Vector3) key = isForward ? (p, q) : (q, p);
            open[key] = open.GetValueOrDefault(key) + (isForward ? count : -count);
        }

        for (int i = 0; i < triangles.Count; i++)
            Add(triangles[i], triangles[i % 3 == 2 ? i - 2 : i + 1], 1);
        for (int i = 0; i < points.Length; i++) Add(i, (i + 1) % points.Length, -1);
        Assert.True(open.Values.All(count => count == 0), $"{what}: the triangles have another outline");
    }

    private static PolygonFaults Cut(Vector3[] points, out List<int> triangles)
    {
        triangles = [];
        return new PolygonTriangles().Append(points, Enumerable.Range(0, points.Length).ToArray(), triangles);
    }

    private static Double3 Area(Vector3[] points)
    {
        Double3 sum = default;
        for (int i = 1; i + 1 < points.Length; i++)
            sum += Double3.Cross((Double3)points[i] - points[0], (Double3)points[i + 1] - points[0]);
        return sum;
    }

    private static Double3 Sum(Vector3[] points, List<int> triangles)
    {
        Double3 sum = default;
        for (int i = 0; i < triangles.Count; i += 3)
        {
            Double3 a = points[triangles[i]];
            sum += Double3.Cross(points[triangles[i + 1]] - a, points[triangles[i + 2]] - a);
        }

        return sum;
    }

    private static Vector2[] Outline(string kind, int size, int seed)
    {
        var random = new Rng((ulong)seed);
        var points = new List<Vector2>();
        switch (kind)
        {
            case "star":
                for (int i = 0; i < size; i++)
                    points.Add(Around((i + 0.5 * random.Unit()) / size, 1 + 9 * random.Unit()));
                break;
            case "comb":
                points.AddRange([new(4 * size, 0), new(4 * size, 3), new(0, 3), new(0, 0)]);
                for (int i = 0; i < size; i++)
                {
                    float height = 1 + random.Below(2);
                    points.AddRange(
                        [new(4 * i + 1, 0), new(4 * i + 1, height), new(4 * i + 2, height), new(4 * i + 2, 0)]);
                }

                break;
            case "spiral":
                for (int i = 0; i < size; i++) points.Add(Around(i / 24.0, 1 + i / 24.0));
                for (int i = size - 1; i >= 0; i--)
                    points.Add(Around(i / 24.0, 1.3 + 0.3 * random.Unit() + i / 24.0));
                points.Reverse();
                break;
            case "steps":
                points.Add(new(size, 0));
                points.Add(new(0, 0));
                for (int i = 0; i < size; i++) points.AddRange([new(i, i + 1), new(i + 1, i + 1)]);
                points.Reverse();
                break;
            case "frame":
                points.AddRange([new(0, 0), new(4, 0), new(4, 4), new(0, 4), new(0, 0)]);
                points.AddRange([new(1, 1), new(1, 3), new(3, 3), new(3, 1), new(1, 1)]);
                break;
            case "two holes":
                points.AddRange([new(0, 0), new(9, 0), new(9, 4), new(0, 4), new(0, 0)]);
                points.AddRange([new(1, 1), new(1, 3), new(3, 3), new(3, 1)]);
                points.AddRange([new(5, 1), new(5, 3), new(7, 3), new(7, 1), new(5, 1), new(3, 1), new(1, 1)]);
                break;
            case "flat corners":
                points.AddRange([new(0, 0), new(1, 0), new(2, 0), new(3, 0), new(3, 1), new(3, 2), new(2, 2)]);
                points.AddRange([new(2, 1), new(1, 1), new(1, 2), new(0, 2), new(0, 1)]);
                break;
            case "pinch":
                points.AddRange([new(0, 0), new(2, 0), new(2, 2), new(4, 2), new(4, 4), new(2, 4), new(2, 2)]);
                points.Add(new(0, 2));
                break;
        }

        int first = random.Below(points.Count);
        return [.. points.Skip(first), .. points.Take(first)];
    }

    private static Vector2 Around(double turns, double radius) =>
        new((float)(radius * Math.Cos(2 * Math.PI * turns)), (float)(radius * Math.Sin(2 * Math.PI * turns)));

    private static float Next(Rng random) => random.Float(-1, 1);
}
