using System.Buffers.Binary;
using System.Linq;

namespace Gjk.Import;

/// <summary>Reads a Mesh document: a mesh that was saved as an asset or in a scene. Its vertices are hexadecimal bytes,
/// in a layout that a list of channels describes. The first channel is the position.</summary>
internal sealed class MeshAsset
{
    /// <summary>Formats of a channel that a position may have: float and half.</summary>
    private const int FloatFormat = 0, HalfFormat = 1;

    /// <summary>The low bits of a channel's dimension. The others hold the dimension that the file was made
    /// with.</summary>
    private const int DimensionMask = 0xF;

    private readonly UnityNode _body;

    private MeshAsset(UnityNode body) => _body = body;

    /// <exception cref="UnreadableException">The vertices are not in it as plain numbers.</exception>
    public static ImportedMesh Read(UnityDocument document)
    {
        var mesh = new MeshAsset(document.Body());
        mesh.CheckIsPlain();
        Vector3[] vertices = mesh.Vertices();
        string name = mesh._body["m_Name"]?.Text is { Length: > 0 } given ? given : $"mesh {document.FileId}";
        return ImportedMesh.Weld(name, vertices, mesh.Triangles(vertices.Length));
    }

    private void CheckIsPlain()
    {
        if (_body["m_CompressedMesh"]?["m_Vertices"]?.Whole("m_NumItems", 0) > 0)
            throw new UnreadableException("the mesh is compressed; set Mesh Compression to Off");
        if (_body["m_StreamData"]?["path"]?.Text is { Length: > 0 } path)
            throw new UnreadableException($"its vertices lie in another file, {path}");
    }

    private Vector3[] Vertices()
    {
        UnityNode data = _body["m_VertexData"] ?? throw new UnreadableException("m_VertexData is missing");
        long count = data.Whole("m_VertexCount", 0);
        byte[] bytes = Bytes(data["_typelessdata"]?.Text ?? "", "_typelessdata");
        IReadOnlyList<UnityNode> channels = data["m_Channels"]?.Items ?? [];
        if (count <= 0 || channels.Count == 0) throw new UnreadableException("the mesh has no vertices");
        if (count > SceneBuilder.MostVertices) throw new UnreadableException($"the mesh has {count} vertices");
        UnityNode position = channels[0];
        long format = position.Whole("format", 0), start = position.Whole("offset", 0);
        int size = format switch
        {
            FloatFormat => 4,
            HalfFormat => 2,
            _ => throw new UnreadableException($"its positions have the format {format}, which is not read"),
        };
        if ((position.Whole("dimension", 0) & DimensionMask) != 3)
            throw new UnreadableException("its positions do not have three coordinates");
        long stride = Stride(channels, position.Whole("stream", 0), bytes.Length, count);
        bool fits = start >= 0 && start <= bytes.Length && stride >= start + 3 * size;
        if (!fits || (count - 1) * stride + start + 3 * size > bytes.Length)
            throw new UnreadableException($"{count} vertices do not fit into its {bytes.Length} bytes");
        var vertices = new Vector3[count];
        for (int i = 0; i < vertices.Length; i++)
        {
            ReadOnlySpan<byte> vertex = bytes.AsSpan((int)(i * stride + start), 3 * size);
            vertices[i] = size == 4
                ? new Vector3(
                    LittleEndian.Single(vertex), LittleEndian.Single(vertex[4..]), LittleEndian.Single(vertex[8..]))
                : new Vector3(
                    LittleEndian.Half(vertex), LittleEndian.Half(vertex[2..]), LittleEndian.Half(vertex[4..]));
            if (!float.IsFinite(vertices[i].X) || !float.IsFinite(vertices[i].Y) || !float.IsFinite(vertices[i].Z))
                throw new UnreadableException($"vertex {i} is not finite");
        }

        return vertices;
    }

    /// <summary>Bytes from one vertex to the next. Unity puts positions into the first stream. If it is the only one,
    /// the length of the data gives the stride, whatever formats the other channels have.</summary>
    private static long Stride(IReadOnlyList<UnityNode> channels, long stream, int length, long count)
    {
        if (stream != 0) throw new UnreadableException($"its positions are in stream {stream}, which is not read");
        IEnumerable<UnityNode> used = channels.Where(c => (c.Whole("dimension", 0) & DimensionMask) > 0);
        if (used.All(c => c.Whole("stream", 0) == 0)) return length / count;
        return used.Where(c => c.Whole("stream", 0) == 0).Max(
            c => c.Whole("offset", 0) + (c.Whole("dimension", 0) & DimensionMask) * SizeOf(c.Whole("format", 0)));
    }

    private static long SizeOf(long format) => format switch
    {
        FloatFormat or 10 or 11 => 4,
        HalfFormat or 4 or 5 or 8 or 9 => 2,
        _ => 1,
    };

    /// <summary>Only submeshes of triangles. Another one leaves the surface open, which a warning then says.</summary>
    private List<int> Triangles(int vertices)
    {
        byte[] bytes = Bytes(_body["m_IndexBuffer"]?.Text ?? "", "m_IndexBuffer");
        int size = _body.Whole("m_IndexFormat", 0) == 0 ? 2 : 4;
        var triangles = new List<int>();
        foreach (UnityNode part in _body["m_SubMeshes"]?.Items ?? [])
        {
            if (part.Whole("topology", 0) != 0) continue;
            long first = part.Whole("firstByte", 0), count = part.Whole("indexCount", 0);
            long shift = part.Whole("baseVertex", 0);
            bool fits = first >= 0 && first <= bytes.Length && count >= 0 && count <= bytes.Length;
            if (!fits || first + count * size > bytes.Length)
                throw new UnreadableException("a submesh has more indices than m_IndexBuffer");
            for (long i = 0; i + 2 < count; i += 3)
            {
                for (long k = i; k < i + 3; k++)
                {
                    ReadOnlySpan<byte> at = bytes.AsSpan((int)(first + k * size));
                    long index = shift + (size == 2
                        ? BinaryPrimitives.ReadUInt16LittleEndian(at)
                        : BinaryPrimitives.ReadUInt32LittleEndian(at));
                    if (index < 0 || index >= vertices) throw new UnreadableException($"there is no vertex {index}");
                    triangles.Add((int)index);
                }
            }
        }

        return triangles;
    }

    private static byte[] Bytes(string hex, string field) =>
        LittleEndian.FromHex(hex) ?? throw new UnreadableException($"{field} is not hexadecimal");
}
