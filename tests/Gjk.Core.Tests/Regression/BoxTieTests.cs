using System;
using System.Numerics;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Regression;

/// <summary>
/// A box's corner was chosen by the signs of the direction even where a component was smaller than the rounding of the
/// dot product, so that all other ways to find the vertex saw a tie.
/// </summary>
public class BoxTieTests
{
    [Theory]
    [InlineData(1e-17, 1, 0.3)]
    [InlineData(1, 1e-20, 1e-18)]
    [InlineData(0.7, -0.7, 1e-16)]
    [InlineData(5e-324, 1, 1)]
    [InlineData(-0.0, 1, 1)]
    [InlineData(1e-300, 1e-300, 1e-317)]
    public void ATinyComponentDoesNotChooseACorner(double x, double y, double z)
    {
        foreach (Vector3 half in new[] { Vector3.One, new Vector3(1e3f, 1, 1e-3f), new Vector3(0.3f, 0.7f, 1.1f) })
        {
            // Corners in the order of falling signs: the lowest of the level ones is not the one that signs choose.
            Vector3[] corners = TestShape.Corners(half);
            Array.Reverse(corners);
            AssertSame(new ConvexHull(corners), new Vector3D(x, y, z));
            AssertSame(new ConvexHull(corners), new Vector3D(-x, -y, -z));
            AssertSame(new ConvexHull(TestShape.Corners(half)), new Vector3D(x, y, z));
        }
    }

    [Fact]
    public void SignsAndScanAgreeAroundTheTie()
    {
        var rng = new Rng(11);
        int signs = 0, count = Budget.Count(20000);
        for (int i = 0; i < count; i++)
        {
            var half = new Vector3(rng.LogFloat(1e-3, 1e3), rng.LogFloat(1e-3, 1e3), rng.LogFloat(1e-3, 1e3));
            Vector3 away = rng.Below(2) == 0 ? default : rng.Vector(-1e4, 1e4);
            var hull = new ConvexHull(Array.ConvertAll(TestShape.Corners(half), p => p + away));
            var d = new Vector3D(rng.Range(-1, 1), rng.Range(-1, 1), rng.Range(-1, 1) * Math.Pow(2, -rng.Below(60)));
            AssertSame(hull, d);
            signs += Math.Abs(d.Z) > hull.Cells.BoxTie * (Math.Abs(d.X) + Math.Abs(d.Y) + Math.Abs(d.Z)) ? 1 : 0;
        }

        Assert.InRange(signs, 0.3 * count, 0.95 * count);
    }

    private static void AssertSame(ConvexHull hull, in Vector3D d)
    {
        int id = HullSupport.Find(hull.Cells, d, out _), expected = HullSupport.Scan(hull.Cells, d);
        Assert.True(id == expected, $"{hull.GetVertex(id)} towards {d}, the scan finds {hull.GetVertex(expected)}");
    }
}
