namespace Gjk.Core.Tests.Regression;

/// <summary>The support of a long helix missed its last corner in a patch of directions: a cell without a list gave its
/// place to the list of the next one. The distance to a cluster of points came back as InvalidShape. Found by an
/// independent attack.</summary>
public class LongHelixTests
{
    [Fact]
    public void TheLookUpFindsTheLastCorner()
    {
        const int Count = 100_000;
        var points = new Vector3[Count];
        for (int i = 0; i < Count; i++)
        {
            double t = 40 * Math.PI * i / Count;
            points[i] = new Vector3((float)Math.Cos(t), (float)(i / (double)Count), (float)Math.Sin(t));
        }

        var hull = new ConvexHull(points);
        var mesh = new ConvexMesh(hull);
        var rng = new Rng(1);
        for (int i = 0; i < 2000; i++)
        {
            double spread = i % 2 == 0 ? 1e-2 : 2;
            Double3 direction = new Double3(
                0.07440950995460804, 1.6945090610734834, 0.030966655724690553) + (Double3)rng.Vector(-1, 1) * spread;
            Assert.Equal(PlainScan.Furthest(hull.Cells, direction), mesh.Support(direction, out _));
        }
    }
}
