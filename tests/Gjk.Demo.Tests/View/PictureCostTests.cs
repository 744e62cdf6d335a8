using Gjk.Demo.Scenes;
using Gjk.Demo.View;

namespace Gjk.Demo.Tests.View;

/// <summary>The work for a picture, counted, so that a slow or busy machine changes nothing.</summary>
public sealed class PictureCostTests
{
    /// <summary>Boxes in a flat layer, seen from the front: each hides a few neighbours, however many there are. A look
    /// at all other boxes for each box would take sixteen times the work for four times the boxes.</summary>
    [Fact]
    public void FourTimesTheBoxesTakeAboutFourTimesTheWork()
    {
        long few = Work(20), many = Work(40);
        Assert.True(few >= 400, $"{few} looks: each box sees itself at least");
        Assert.True(many < 6 * few, $"{few} looks for 400 boxes, {many} for 1600");
    }

    private static long Work(int side)
    {
        using var directory = new TempDirectory();
        const string shape = """{"type":"box","halfExtents":[0.4,0.4,0.4]}""";
        string boxes = string.Join(',', Enumerable.Range(0, side * side).Select(
            i => $"{{\"shape\":{shape},\"position\":[{i % side},{i / side},0]}}"));
        string file = directory.Write("s.json", $"{{\"version\":1,\"pairs\":[],\"objects\":[{boxes}]}}");
        Scene scene = SceneFile.Load(file, CancellationToken.None);
        SceneResults results = SceneResults.Of(scene, file, _ => { }, _ => { }, CancellationToken.None);
        return ScenePicture.Write(
            Stream.Null, scene, new ShapeTable(scene), results, _ => { }, CancellationToken.None);
    }
}
