using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text;
using Gjk.Core;

namespace PartClearance;

/// <summary>Writes parts to try the sample with: boxes, prisms and rocks of some 4 cm, in millimetres, one in each cell
/// of a grid of 4.4 cm. Even parts are OBJ files and odd ones binary STL files.</summary>
internal static class PartMaker
{
    private const int CellsPerSide = 8;
    private const float CellSize = 44;

    /// <summary>Bytes of the title of a binary STL file.</summary>
    private const int StlTitle = 80;

    public static void Write(string folder, int count)
    {
        Create(folder);
        var random = new Random(1);
        for (int i = 0; i < count; i++)
        {
            var cell = new Vector3(i % CellsPerSide, i / CellsPerSide % CellsPerSide, i / CellsPerSide / CellsPerSide);
            Quaternion turn = Quaternion.CreateFromYawPitchRoll(Angle(random), Angle(random), Angle(random));
            Vector3[] points = [.. Shape(i, random).Select(p => Vector3.Transform(p, turn) + CellSize * cell)];
            string name = $"part{i:D3}";
            if (i % 2 == 0) WriteObj(Path.Combine(folder, name + ".obj"), name, new ConvexHull(points));
            else WriteStl(Path.Combine(folder, name + ".stl"), new ConvexHull(points));
        }
    }

    /// <summary>Writes ten links of a chain, 10,000 triangles each, in millimetres: half a millimetre is between
    /// neighbours, and their hulls overlap.</summary>
    public static void WriteChain(string folder)
    {
        const int Links = 10, Around = 100, Across = 50;
        const float Radius = 30, Tube = 4, Gap = 0.5f;
        Create(folder);
        for (int link = 0; link < Links; link++)
        {
            var points = new Vector3[Around * Across];
            var corners = new List<int>();
            for (int i = 0; i < points.Length; i++)
            {
                (float sin, float cos) = MathF.SinCos(MathF.Tau * (i / Across) / Around);
                (float up, float along) = MathF.SinCos(MathF.Tau * (i % Across) / Across);
                Vector3 p = new((Radius + Tube * along) * cos, Tube * up, (Radius + Tube * along) * sin);
                if (link % 2 == 1) p = new Vector3(p.X, -p.Z, p.Y);
                points[i] = p + link * (2 * (Radius - Tube) - Gap) * Vector3.UnitX;
                int right = i % Across == Across - 1 ? i + 1 - Across : i + 1;
                int next = (i + Across) % points.Length, both = (right + Across) % points.Length;
                corners.AddRange([i, right, next, right, both, next]);
            }

            string name = $"link{link}";
            WriteObj(Path.Combine(folder, name + ".obj"), name, points, corners);
        }
    }

    private static void Create(string folder)
    {
        if (Directory.Exists(folder) && Directory.EnumerateFileSystemEntries(folder).Any())
            throw new InvalidDataException($"{folder}: the folder is not empty");
        Directory.CreateDirectory(folder);
    }

    /// <summary>Two polygons of 3, 4 or more corners, one above the other, or points on a ball.</summary>
    private static Vector3[] Shape(int part, Random random)
    {
        if (part % 3 == 0)
        {
            return [.. Enumerable.Range(0, 40).Select(_ => 23 * Vector3.Normalize(
                new Vector3(random.NextSingle(), random.NextSingle(), random.NextSingle()) - new Vector3(0.5f)))];
        }

        int sides = 3 + random.Next(10);
        float radius = 14 + 8 * random.NextSingle(), height = 8 + 12 * random.NextSingle();
        return [.. Enumerable.Range(0, 2 * sides).Select(k => new Vector3(
            radius * MathF.Cos(MathF.Tau * k / sides), k < sides ? height : -height,
            radius * MathF.Sin(MathF.Tau * k / sides)))];
    }

    private static float Angle(Random random) => MathF.Tau * random.NextSingle();

    private static void WriteObj(string file, string name, ConvexHull hull)
    {
        var corners = new List<int>();
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            corners.AddRange([a, b, c]);
        }

        WriteObj(file, name, [.. Enumerable.Range(0, hull.VertexCount).Select(hull.GetVertex)], corners);
    }

    private static void WriteObj(string file, string name, Vector3[] points, List<int> corners)
    {
        var text = new StringBuilder($"o {name}\n");
        foreach (Vector3 v in points) text.Append(FormattableString.Invariant($"v {v.X} {v.Y} {v.Z}\n"));
        for (int i = 0; i < corners.Count; i += 3)
            text.Append(
                FormattableString.Invariant($"f {corners[i] + 1} {corners[i + 1] + 1} {corners[i + 2] + 1}\n"));
        File.WriteAllText(file, text.ToString());
    }

    private static void WriteStl(string file, ConvexHull hull)
    {
        using var writer = new BinaryWriter(File.Create(file));
        writer.Write(new byte[StlTitle]);
        writer.Write(hull.TriangleCount);
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            Vector3 p = hull.GetVertex(a), q = hull.GetVertex(b), r = hull.GetVertex(c);
            Vector3 normal = Vector3.Normalize(Vector3.Cross(q - p, r - p));
            foreach (Vector3 v in new[] { normal, p, q, r })
            {
                writer.Write(v.X);
                writer.Write(v.Y);
                writer.Write(v.Z);
            }

            writer.Write((short)0);
        }
    }
}
