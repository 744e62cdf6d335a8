namespace Gjk.Core.Tests.Regression;

/// <summary>A support towards a flat face with 10^4 corners compared all of them. Counted in vertices and boxes looked
/// at, which no machine's load can change.</summary>
public class FlatFaceCostTests
{
    /// <summary>Count: vertices in a list, and in all lists per vertex of the hull.</summary>
    private const int LongestList = 512, EntriesPerVertex = 64;

    /// <summary>Count: pairs of nodes or leaves that a search looks at, on average for the directions of one distance
    /// from the normal.</summary>
    private const double MostSteps = 120;

    [Theory]
    [InlineData("prism")]
    [InlineData("turned prism")]
    [InlineData("cone")]
    [InlineData("disc")]
    [InlineData("turned disc")]
    [InlineData("dome")]
    [InlineData("cluster")]
    public void NoListIsLong(string kind)
    {
        var hull = new ConvexHull(HostileClouds.Create(kind));
        HullCells cells = hull.Cells;
        for (int i = 0; i < cells.NoCell; i++)
        {
            int blocks = cells.Runs[2 * i + 1] - cells.Runs[2 * i];
            Assert.InRange(blocks * HullCells.Lanes, cells.Tree is null ? 1 : 0, LongestList);
        }

        Assert.InRange(cells.Ids.Length, hull.VertexCount, EntriesPerVertex * hull.VertexCount);
    }

    [Theory]
    [InlineData(false, 5000)]
    [InlineData(true, 5000)]
    public void ASearchLooksAtFewOfTheCorners(bool turned, int sides)
    {
        Vector3[] cloud = HostileClouds.Prism(2 * sides);
        var hull = new ConvexHull(turned ? HostileClouds.Turned(cloud) : cloud);
        Assert.NotNull(hull.Cells.Tree);
        Vector3 axis = turned ? HostileClouds.Turned([Vector3.UnitZ])[0] : Vector3.UnitZ;
        var rng = new Rng(9);
        for (int exponent = -18; exponent < 0; exponent++)
        {
            const int Count = 200;
            int steps = 0;
            for (int i = 0; i < Count; i++)
            {
                Double3 d = (Double3)axis + (Double3)rng.UnitVector() * Math.Pow(10, exponent);
                int slot = hull.Cells.Tree!.Find(hull.Cells, d, hull.Cells.FirstSlot, out int more);
                steps += more;
                Assert.Equal(PlainScan.Furthest(hull.Cells, d), hull.Cells.Ids[slot]);
            }

            Assert.True(steps <= MostSteps * Count, $"{steps} steps at 1e{exponent}");
        }
    }
}
