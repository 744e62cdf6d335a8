namespace Gjk.Core.Tests.Regression;

/// <summary>"A direction of any length": a cylinder and a cone gave their axis towards 1e-170, an ellipsoid its centre
/// towards 1e200, because squares of components left the range of double.</summary>
public class DirectionLengthTests
{
    private static readonly ConvexShape[] Shapes =
    [
        ConvexShape.Cylinder(1, 2), ConvexShape.Cone(1, 2), ConvexShape.Ellipsoid(new Vector3(1, 2, 3)),
        ConvexShape.Ellipsoid(new Vector3(1e-20f, 1, 1e20f)),
        ConvexShape.Capsule(1, 2).Scaled(new Vector3(1, 2, 3)),
        ConvexShape.Cylinder(1, 2).Scaled(new Vector3(1e10f, 1, 1e-10f)), ConvexShape.Box(new Vector3(1, 2, 3)),
        ConvexShape.Segment(new Vector3(1, 2, 3), new Vector3(3, 1, 2)),
        ConvexShape.Triangle(Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ),
    ];

    [Theory]
    [InlineData(-1060)]
    [InlineData(-700)]
    [InlineData(-400)]
    [InlineData(400)]
    [InlineData(700)]
    [InlineData(1019)]
    public void TheLengthDoesNotMatter(int exponent)
    {
        var rng = new Rng(7);
        double factor = Math.Pow(2, exponent);
        for (int i = 0; i < 2000; i++)
        {
            // Few bits, so that even denormal components hold them.
            var direction = new Double3(rng.Below(31) - 15, rng.Below(31) - 15, rng.Below(31) - 15);
            if (direction == default) continue;
            ConvexShape shape = Shapes[i % Shapes.Length];
            shape.Support(direction, out Double3 expected);
            shape.Support(direction * factor, out Double3 point);
            Assert.True(
                (point - expected).Length <= 1e-12 * expected.Length,
                $"{point}, not {expected}, towards {direction} x 2^{exponent}, shape {i % Shapes.Length}");
        }
    }

    [Theory]
    [InlineData(1e-170)]
    [InlineData(1e-300)]
    [InlineData(5e-324)]
    public void ATinyRadialPartStillNamesTheRim(double radial)
    {
        foreach (ConvexShape shape in new[] { ConvexShape.Cylinder(1, 2), ConvexShape.Cone(1, 2) })
        {
            shape.Support(new Double3(radial, -1, 0), out Double3 point);
            Assert.True((point - new Double3(1, -2, 0)).Length < 1e-12, $"{point}");
        }
    }
}
