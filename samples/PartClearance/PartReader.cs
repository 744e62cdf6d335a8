using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text;
using System.Threading;

namespace PartClearance;

/// <summary>
/// Reads points from OBJ and STL files. An STL file is one part, and so is each object of an OBJ file. Faces are not
/// read: the hull of the points makes its own.
/// </summary>
internal static class PartReader
{
    /// <summary>Bytes of a binary STL file: a title and the number of triangles; then each triangle.</summary>
    public const int StlHeader = 84, StlTriangle = 50;

    private static readonly char[] Blanks = [' ', '\t'];

    /// <summary>All parts of a folder, in the order of the files' names.</summary>
    /// <exception cref="InvalidDataException">A file is not as its format says; the message says where.</exception>
    public static List<Part> ReadFolder(string folder, Action<int> progress, CancellationToken cancel)
    {
        if (!Directory.Exists(folder)) throw new InvalidDataException($"{folder}: there is no such folder");
        var parts = new List<Part>();
        foreach (string file in Directory.EnumerateFiles(folder).Order(StringComparer.Ordinal))
        {
            cancel.ThrowIfCancellationRequested();
            string ending = Path.GetExtension(file).ToLowerInvariant();
            if (ending == ".obj") parts.AddRange(ReadObj(file));
            if (ending == ".stl") parts.Add(Part.Of(Path.GetFileName(file), ReadStl(file)));
            progress(parts.Count);
        }

        return parts.Count > 0 ? parts : throw new InvalidDataException($"{folder}: it has no .obj or .stl file");
    }

    private static List<Part> ReadObj(string file)
    {
        var parts = new List<Part>();
        var points = new List<Vector3>();
        string name = Path.GetFileName(file);
        int number = 0;
        foreach (string line in File.ReadLines(file))
        {
            number++;
            string[] words = line.Split(Blanks, StringSplitOptions.RemoveEmptyEntries);
            if (words is ["v", ..]) points.Add(ReadPoint(words, $"{file}:{number}"));
            if (words is not ["o", ..]) continue;

            // The points before the first object belong to the file itself.
            if (points.Count > 0) parts.Add(Part.Of(name, points));
            points.Clear();
            name = $"{Path.GetFileName(file)}/{string.Join(' ', words[1..])}";
        }

        if (points.Count > 0 || parts.Count == 0) parts.Add(Part.Of(name, points));
        return parts;
    }

    /// <summary>A binary file may begin with "solid" as a text does, so its length decides.</summary>
    private static List<Vector3> ReadStl(string file)
    {
        byte[] bytes = File.ReadAllBytes(file);
        long count = bytes.Length < StlHeader ? -1 : BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(80));
        if (count >= 0 && bytes.Length == StlHeader + count * StlTriangle) return ReadBinaryStl(bytes, (int)count);
        if (bytes.AsSpan().StartsWith("solid"u8)) return ReadTextStl(file);
        throw new InvalidDataException($"{file}: neither a text STL file nor a binary one of {bytes.Length} bytes");
    }

    private static List<Vector3> ReadBinaryStl(byte[] bytes, int count)
    {
        var points = new List<Vector3>(3 * count);
        for (int i = 0; i < 3 * count; i++)
        {
            // Each triangle begins with its normal, of 12 bytes, and each of its corners has 12 bytes too.
            ReadOnlySpan<byte> corner = bytes.AsSpan(StlHeader + i / 3 * StlTriangle + 12 + i % 3 * 12);
            points.Add(new Vector3(
                BinaryPrimitives.ReadSingleLittleEndian(corner),
                BinaryPrimitives.ReadSingleLittleEndian(corner[4..]),
                BinaryPrimitives.ReadSingleLittleEndian(corner[8..])));
        }

        return points;
    }

    private static List<Vector3> ReadTextStl(string file)
    {
        var points = new List<Vector3>();
        int number = 0;
        foreach (string line in File.ReadLines(file, Encoding.Latin1))
        {
            number++;
            string[] words = line.Split(Blanks, StringSplitOptions.RemoveEmptyEntries);
            if (words is ["vertex", ..]) points.Add(ReadPoint(words, $"{file}:{number}"));
        }

        return points;
    }

    /// <summary>The three numbers after the first word; OBJ files may have a weight or colours behind them.</summary>
    private static Vector3 ReadPoint(string[] words, string where)
    {
        var point = default(Vector3);
        for (int i = 0; i < 3; i++)
        {
            bool isNumber = i + 1 < words.Length
                && float.TryParse(words[i + 1], CultureInfo.InvariantCulture, out float value)
                && float.IsFinite(point[i] = value);
            if (!isNumber)
                throw new InvalidDataException($"{where}: three finite numbers must follow \"{words[0]}\"");
        }

        return point;
    }
}
