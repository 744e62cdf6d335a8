using System.Linq;
using System.Numerics;
using Gjk.Core;
using Xunit;

namespace Gjk.Demo.Tests.Scenes;

/// <summary>The generator of the report's scenes. It is compiled into this assembly, as it is in the bench.</summary>
public sealed class BuiltInSceneTests
{
    [Fact]
    public void TheCubeHasEachCornerThreeTimes()
    {
        BuiltInScene scene = BuiltInScenes.Cubes();
        Assert.Equal(24, scene.Vertices.Count);
        Assert.Equal(8, scene.Vertices.Distinct().Count());
        Assert.All(scene.Vertices.GroupBy(v => v), corner => Assert.Equal(3, corner.Count()));
        Assert.All(scene.Vertices, v => Assert.Equal(new Vector3(0.5f), Vector3.Abs(v)));
        Assert.Equal(8, new ConvexHull(scene.Vertices).VertexCount);
    }

    [Fact]
    public void TheSphereHas515DistinctCorners()
    {
        BuiltInScene scene = BuiltInScenes.Spheres();
        Assert.Equal(515, scene.Vertices.Count);
        Assert.Equal(515, scene.Vertices.Distinct().Count());
        Assert.All(scene.Vertices, v => Assert.InRange(v.Length(), 0.499999f, 0.500001f));
        Assert.Equal(515, new ConvexHull(scene.Vertices).VertexCount);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void TheGridsStandAsTheReportDescribes(bool cubes)
    {
        BuiltInScene scene = cubes ? BuiltInScenes.Cubes() : BuiltInScenes.Spheres();
        Assert.Equal(20, scene.Poses.Count);
        Assert.Equal(20, scene.ObjectNames.Distinct().Count());
        Assert.Equal(20, scene.Poses.Select(p => p.Rotation).Distinct().Count());
        Assert.Equal(10, scene.Poses.Count(p => p.Position.Y == 0));
        Assert.Equal(10, scene.Poses.Count(p => p.Position.Y == 2.25f));

        float reach = scene.Vertices.Max(v => v.Length());
        int close = 0;
        for (int i = 0; i < 20; i++)
        {
            for (int j = i + 1; j < 20; j++)
            {
                float apart = Vector3.Distance(scene.Poses[i].Position, scene.Poses[j].Position);
                if (apart < 0.9f) close++;
                else Assert.True(apart > 2 * reach, $"{i} and {j} are {apart} apart");
            }
        }

        Assert.Equal(5, close);
    }
}
