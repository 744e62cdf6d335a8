using System;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text;
using Gjk.Core;

namespace PartClearance;

/// <summary>
/// Writes parts to try the sample with: boxes, prisms and rocks of some 4 cm, in millimetres, one in each cell of a
/// grid of 4.4 cm. Even parts are OBJ files and odd ones binary STL files.
/// </summary>
internal static class PartMaker
{
    private const int CellsPerSide = 8;
    private const float CellSize = 44;

    /// <summary>Bytes of the title of a binary STL file.</summary>
    private const int StlTitle = 80;

    public static void Write(string folder, int count)
    {
        if (Directory.Exists(folder) && Directory.EnumerateFileSystemEntries(folder).Any())
            throw new InvalidDataException($"{folder}: the folder is not empty");
        Directory.CreateDirectory(folder);
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
        var text = new StringBuilder($"o {name}\n");
        for (int i = 0; i < hull.VertexCount; i++)
        {
            Vector3 v = hull.GetVertex(i);
            text.Append(FormattableString.Invariant($"v {v.X} {v.Y} {v.Z}\n"));
        }

        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            text.Append(FormattableString.Invariant($"f {a + 1} {b + 1} {c + 1}\n"));
        }

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
