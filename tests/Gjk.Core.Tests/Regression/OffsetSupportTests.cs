namespace Gjk.Core.Tests.Regression;

/// <summary>The support of a mesh far from its local origin compared dot products of absolute coordinates: it was wrong
/// by 1e-16 of the offset, not of the size.</summary>
public class OffsetSupportTests
{
    [Theory]
    [InlineData(1e3)]
    [InlineData(5.8e6)]
    [InlineData(1e7)]
    public void TheSupportIsRightToRoundingOfTheSize(double offset)
    {
        for (ulong seed = 0; seed < 100; seed++)
        {
            var rng = new Rng(seed);
            Vector3 away = (float)offset * new Vector3(rng.Float(0.5, 1), -rng.Float(0.5, 1), rng.Float(0.5, 1));
            Vector3[] near = Clouds.InBox(rng, rng.Below(2) == 0 ? 10 : 60, new Vector3(4));
            Vector3[] cloud = Array.ConvertAll(near, p => p + away);
            var hull = new ConvexHull(cloud);
            for (int i = 0; i < 100; i++)
            {
                // Two vertices are level but for a little, less than the rounding of absolute heights.
                hull.GetVertex(rng.Below(hull.VertexCount), out Double3 p);
                hull.GetVertex(rng.Below(hull.VertexCount), out Double3 q);
                Double3 d = Double3.Cross(p - q, (Double3)rng.UnitVector()) + (Double3)rng.UnitVector() * 1e-12;
                HullSupport.Find(hull.Cells, d, out Double3 point);
                double behind = cloud.Max(c => Height((Double3)c - point, d));
                double reach = cloud.Max(c => ((Double3)c - point).Length) * d.Length;
                Assert.True(behind <= 1e-15 * reach, $"seed {seed}: {point} towards {d} is {behind} behind");
            }
        }
    }

    [Theory]
    [InlineData(0, 1)]
    [InlineData(1e3, 1)]
    [InlineData(1e7, 3)]
    [InlineData(3, 1)]
    [InlineData(1.5, 0.5)]
    [InlineData(1e-38, 3e-39)]
    [InlineData(3e38, 1e37)]
    [InlineData(-2e30, 1e23)]
    public void TheVerticesComeBackBitForBit(double offset, double size)
    {
        var rng = new Rng(5);
        var away = new Double3(offset, -offset, 0);
        var cloud = new Vector3[40];
        for (int i = 0; i < cloud.Length; i++) cloud[i] = (Vector3)(away + (Double3)rng.Vector(-1, 1) * size);
        var hull = new ConvexHull(cloud);
        Double3 half = ((Double3)hull.Bounds.Max - hull.Bounds.Min) * 0.5;
        for (int i = 0; i < hull.VertexCount; i++)
        {
            Vector3 vertex = hull.GetVertex(i);
            hull.GetVertex(i, out Double3 wide);
            Assert.Equal(cloud[hull.SourceIndex(i)], vertex);
            Assert.Equal((Double3)vertex, wide);
            Assert.InRange(Math.Abs(hull.Vertices.X[i]), 0, 4 * half.X);
            Assert.InRange(Math.Abs(hull.Vertices.Y[i]), 0, 4 * half.Y);
            Assert.InRange(Math.Abs(hull.Vertices.Z[i]), 0, 4 * half.Z);
        }
    }

    /// <summary>In double-double: a difference of vertices is exact here, and so are its products.</summary>
    private static double Height(in Double3 v, in Double3 d) =>
        (double)(DoubleDouble.Product(v.X, d.X) + DoubleDouble.Product(v.Y, d.Y) + DoubleDouble.Product(v.Z, d.Z));
}
