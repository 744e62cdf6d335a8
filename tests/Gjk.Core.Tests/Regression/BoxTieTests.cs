namespace Gjk.Core.Tests.Regression;

/// <summary>A mesh that is a box was asked by dot products where a component of the direction is smaller than their
/// rounding, and then did not answer as the box does. Signs are exact.</summary>
public class BoxTieTests
{
    [Theory]
    [InlineData(1e-17, 1, 0.3)]
    [InlineData(1, 1e-20, 1e-18)]
    [InlineData(0.7, -0.7, 1e-16)]
    [InlineData(5e-324, 1, 1)]
    [InlineData(-0.0, 1, 1)]
    [InlineData(1e-300, 1e-300, 1e-317)]
    [InlineData(1e300, -1e300, 1e300)]
    public void ATinyComponentChoosesACornerAsItDoesOfABox(double x, double y, double z)
    {
        foreach (Vector3 half in new[] { Vector3.One, new Vector3(1e3f, 1, 1e-3f), new Vector3(0.3f, 0.7f, 1.1f) })
        {
            Vector3[] corners = TestShape.Corners(half);
            Array.Reverse(corners);
            AssertSame(half, new ConvexHull(corners), new Double3(x, y, z));
            AssertSame(half, new ConvexHull(corners), new Double3(-x, -y, -z));
            AssertSame(half, new ConvexHull(TestShape.Corners(half)), new Double3(x, y, z));
        }
    }

    /// <summary>Boxes anywhere, in any order of their corners.</summary>
    [Fact]
    public void AMeshThatIsABoxAnswersAsTheBox()
    {
        var rng = new Rng(11);
        for (int i = 0; i < Budget.Count(20000); i++)
        {
            var half = new Vector3(rng.LogFloat(1e-3, 1e3), rng.LogFloat(1e-3, 1e3), rng.LogFloat(1e-3, 1e3));
            Vector3[] corners = TestShape.Corners(half);
            for (int k = corners.Length - 1; k > 0; k--)
            {
                int other = rng.Below(k + 1);
                (corners[k], corners[other]) = (corners[other], corners[k]);
            }

            var d = new Double3(rng.Range(-1, 1), rng.Range(-1, 1), rng.Range(-1, 1) * Math.Pow(2, -rng.Below(60)));
            AssertSame(half, new ConvexHull(corners), d);
        }
    }

    private static void AssertSame(Vector3 half, ConvexHull hull, in Double3 d)
    {
        new BoxShape(half).Support(d, out Double3 expected);
        int id = new ConvexMesh(hull).Support(d, out Double3 point);
        Assert.True(point == expected, $"{point} towards {d}, the box has {expected}");
        Assert.Equal((Vector3)expected, hull.GetVertex(id));
    }
}
