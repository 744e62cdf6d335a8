using System.Text;

namespace Gjk.Demo.Tests.Import;

/// <summary>What stands beside the plain numbers: compressed ones, hidden nodes, other files.</summary>
public sealed partial class GlbTests
{
    /// <summary>Compressed as well as plain, the plain numbers are read; compressed only, the part is listed.</summary>
    [Fact]
    public void APrimitiveMayBePlainBesideItsCompression()
    {
        const string draco = "\"extensions\":{\"KHR_draco_mesh_compression\":{}}";
        string plain = Mesh.Replace("\"indices\":1", "\"indices\":1," + draco);
        Imported.AssertBounds(
            Of($$"""{{{plain}},{{OneNode}},{{Data}}}""")["node 0"], new(0), new(1, 2, 3));
        const string none = "\"primitives\":[{\"attributes\":{\"POSITION\":2}," + draco + "},";
        string two = plain.Replace("\"primitives\":[", none);
        string data = Data.Replace(
            "\"type\":\"SCALAR\"}", "\"type\":\"SCALAR\"},{\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"}");
        Imported imported = Of(
            $$"""{{{two}},"nodes":[{"mesh":0},{"mesh":0}],{{data}}}""",
            "primitives[0]: it is compressed with KHR_draco_mesh_compression, which is not read; and 1 more");
        Assert.Equal(["node 0", "node 1"], imported.Names);
    }

    /// <summary>An invisible node hides what is below it.</summary>
    [Fact]
    public void InvisibleNodesAreLeftOut()
    {
        const string hidden = "\"extensions\":{\"KHR_node_visibility\":{\"visible\":false}}";
        Imported imported = Of(
            $$"""
            {"extensionsRequired":["KHR_node_visibility"],{{Mesh}},{{Data}},"nodes":[
              {"mesh":0,"children":[1,2]},{"mesh":0,{{hidden}},"children":[3]},
              {"mesh":0,{{hidden.Replace("false", "true")}}},{"mesh":0},{"mesh":0,{{hidden}}}]}
            """,
            "nodes[1]: warning: it is not visible, so it is left out with all below it; and 1 more");
        Assert.Equal(["node 0", "node 2"], imported.Names);
    }

    /// <summary>JSON with its numbers in files beside it, or in itself.</summary>
    [Fact]
    public void AGltfFileNamesTheFilesBesideIt()
    {
        using var directory = new TempDirectory();
        Directory.CreateDirectory(directory.File("data"));
        File.WriteAllBytes(directory.File("data/a b.bin"), Plain);
        string json = $$"""{{{Mesh}},{{OneNode}},{{Data}}}""";
        string Text(string uri) => json.Replace("\"byteLength\":72", $"\"byteLength\":72,\"uri\":\"{uri}\"");
        Imported imported = Imported.Quietly(directory.Write("model.gltf", "\uFEFF" + Text("data/a%20b.bin")));
        Imported.AssertBounds(imported["node 0"], new(0), new(1, 2, 3));
        string inside = Text("data:application/octet-stream;base64," + Convert.ToBase64String(Plain));
        Imported.AssertBounds(Imported.Quietly(directory.Write("model.gltf", inside))["node 0"], new(0), new(1, 2, 3));
        foreach ((string uri, string part) in new[]
        {
            ("none.bin", "none.bin: cannot be read: there is no such file"),
            ("../data/a%20b.bin", "\"../data/a b.bin\" is not the name of a file beside it"),
            ("%2Fetc%2Fpasswd", "is not the name of a file beside it"),
            ("https://example.org/a.bin", "is not the name of a file beside it"),
        })
            Imported.Refused(directory.Write("model.gltf", Text(uri)), part);
        File.WriteAllBytes(directory.File("data/a b.bin"), Plain[..^1]);
        Imported.Refused(
            directory.Write("model.gltf", Text("data/a%20b.bin")), "buffers[0]: must have 72 bytes, but has 71");
        File.WriteAllText(directory.File("model.gltf"), Text("x"), Encoding.Unicode);
        Imported.Refused(directory.File("model.gltf"), "it is UTF-16 text");
        Imported.Refused(directory.Write("model.gltf", "{ \"nodes\": "), "its JSON is not valid at line 1");
    }
}
