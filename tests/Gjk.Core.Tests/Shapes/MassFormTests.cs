using static Gjk.Core.Tests.Support.SameMass;

namespace Gjk.Core.Tests.Shapes;

/// <summary>Mass, centre and inertia in closed form: against polyhedra with many corners, and against each other where
/// two forms meet.</summary>
public class MassFormTests
{
    private static readonly RigidPose Pose =
        new(Quaternion.Normalize(new Quaternion(0.2f, -0.5f, 0.4f, 0.7f)), new Vector3(3, -7, 5));

    private static readonly Vector3 Uneven = new(0.7f, -1.9f, 1.3f);

    private static readonly Vector3[] Tetrahedron =
        [new(0.1f, 0, 0), new(1.3f, 0.2f, 0), new(0, 0.8f, 0), new(0.4f, 0.3f, 0.9f)];

    [Theory]
    [InlineData("sphere")]
    [InlineData("ellipsoid")]
    [InlineData("cylinder")]
    [InlineData("cone")]
    [InlineData("capsule")]
    [InlineData("tapered")]
    [InlineData("taperedDown")]
    [InlineData("held")]
    [InlineData("box")]
    [InlineData("roundedBox")]
    [InlineData("roundedTapered")]
    [InlineData("leaningCapsule")]
    [InlineData("roundedTriangle")]
    [InlineData("roundedFlat")]
    [InlineData("roundedHull")]
    [InlineData("roundedCylinder")]
    [InlineData("roundedCone")]
    public void RoundShapesAreWhatTheirCornersMake(string kind)
    {
        ConvexShape plain = kind switch
        {
            "sphere" => ConvexShape.Sphere(0.7f),
            "ellipsoid" => ConvexShape.Ellipsoid(new Vector3(0.5f, 1.5f, 0.9f)),
            "cylinder" => ConvexShape.Cylinder(0.7f, 1.2f),
            "cone" => ConvexShape.Cone(0.7f, 1.2f),
            "capsule" => ConvexShape.Capsule(0.7f, 1.2f),
            "tapered" => ConvexShape.TaperedCapsule(0.3f, 0.9f, 0.8f),
            "taperedDown" => ConvexShape.TaperedCapsule(0.9f, 0, 0.6f),
            "held" => ConvexShape.TaperedCapsule(0.9f, 0.1f, 0.2f),
            "box" => ConvexShape.Box(new Vector3(0.5f, 1.5f, 0.9f)),
            "roundedBox" => ConvexShape.Box(new Vector3(0.5f, 0.1f, 0.9f)).Rounded(0.3f),
            "roundedTapered" => ConvexShape.TaperedCapsule(0.3f, 0.9f, 0.8f).Scaled(new Vector3(0.5f)).Rounded(0.25f),
            "roundedTriangle" => ConvexShape.Triangle(
                new Vector3(1, 2, 3), new Vector3(1.5f, 0.5f, 3.5f), new Vector3(2, 1.5f, 2)).Rounded(0.4f),
            "roundedFlat" => ConvexShape.Mesh([.. Tetrahedron[..3], new Vector3(0.9f, 0.9f, 0)]).Rounded(0.3f),
            "roundedHull" => ConvexShape.Mesh(Tetrahedron).Rounded(0.3f),
            "roundedCylinder" => ConvexShape.Cylinder(0.7f, 0.5f).Rounded(0.3f),
            "roundedCone" => ConvexShape.Cone(0.7f, 0.5f).Rounded(0.3f),
            _ => ConvexShape.Segment(new Vector3(1, 2, 3), new Vector3(1.5f, 0.5f, 3.5f)).Rounded(0.4f),
        };
        Vector3[] corners = Corners(plain), turned = [.. corners.Select(p => Pose.TransformPoint(p))];
        foreach ((ConvexShape shape, Vector3[] cloud) in new[]
            {
                (plain, corners), (plain.Placed(Pose), turned), (plain.Scaled(Uneven), [.. corners.Select(Stretched)]),
                (plain.Placed(Pose).Scaled(Uneven).Placed(Pose),
                    [.. turned.Select(p => Pose.TransformPoint(Stretched(p)))]),
            })
        {
            ExactMass cut = ExactOf(new ConvexHull(cloud));
            MassProperties found = shape.GetMassProperties();
            double size = found.InertiaDiagonal.Length, cutOff = 24.0 / corners.Length;
            Assert.InRange(cut.Volume / found.Volume, 1 - cutOff, 1 + 1e-6);
            Assert.True((cut.Center - found.Center).Length < cutOff, $"{cut.Center} {found.Center}");
            Assert.True((cut.Diagonal - found.InertiaDiagonal).Length < 2 * cutOff * size, $"{found.InertiaDiagonal}");
            Assert.True((cut.Products - found.InertiaProducts).Length < cutOff * size, $"{found.InertiaProducts}");
        }
    }

    /// <summary>Two closed forms of one body: a mistake in a coefficient that corners would not show.</summary>
    [Fact]
    public void FormsAgreeWhereTheyMeet()
    {
        ConvexShape capsule = ConvexShape.Capsule(0.7f, 1.2f), sphere = ConvexShape.Sphere(0.7f);
        Near(capsule, ConvexShape.TaperedCapsule(0.7f, 0.7f, 1.2f));
        Near(capsule, ConvexShape.Box(new Vector3(0, 1.2f, 0)).Rounded(0.7f));
        Near(capsule, ConvexShape.Segment(new Vector3(0, -1.2f, 0), new Vector3(0, 1.2f, 0)).Rounded(0.7f));
        Near(sphere, ConvexShape.Box(default).Rounded(0.7f));
        Near(sphere, ConvexShape.Ellipsoid(new Vector3(0.7f)));
        Near(sphere, ConvexShape.Capsule(0.7f, 0));
        Near(sphere, ConvexShape.Point().Rounded(0.7f));
        var half = new Vector3(0.5f, 1.5f, 0.9f);
        Near(ConvexShape.Box(half), ConvexShape.Mesh(Clouds.Box(half)));
        ConvexShape thinner = ConvexShape.TaperedCapsule(0.125f, 0.75f, 0.75f);
        Near(ConvexShape.TaperedCapsule(0.25f, 0.875f, 0.75f), thinner.Rounded(0.125f));
        Near(thinner.Scaled(new Vector3(2)).Rounded(0.25f), ConvexShape.TaperedCapsule(0.5f, 1.75f, 1.5f));
        Near(
            ConvexShape.TaperedCapsule(0.3f, 0.9f, 0.8f),
            ConvexShape.TaperedCapsule(0.9f, 0.3f, 0.8f).Scaled(new Vector3(1, -1, 1)));

        Near(capsule, ConvexShape.Cylinder(0, 1.2f).Rounded(0.7f));
        Near(capsule, ConvexShape.Cone(0, 1.2f).Rounded(0.7f));
        Near(sphere, ConvexShape.Cylinder(0, 0).Rounded(0.7f));
        Near(sphere, ConvexShape.Cone(0, 0).Rounded(0.7f));
        Near(ConvexShape.Cylinder(0.7f, 0).Rounded(0.3f), ConvexShape.Cone(0.7f, 0).Rounded(0.3f));
        Near(
            ConvexShape.Cone(1, 2).Scaled(new Vector3(0.5f)).Rounded(0.25f),
            ConvexShape.Cone(0.5f, 1).Rounded(0.25f));

        // A ball that all but holds the other, from both sides of the border.
        Near(ConvexShape.TaperedCapsule(2, 1, 0.5f), ConvexShape.TaperedCapsule(2, 1, MathF.BitIncrement(0.5f)), 1e-6);
    }

    /// <summary>Bodies of revolution are integrals along their outline: of y' times x², x² y, x² y², x⁴.</summary>
    [Theory]
    [InlineData(0.7f, 0.5f, 0.3f)]
    [InlineData(2, 0.001f, 0.25f)]
    [InlineData(0.001f, 2, 0.25f)]
    [InlineData(1, 1, 20)]
    [InlineData(1, 3, 0.001f)]
    public void RoundedCylindersAndConesAreTheIntegralsOfTheirOutlines(float radius, float half, float rounding)
    {
        double a = radius, h = half, r = rounding, slope = Math.Atan2(a, 2 * h);
        (double, double) At(double x, double y, double angle) => (x + r * Math.Cos(angle), y + r * Math.Sin(angle));
        (double, double) Arc(double x, double y, double from, double to, double t) =>
            At(x, y, from + (to - from) * t);
        (double X, double Y) Line((double X, double Y) p, (double X, double Y) q, double t) =>
            (p.X + (q.X - p.X) * t, p.Y + (q.Y - p.Y) * t);
        const double Quarter = Math.PI / 2;
        Near(
            ConvexShape.Cylinder(radius, half).Rounded(rounding).GetMassProperties(),
            OfOutline(
                t => Arc(a, -h, -Quarter, 0, t), t => Line(At(a, -h, 0), At(a, h, 0), t),
                t => Arc(a, h, 0, Quarter, t)),
            1e-12);
        Near(
            ConvexShape.Cone(radius, half).Rounded(rounding).GetMassProperties(),
            OfOutline(
                t => Arc(a, -h, -Quarter, slope, t), t => Line(At(a, -h, slope), At(0, h, slope), t),
                t => Arc(0, h, slope, Quarter, t)),
            1e-12);
    }

    /// <summary>By Simpson's rule over each piece, whose error falls with the fourth power of the step.</summary>
    private static MassProperties OfOutline(params Func<double, (double X, double Y)>[] pieces)
    {
        const int Steps = 4000;
        double volume = 0, first = 0, second = 0, across = 0;
        foreach (Func<double, (double X, double Y)> piece in pieces)
        {
            for (int i = 0; i < Steps; i++)
            {
                // The slope at three points is that of the parabola through them.
                (double X, double Y) p = piece((double)i / Steps), q = piece((i + 0.5) / Steps);
                (double X, double Y) s = piece((i + 1.0) / Steps);
                double Sum(Func<double, double, double> of) =>
                    (of(p.X, p.Y) * (4 * q.Y - 3 * p.Y - s.Y) + 4 * of(q.X, q.Y) * (s.Y - p.Y)
                        + of(s.X, s.Y) * (3 * s.Y - 4 * q.Y + p.Y)) / 6;
                volume += Math.PI * Sum((x, _) => x * x);
                first += Math.PI * Sum((x, y) => x * x * y);
                second += Math.PI * Sum((x, y) => x * x * y * y);
                across += Math.PI / 4 * Sum((x, _) => x * x * x * x);
            }
        }

        double center = first / volume, along = second - first * center;
        return new MassProperties(volume, new Double3(0, center, 0), new Double3(across, along, across));
    }

    /// <summary>Of a box as a mesh, also with corners on its edges and faces, the prisms, edges and corners are those
    /// of the box; of what is flat, straight or a point likewise.</summary>
    [Fact]
    public void RoundedHullsAreRoundedBoxesAndCapsules()
    {
        var half = new Vector3(0.5f, 1.5f, 0.75f);
        foreach (float radius in new[] { 0.001f, 0.3f, 20 })
        {
            ConvexShape box = ConvexShape.Box(half).Rounded(radius);
            Near(box, ConvexShape.Mesh(Clouds.Box(half)).Rounded(radius), 1e-14);
            float[] thirds = [-1, 0.5f, 1];
            Vector3[] more =
                [.. from x in thirds from y in thirds from z in thirds select new Vector3(x, y, z) * half];
            Near(box, ConvexShape.Mesh(more).Rounded(radius), 1e-14);
            Near(box.Placed(Pose), ConvexShape.Mesh(more).Rounded(radius).Placed(Pose), 1e-14);
            Vector3 flat = new(0.5f, 0, 0.75f), high = new(0, 1.5f, 0);
            Near(ConvexShape.Box(flat).Rounded(radius), ConvexShape.Mesh(Clouds.Box(flat)).Rounded(radius), 1e-14);
            ConvexShape capsule = ConvexShape.Capsule(radius, 1.5f), ball = ConvexShape.Sphere(radius);
            Near(capsule, ConvexShape.Mesh([high, -high]).Rounded(radius));
            Near(capsule, ConvexShape.Triangle(high, -high, high * 0.5f).Rounded(radius));
            Near(ball, ConvexShape.Triangle(default, default, default).Rounded(radius));
            Near(ball, ConvexShape.Mesh([Vector3.Zero]).Rounded(radius));

            // Two triangles are a rectangle; what both of them hold is the capsule about their common side.
            double two = 2 * ConvexShape.Triangle(-flat, flat, new Vector3(0.5f, 0, -0.75f)).Rounded(radius)
                .GetMassProperties().Volume;
            double both = ConvexShape.Segment(-flat, flat).Rounded(radius).GetMassProperties().Volume;
            Assert.Equal(1, (two - both) / ConvexShape.Box(flat).Rounded(radius).GetMassProperties().Volume, 1e-13);
        }
    }

    [Fact]
    public void AShapeThatIsPlacedTurnsItsInertia()
    {
        ConvexShape shape = ConvexShape.Cone(0.7f, 1.2f);
        MassProperties one = shape.GetMassProperties(3).At(Pose), other = shape.Placed(Pose).GetMassProperties(3);
        Near(one, other, 1e-15);
        Assert.NotEqual(0, one.InertiaProducts.X);
        MassProperties far = shape.Placed(new RigidPose(new Vector3(1e6f, 0, 0))).GetMassProperties();
        Assert.Equal(shape.GetMassProperties().InertiaDiagonal, far.InertiaDiagonal);

        // A turn by a third that takes y to z: the entries change places, to the last bit.
        MassProperties flat = ConvexShape.Cone(0.7f, 1.2f).Placed(
            new RigidPose(new Quaternion(0.5f, 0.5f, 0.5f, 0.5f), default)).GetMassProperties();
        Assert.Equal(flat.InertiaDiagonal, shape.AlongZ().GetMassProperties().InertiaDiagonal);
        Double3 upright = shape.GetMassProperties().InertiaDiagonal;
        Assert.Equal(new Double3(upright.Z, upright.X, upright.Y), flat.InertiaDiagonal);
    }

    [Fact]
    public void APowerOfTwoChangesNoDigit()
    {
        ConvexShape[] shapes = [ConvexShape.Cone(0.5f, 1).Rounded(0.25f), ConvexShape.TaperedCapsule(0.3f, 0.9f, 0.8f)];
        foreach (ConvexShape shape in shapes)
        {
            MassProperties plain = shape.GetMassProperties();
            foreach (int power in new[] { -60, 60 })
            {
                MassProperties found = shape.Scaled(new Vector3(MathF.ScaleB(1, power))).GetMassProperties();
                Assert.Equal(Math.ScaleB(plain.Volume, 3 * power), found.Volume);
                Assert.Equal(plain.InertiaDiagonal * Math.ScaleB(1, 5 * power), found.InertiaDiagonal);
            }
        }
    }

    private static Vector3 Stretched(Vector3 p) => p * Uneven;

    /// <summary>Points on a shape where its supports are, in directions spread evenly (a spiral of the golden
    /// angle).</summary>
    private static Vector3[] Corners(ConvexShape shape)
    {
        int count = Budget.IsLong ? 8000 : 1000;
        var points = new Vector3[count];
        for (int i = 0; i < count; i++)
        {
            double y = 1 - (2 * i + 1.0) / count, radius = Math.Sqrt(1 - y * y), angle = i * 2.399963229728653;
            var direction = new Double3(radius * Math.Cos(angle), y, radius * Math.Sin(angle));
            shape.Support(direction, out Double3 point);
            points[i] = (Vector3)(shape.Center + point + direction * shape.Margin);
        }

        return points;
    }
}
