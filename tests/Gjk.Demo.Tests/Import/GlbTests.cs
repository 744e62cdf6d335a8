using System.Text;

namespace Gjk.Demo.Tests.Import;

/// <summary>GLB files: nodes in their places, accessors of every kind, and what is refused.</summary>
public sealed partial class GlbTests
{
    private static readonly Vector3[] Corners = [new(0, 0, 0), new(1, 0, 0), new(0, 2, 0), new(0, 0, 3)];

    private static readonly ushort[] Faces = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];

    private const string Mesh = """
        "meshes":[{"name":"tetra","primitives":[{"attributes":{"POSITION":0,"NORMAL":7},"indices":1}]}]
        """;

    /// <summary>48 bytes of positions, then 24 of indices.</summary>
    private const string Data = """
        "buffers":[{"byteLength":72}],
        "bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
          {"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]
        """;

    private const string OneNode = "\"nodes\":[{\"mesh\":0}]";

    private static byte[] Plain =>
        [.. Corners.SelectMany(Bytes), .. Faces.SelectMany(BitConverter.GetBytes)];

    [Fact]
    public void NodesPlaceTheirMeshes()
    {
        Imported imported = Of($$"""
            {"asset":{"version":"2.0"},{{Mesh}},{{Data}},"scene":1,"scenes":[{},{"nodes":[0,3]}],
              "nodes":[{"name":"root","translation":[10,0,0],"scale":[2,2,2],"children":[1,2]},
                {"name":"turned","mesh":0,"rotation":[0,0,0.70710678,0.70710678]},
                {"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,-1,0, 0,0,5,1]},
                {"name":"skewed","mesh":0,"matrix":[1,0,0,0, 1,1,0,0, 0,0,1,0, 0,0,0,1]},
                {"name":"not in the scene","mesh":0}]}
            """);
        Assert.Equal(["turned", "node 2", "skewed"], imported.Names);
        Imported.AssertBounds(imported["turned"], new(6, 0, 0), new(10, 2, 6));
        Imported.AssertBounds(imported["node 2"], new(10, 0, 4), new(12, 4, 10));
        Imported.AssertBounds(imported["skewed"], new(0), new(2, 2, 3));
        Assert.Equal(["tetra", "tetra of skewed"], imported.Meshes);
    }

    [Fact]
    public void EachPrimitiveIsAPart()
    {
        Imported imported = Of($$"""
            {{{Data}},{{OneNode}},"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1},
              {"attributes":{"POSITION":0},"mode":0},{"attributes":{"POSITION":0},"mode":5}]}]}
            """, "no faces", "is not closed");
        Assert.Equal(["node 0/0", "node 0/1", "node 0/2"], imported.Names);
        foreach (Gjk.Demo.Scenes.SceneObject one in imported.Scene.Objects)
            Imported.AssertBounds(one, new(0), new(1, 2, 3));
    }

    [Fact]
    public void PositionsMayBeInterleaved()
    {
        byte[] bytes =
        [
            .. Corners.SelectMany(c => (byte[])[.. BitConverter.GetBytes(99f), .. Bytes(c), .. Bytes(new Vector3(8))]),
            .. Faces.SelectMany(BitConverter.GetBytes),
        ];
        Imported imported = Of($$"""
            {{{Mesh}},{{OneNode}},"buffers":[{"byteLength":136}],
             "bufferViews":[{"buffer":0,"byteLength":112,"byteStride":28},
               {"buffer":0,"byteOffset":112,"byteLength":24}],
             "accessors":[{"bufferView":0,"byteOffset":4,"componentType":5126,"count":4,"type":"VEC3"},
               {"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]}
            """, bytes);
        Imported.AssertBounds(imported["node 0"], new(0), new(1, 2, 3));
    }

    /// <summary>Without a view all is 0, and the sparse part sets the others.</summary>
    [Fact]
    public void PositionsMayBeSparse()
    {
        byte[] bytes =
        [
            .. Bytes(Corners[1]), .. Bytes(Corners[2]), .. Bytes(Corners[3]), 1, 2, 3, 0,
            .. Faces.SelectMany(BitConverter.GetBytes),
        ];
        Imported imported = Of($$"""
            {{{Mesh}},{{OneNode}},"buffers":[{"byteLength":64}],
             "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":3},
               {"buffer":0,"byteOffset":40,"byteLength":24}],
             "accessors":[{"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":3,
                 "indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0} } },
               {"bufferView":2,"componentType":5123,"count":12,"type":"SCALAR"}]}
            """, bytes);
        Imported.AssertBounds(imported["node 0"], new(0), new(1, 2, 3));
    }

    [Fact]
    public void PositionsMayBeIntegers()
    {
        byte[] bytes = [0, 0, 0, 0, 127, 0, 0, 0, 0, 127, 0, 0, 0, 0, 129, 0];
        Imported imported = Of($$"""
            {"extensionsRequired":["KHR_mesh_quantization"],{{OneNode}},
             "meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}],"buffers":[{"byteLength":16}],
             "bufferViews":[{"buffer":0,"byteLength":16,"byteStride":4}],
             "accessors":[{"bufferView":0,"componentType":5120,"normalized":true,"count":4,"type":"VEC3"}]}
            """, bytes, "is not closed");
        Imported.AssertBounds(imported["node 0"], new(0, 0, -1), new(1, 1, 0));
    }

    [Fact]
    public void ABufferMayBeWrittenInTheJson()
    {
        string data = Data.Replace(
            "\"byteLength\":72", $"\"byteLength\":72,\"uri\":\"data:;base64,{Convert.ToBase64String(Plain)}\"");
        Imported imported = Of($$"""{{{Mesh}},{{OneNode}},{{data}}}""", Array.Empty<byte>());
        Imported.AssertBounds(imported["node 0"], new(0), new(1, 2, 3));
    }

    [Fact]
    public void WhatMovesWhileItRunsGetsAWarning()
    {
        Imported imported = Of($$"""
            {{{Data}},"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"targets":[{}]}]}],
             "nodes":[{"mesh":0,"skin":0,"translation":[9,9,9]}]}
            """, "nodes[0]: warning: it is a skinned mesh", "morph targets");
        Imported.AssertBounds(imported["node 0"], new(0), new(1, 2, 3));
    }

    [Fact]
    public void IndicesThatMakeNoTriangleAreTold()
    {
        string data = Data.Replace("\"count\":12", "\"count\":11");
        Of($$"""{{{Mesh}},{{OneNode}},{{data}}}""", "its last indices make no whole triangle", "is not closed");
    }

    [Fact]
    public void WhatCannotBeReadIsListed()
    {
        Imported imported = Of($$"""
            {{{Data}},"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1},{"attributes":{} }]}],
             "nodes":[{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{} } }]}
            """, "nodes[0]: the copies of EXT_mesh_gpu_instancing are not read", "primitives[1]: it has no POSITION");
        Assert.Equal(["node 0"], imported.Names);
    }

    /// <summary>The good file with one thing exchanged.</summary>
    [Theory]
    [InlineData("\"count\":4", "\"count\":5", "accessors[0]: 5 elements do not fit into bufferViews[0]")]
    [InlineData("\"count\":4", "\"count\":-4", "accessors[0].count: must be a whole number, at least 0")]
    [InlineData("\"count\":4", "\"count\":2000000000", "accessors[0]: 2000000000 elements, but at most")]
    [InlineData("\"count\":4", "\"count\":3", "there is no vertex 3: it has 3")]
    [InlineData("\"count\":4,", "", "accessors[0]: count is missing")]
    [InlineData("5126", "5130", "unknown component type 5130")]
    [InlineData("\"VEC3\"", "\"VEC2\"", "accessors[0]: must be of type VEC3")]
    [InlineData("\"byteLength\":48", "\"byteLength\":480", "bufferViews[0]: ends at byte 480, but its buffer has 72")]
    [InlineData("\"byteLength\":48", "\"byteLength\":48,\"byteStride\":8", "a byteStride of 8 is less than")]
    [InlineData("\"byteLength\":48", "\"byteLength\":48,\"byteOffset\":30", "ends at byte 78")]
    [InlineData("\"buffer\":0,\"byteLength\"", "\"buffer\":1,\"byteLength\"", "there is no buffer 1: the file has 1")]
    [InlineData("\"POSITION\":0", "\"POSITION\":2", "there is no accessor 2: the file has 2")]
    [InlineData("\"bufferView\":0", "\"bufferView\":2", "there is no buffer view 2")]
    [InlineData("{\"mesh\":0}", "{\"mesh\":1}", "nodes[0]: there is no mesh 1")]
    [InlineData("{\"mesh\":0}", "{\"children\":[1]},{\"children\":[1,2]},{}", "nodes[1]: it is reached twice")]
    [InlineData("{\"mesh\":0}", "{\"mesh\":0,\"children\":[7]}", "nodes[7]: there is no node 7")]
    [InlineData("{\"mesh\":0}", "{\"mesh\":0,\"rotation\":[0,0,0,0]}", "a quaternion of length 0")]
    [InlineData("{\"mesh\":0}", "{\"mesh\":0,\"scale\":[1,1]}", "nodes[0].scale: must be 3 finite numbers")]
    [InlineData("{\"mesh\":0}", "{\"mesh\":0,\"matrix\":\"one\"}", "nodes[0].matrix: must be 16 finite numbers")]
    [InlineData("{\"mesh\":0}", "5", "must be an object")]
    [InlineData("\"buffers\"", "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],\"buffers\"",
        "KHR_draco_mesh_compression is not read")]
    [InlineData("\"byteLength\":48", "\"byteLength\":48,\"extensions\":{\"EXT_meshopt_compression\":{}}",
        "compressed with EXT_meshopt_compression")]
    [InlineData("\"byteLength\":72", "\"byteLength\":72,\"uri\":\"cube.bin\"", "cube.bin: cannot be read: there is no")]
    [InlineData("\"byteLength\":72", "\"byteLength\":72,\"uri\":\"data:;base64,!\"", "is not valid base64")]
    [InlineData("\"nodes\":[", "\"nodes\":{", "its JSON is not valid")]
    [InlineData("\"nodes\":[", "\"scene\":1,\"scenes\":[{}],\"nodes\":[", "there is no scene 1")]
    public void WhatIsWrongIsNamed(string good, string bad, string part)
    {
        using var directory = new TempDirectory();
        string json = $$"""{{{Mesh}},{{OneNode}},{{Data}}}""";
        Assert.Contains(good, json);
        int at = json.IndexOf(good, StringComparison.Ordinal);
        string file = Save(directory, json[..at] + bad + json[(at + good.Length)..], Plain);
        Imported.Refused(file, file, part);
    }

    [Fact]
    public void TheFrameOfTheFileIsChecked()
    {
        using var directory = new TempDirectory();
        string file = Save(directory, $$"""{{{Mesh}},{{OneNode}},{{Data}}}""", Plain);
        byte[] good = File.ReadAllBytes(file);
        Imported.Quietly(file);
        foreach ((byte[] bad, string part) in new[]
        {
            (good[..8], "must begin with \"glTF\""),
            ((byte[])[1, .. good[1..]], "must begin with \"glTF\""),
            ([.. good[..4], 1, .. good[5..]], "glTF version 1 is not known"),
            (good[..^1], $"its header says {good.Length} bytes, but it has {good.Length - 1}"),
            ([.. good[..12], 255, 255, 255, 255, .. good[16..]], "chunk 0 is cut off"),
            ([.. good[..16], 0x42, .. good[17..]], "the first chunk is not JSON"),
        })
        {
            File.WriteAllBytes(file, bad);
            Imported.Refused(file, file, part);
        }
    }

    /// <summary>A file without a fault.</summary>
    internal static byte[] Good() => Framed($$"""{{{Mesh}},{{OneNode}},{{Data}}}""", Plain);

    /// <summary>The same as JSON alone.</summary>
    internal static byte[] GoodText() => Encoding.UTF8.GetBytes($$"""{{{Mesh}},{{OneNode}},{{Data}}}""".Replace(
        "\"byteLength\":72", $"\"byteLength\":72,\"uri\":\"data:;base64,{Convert.ToBase64String(Plain)}\""));

    private static Imported Of(string json, params string[] lines) => Of(json, Plain, lines);

    private static Imported Of(string json, byte[] binary, params string[] lines)
    {
        using var directory = new TempDirectory();
        Imported imported = Imported.Of(Save(directory, json, binary));
        Assert.Equal(lines.Length, imported.Lines.Count);
        foreach (string line in lines) Assert.Contains(imported.Lines, l => l.Contains(line, StringComparison.Ordinal));
        return imported;
    }

    private static string Save(TempDirectory directory, string json, byte[] binary)
    {
        string file = directory.File("model.glb");
        File.WriteAllBytes(file, Framed(json, binary));
        return file;
    }

    private static byte[] Framed(string json, byte[] binary)
    {
        byte[] text = Encoding.UTF8.GetBytes(json);
        text = [.. text, .. Enumerable.Repeat((byte)' ', (4 - text.Length % 4) % 4)];
        byte[] chunks =
        [
            .. BitConverter.GetBytes(text.Length), .. "JSON"u8, .. text,
            .. BitConverter.GetBytes(binary.Length), .. "BIN\0"u8, .. binary,
        ];
        return [.. "glTF"u8, .. BitConverter.GetBytes(2), .. BitConverter.GetBytes(12 + chunks.Length), .. chunks];
    }

    private static byte[] Bytes(Vector3 v) =>
        [.. BitConverter.GetBytes(v.X), .. BitConverter.GetBytes(v.Y), .. BitConverter.GetBytes(v.Z)];
}
