namespace Gjk.Core.Tests.Regression;

/// <summary>Corners at every scale, as on a spiral that shrinks geometrically: a support towards the small ones looked
/// at nearly all of them. Counted in vertices and boxes looked at, which no machine's load can change.</summary>
public class DeepHullCostTests
{
    /// <summary>Counts. A search of all takes 1249 steps, each a pair of boxes or a leaf's vertices.</summary>
    private const int Corners = 20000, Directions = 300;

    /// <param name="length">The spiral's parameter runs from 0 to this; the radius is exp(-0.3 t).</param>
    /// <param name="power">The height is the radius to this power.</param>
    /// <param name="turned">Whether the axis is none of the coordinate axes.</param>
    /// <param name="mostSteps">Of a search, on average.</param>
    [Theory]
    [InlineData(20, 2, false, 115)]
    [InlineData(50, 2, false, 140)]
    [InlineData(100, 2, false, 120)]
    [InlineData(130, 2, false, 115)]
    [InlineData(200, 1.2, false, 230)]
    [InlineData(200, 1.2, true, 450)]
    [InlineData(250, 1.05, true, 450)]
    public void ASearchLooksAtFewOfTheCorners(double length, double power, bool turned, double mostSteps)
    {
        var hull = new ConvexHull(LogSpiral(length, power, turned));
        Assert.NotNull(hull.Cells.Tree);
        var rng = new Rng(31);
        int steps = 0;
        for (int i = 0; i < Directions; i++)
        {
            hull.GetTriangle(rng.Below(hull.TriangleCount), out int a, out int b, out int c);
            Double3 origin = hull.GetVertex(a);
            Double3 d = Double3.Cross(hull.GetVertex(b) - origin, hull.GetVertex(c) - origin);
            if (i % 2 == 1) d += (Double3)rng.UnitVector() * (d.Length * Math.Pow(10, -rng.Range(1, 18)));
            int slot = hull.Cells.Tree!.Find(hull.Cells, d, hull.Cells.FirstSlot, out int more);
            steps += more;
            Assert.Equal(PlainScan.Furthest(hull.Cells, d), hull.Cells.Ids[slot]);
        }

        Assert.True(steps <= mostSteps * Directions, $"{steps / (double)Directions} steps");
    }

    private static Vector3[] LogSpiral(double length, double power, bool turned)
    {
        // Turned in double: rounded before it, the heights would not be those of a convex surface.
        double cos = turned ? 0.6 : 1, sin = turned ? 0.8 : 0;
        var points = new Vector3[Corners];
        for (int i = 0; i < Corners; i++)
        {
            double t = length * i / Corners, r = Math.Exp(-0.3 * t), x = r * Math.Cos(20 * t), y = r * Math.Sin(20 * t);
            double z = Math.Pow(r, power);
            (y, z) = (cos * y - sin * z, sin * y + cos * z);
            (x, z) = (cos * x - sin * z, sin * x + cos * z);
            points[i] = new Vector3((float)x, (float)y, (float)z);
        }

        return points;
    }
}
