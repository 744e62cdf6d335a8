namespace Gjk.Core.Tests.World;

/// <summary>Which objects a question from outside the scene sees.</summary>
public class QueryFilterTests
{
    [Fact]
    public void ADefaultStructSeesAll()
    {
        QueryFilter filter = default;
        Assert.Equal(
            (uint.MaxValue, uint.MaxValue, true, true, -1),
            (filter.Groups, filter.Mask, filter.SeesStatic, filter.SeesMoving, filter.IgnoredId));
        Assert.Equal(filter, new QueryFilter());
        Assert.True(filter == new QueryFilter(ignoredId: -1) && filter != new QueryFilter(ignoredId: 0));
        Assert.NotEqual(filter.GetHashCode(), new QueryFilter(seesStatic: false).GetHashCode());
        Assert.True(filter.Equals((object)default(QueryFilter)) && !filter.Equals(null));
        Assert.True(filter.Sees(0, default));
        Assert.True(filter.Sees(0, new ObjectSettings(isStatic: true, groups: 0, mask: 0)));
    }

    [Fact]
    public void EachPartLeavesOutWhatItNames()
    {
        var red = new ObjectSettings(groups: 2, mask: 4);
        var wall = new ObjectSettings(isStatic: true, groups: 8);
        Assert.True(new QueryFilter(groups: 4).Sees(0, red) && !new QueryFilter(groups: 2).Sees(0, red));
        Assert.True(new QueryFilter(mask: 2).Sees(0, red) && !new QueryFilter(mask: 4).Sees(0, red));
        Assert.True(new QueryFilter(groups: 4, mask: 2).Sees(0, red));
        Assert.False(new QueryFilter(groups: 4, mask: 8).Sees(0, red));
        Assert.False(new QueryFilter(groups: 1, mask: 2).Sees(0, red));
        Assert.True(new QueryFilter(seesMoving: false).Sees(0, wall));
        Assert.False(new QueryFilter(seesMoving: false).Sees(0, red));
        Assert.False(new QueryFilter(seesStatic: false).Sees(0, wall));
        Assert.True(new QueryFilter(seesStatic: false).Sees(0, red));
        Assert.False(new QueryFilter(ignoredId: 3).Sees(3, red));
        Assert.True(new QueryFilter(ignoredId: 3).Sees(4, red));
        Assert.False(new QueryFilter(groups: 0).Sees(0, default) || new QueryFilter(mask: 0).Sees(0, default));
    }
}
