using System.Buffers.Binary;
using System.Text;

namespace Gjk.Import;

/// <summary>Reads STL, text or binary (3D Systems, "StereoLithography Interface Specification", 1989). A binary file
/// may begin with the word "solid", too, so its length decides.</summary>
internal static class StlReader
{
    /// <summary>Bytes: a title of 80, then the number of triangles.</summary>
    private const int HeaderBytes = 84;

    /// <summary>Bytes: the normal, three corners, and a count that nobody uses.</summary>
    private const int TriangleBytes = 50;

    private const int TrianglesPerLook = 4096;

    /// <summary>A binary file has fewer triangles. Four letters of a text in the place of the count say more.</summary>
    private const long MostTriangles = 1 << 24;

    public static List<ImportedMesh> Read(string file, byte[] bytes, ImportLog log, CancellationToken cancel)
    {
        bool hasHeader = bytes.Length >= HeaderBytes;
        long count = hasHeader ? BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(HeaderBytes - 4)) : 0;
        long length = HeaderBytes + count * TriangleBytes, behind = bytes.Length - length;
        if (!hasHeader || behind != 0) MeshText.CheckEncoding(file, bytes);
        if (StartsWithSolid(bytes) && (!hasHeader || count >= MostTriangles)) return Text(file, bytes, log, cancel);
        if (!hasHeader)
            throw new ImportException(
                $"{file}: not an STL file: it neither begins with \"solid\" nor has the {HeaderBytes} bytes of a "
                + "header");
        if (behind < 0 || (count == 0 && behind > 0))
            throw new ImportException(
                $"{file}: not an STL file: {count} triangles need {length} bytes, but it has {bytes.Length}");
        if (count == 0) throw new ImportException($"{file}: there are no triangles in it");
        if (behind > 0) log.Warn(file, $"{behind} bytes behind its {count} triangles are passed over");
        return [Binary(file, bytes, (int)count, cancel)];
    }

    private static bool StartsWithSolid(ReadOnlySpan<byte> bytes)
    {
        if (bytes.StartsWith("\uFEFF"u8)) bytes = bytes["\uFEFF"u8.Length..];
        int start = 0;
        while (start < bytes.Length && " \t\r\n"u8.IndexOf(bytes[start]) >= 0) start++;
        string text = Encoding.ASCII.GetString(bytes[start..Math.Min(start + 5, bytes.Length)]);
        return text.Equals("solid", StringComparison.OrdinalIgnoreCase);
    }

    private static ImportedMesh Binary(string file, byte[] bytes, int count, CancellationToken cancel)
    {
        var corners = new Vector3[3 * count];
        for (int i = 0; i < count; i++)
        {
            if (i % TrianglesPerLook == 0) cancel.ThrowIfCancellationRequested();
            ReadOnlySpan<byte> triangle = bytes.AsSpan(HeaderBytes + i * TriangleBytes, TriangleBytes);
            for (int k = 0; k < 3; k++)
            {
                ReadOnlySpan<byte> corner = triangle[(12 + 12 * k)..];
                var vertex = new Vector3(
                    LittleEndian.Single(corner),
                    LittleEndian.Single(corner[4..]),
                    LittleEndian.Single(corner[8..]));
                int number = i;
                corners[3 * i + k] = MeshText.Checked(vertex, () => NotFinite(file, number));
            }
        }

        return Part(System.IO.Path.GetFileNameWithoutExtension(file), corners);
    }

    private static ImportException NotFinite(string file, int triangle) =>
        new($"{file}: triangle {triangle}: a coordinate is not a finite number");

    private static List<ImportedMesh> Text(string file, byte[] bytes, ImportLog log, CancellationToken cancel)
    {
        var text = new MeshText(file, bytes);
        var parts = new List<ImportedMesh>();
        ImportException? isEmpty = null;
        while (text.NextLine())
        {
            if (!Is(text, "solid")) throw Expected(text, "\"solid\"");
            string title = text.Text.Trim()["solid".Length..].Trim();
            string name = title.Length > 0 ? title : System.IO.Path.GetFileNameWithoutExtension(file);
            var corners = new List<Vector3>();
            while (NextOf(text, "facet", "endsolid"))
            {
                if (corners.Count % TrianglesPerLook == 0) cancel.ThrowIfCancellationRequested();
                Triangle(text, corners);
            }

            if (corners.Count > 0)
            {
                parts.Add(Part(name, corners));
                continue;
            }

            isEmpty ??= text.Refuse($"the solid \"{name}\" has no triangles");
            log.Warn($"{file}:{text.Line}", $"the solid \"{name}\" has no triangles, and is left out", "empty solid");
        }

        return parts.Count > 0 ? parts : throw isEmpty ?? Expected(text, "\"solid\"");
    }

    private static void Triangle(MeshText text, List<Vector3> corners)
    {
        Next(text, "outer", 2);
        for (int k = 0; k < 3; k++)
        {
            Next(text, "vertex", 4);
            if (text.Words.Count != 4)
                throw text.Refuse($"a vertex needs three coordinates, but has {text.Words.Count - 1}");
            corners.Add(new Vector3(
                text.Number(text.Words[1]), text.Number(text.Words[2]), text.Number(text.Words[3])));
        }

        Next(text, "endloop", 1);
        Next(text, "endfacet", 1);
    }

    private static void Next(MeshText text, string word, int mostWords)
    {
        if (!text.NextLine() || !Is(text, word)) throw Expected(text, $"\"{word}\"");
        if (text.Words.Count > mostWords)
            throw text.Refuse($"there is more behind \"{word}\": \"{MeshText.Short(text.Words[mostWords])}\"");
    }

    /// <summary>True if the next line begins with the word, false if it ends the list.</summary>
    private static bool NextOf(MeshText text, string word, string end)
    {
        if (!text.NextLine()) throw text.Refuse($"the file ends before \"{end}\"");
        if (Is(text, end)) return false;
        if (!Is(text, word)) throw Expected(text, $"\"{word}\" or \"{end}\"");

        // The word "normal" and its three numbers, which are not used.
        if (text.Words.Count > 5)
            throw text.Refuse($"there is more behind \"{word}\": \"{MeshText.Short(text.Words[5])}\"");
        return true;
    }

    private static bool Is(MeshText text, string word) =>
        string.Equals(text.Words[0], word, StringComparison.OrdinalIgnoreCase);

    private static ImportException Expected(MeshText text, string what) =>
        text.Refuse($"must be {what}, but is \"{(text.Words.Count > 0 ? MeshText.Short(text.Words[0]) : "the end")}\"");

    private static ImportedMesh Part(string name, IReadOnlyList<Vector3> corners)
    {
        var indices = new int[corners.Count];
        for (int i = 0; i < indices.Length; i++) indices[i] = i;
        return ImportedMesh.Weld(name, corners, indices);
    }
}
