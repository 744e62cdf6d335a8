namespace Gjk.Core.Tests.BroadPhase;

/// <summary>The order in which a tree is built: all objects are in it, by size, and every part of it can be
/// split.</summary>
public class CurveOrderTests
{
    [Theory]
    [InlineData("spread")]
    [InlineData("oneFarAway")]
    [InlineData("allAlike")]
    [InlineData("manySizes")]
    public void EverySplitLeavesSomethingOnEitherSideAndLosesNothing(string kind)
    {
        BoundsTable table = Table(kind, 700);
        int[] ids = [.. Enumerable.Range(0, table.End).Where(id => id % 3 != 1)];
        var order = new CurveOrder(table);
        order.Reserve(ids.Length);
        order.Fill(ids, ids.Length);
        Assert.Equal(ids.Length, order.Count);

        var parts = new Stack<(int Begin, int End)>([(0, ids.Length)]);
        int splits = 0;
        while (parts.TryPop(out (int Begin, int End) part))
        {
            if (part.End - part.Begin < 2) continue;
            int[] before = Objects(order, part.Begin, part.End);
            int middle = order.Split(part.Begin, part.End);
            Assert.InRange(middle, part.Begin + 1, part.End - 1);
            Assert.Equal(before.Order(), Objects(order, part.Begin, part.End).Order());
            parts.Push((part.Begin, middle));
            parts.Push((middle, part.End));
            splits++;
        }

        Assert.Equal(ids.Length - 1, splits);
        Assert.Equal(ids, Objects(order, 0, ids.Length).Order());
    }

    /// <summary>A few that are a million times larger come last, whatever lies near them.</summary>
    [Fact]
    public void MuchLargerObjectsComeAfterAllOthers()
    {
        BoundsTable table = Table("spread", 400);
        int[] large = [17, 200, 399];
        foreach (int id in large) table.Boxes[id] = new Aabb(new Vector3(-1e6f), new Vector3(1e6f));
        var order = new CurveOrder(table);
        order.Reserve(table.End);
        order.Fill([.. Enumerable.Range(0, table.End)], table.End);
        Assert.Equal(large, Objects(order, table.End - large.Length, table.End).Order());
    }

    private static int[] Objects(CurveOrder order, int begin, int end) =>
        [.. Enumerable.Range(begin, end - begin).Select(place => order[place])];

    private static BoundsTable Table(string kind, int count)
    {
        var table = new BoundsTable();
        var rng = new Rng(1);
        for (int id = 0; id < count; id++)
        {
            Vector3 corner = kind == "allAlike" ? Vector3.One : rng.Vector(-10, 10);
            if (kind == "oneFarAway" && id == 3) corner *= 1e30f;
            float side = kind == "manySizes" ? rng.LogFloat(1e-6, 1e6) : 1;
            table.Add(id, new Aabb(corner, corner + new Vector3(side)));
        }

        return table;
    }
}
