namespace Gjk.Demo.Tests.Import;

/// <summary>Random hierarchies of three levels with uneven, negative and zero scales, so with skew. Every imported
/// shape must reach as far as its vertices under the full matrix, worked out here in another way.</summary>
public sealed class HierarchyTests
{
    private const int Seed = 20_261_122, Hierarchies = 250, Directions = 40;

    /// <summary>Share of the size, the distance from the origin included: what float positions allow.</summary>
    private const double Tolerance = 1e-6;

    private const string Capsule = "{fileID: 10208, guid: " + UnityText.BuiltIn + ", type: 0}";

    private const string Cylinder = "{fileID: 10206, guid: " + UnityText.BuiltIn + ", type: 0}";

    private const string Quad = "{fileID: 10210, guid: " + UnityText.BuiltIn + ", type: 0}";

    private const string Plane = "{fileID: 10209, guid: " + UnityText.BuiltIn + ", type: 0}";

    private readonly Rng _random = new(Seed);

    private bool _isEven;

    [Fact]
    public void ShapesReachAsFarAsTheFullMatrixSays()
    {
        using var directory = new TempDirectory();
        Vector3[] cloud = [.. Enumerable.Range(0, 12).Select(_ => _random.Vector(1))];
        var text = new UnityText();
        text.Mesh(77, "cloud", cloud, []);
        var expected = new Dictionary<string, Func<Double3, double>>();
        int skewed = 0;
        for (int i = 0; i < Hierarchies; i++)
        {
            bool isFlat = i % 10 == 0;
            (UnityObject top, Matrix world) = Object(text, null, Matrix.Identity, false);
            (UnityObject middle, world) = Object(text, top, world, false);
            (UnityObject leaf, world) = Object(text, middle, world, isFlat, $"leaf {i}");
            AddShape(text, leaf, i, isFlat, world, cloud, expected);
            if (world.IsSkewed) skewed++;
        }

        Assert.True(skewed > Hierarchies / 2, $"seed {Seed}: only {skewed} are skewed");
        Imported imported = Imported.Of(text.Save(directory, "random.unity"));
        Assert.Contains("(Mesh): warning: it has no faces", Assert.Single(imported.Lines));
        AssertReach(imported, expected);
    }

    private void AssertReach(Imported imported, Dictionary<string, Func<Double3, double>> expected)
    {
        Assert.Equal(expected.Count, imported.Scene.Objects.Length);
        foreach ((string name, Func<Double3, double> reach) in expected)
        {
            double size = Sides().Max(d => Math.Abs(reach(d)));
            for (int k = 0; k < Directions; k++)
            {
                Double3 d = _random.Direction();
                double difference = Imported.Reach(imported[name], d) - reach(d);
                Assert.True(
                    Math.Abs(difference) <= Tolerance * size,
                    $"seed {Seed}, {name}: {difference} of {size} along {d}");
            }
        }
    }

    /// <summary>Without uneven scales nothing is skewed, so colliders must reach as far as the full matrix says, too.
    /// Mirrors along any of the axes do not change that.</summary>
    [Fact]
    public void CollidersStayExactUnderMirrors()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        var expected = new Dictionary<string, Func<Double3, double>>();
        for (int i = 0; i < Hierarchies; i++)
        {
            _isEven = true;
            (UnityObject top, Matrix world) = Object(text, null, Matrix.Identity, false);
            (UnityObject middle, world) = Object(text, top, world, false);
            (UnityObject leaf, world) = Object(text, middle, world, false, $"leaf {i}");
            Assert.False(world.IsSkewed);
            Vector3 center = _random.Vector(2), size = 2 * new Vector3(_random.Float(0, 1), 0.5f, _random.Float(0, 1));
            Double3 half = 0.5 * (Double3)size;
            int axis = i % 3;
            if (i % 2 == 0) text.Box(leaf, size, center);
            else text.Capsule(leaf, 0.5f, 3, axis, center);
            expected.Add($"leaf {i}", i % 2 == 0
                ? d => Across(Double3.Multiply(half, world.Back(d))) + Double3.Dot(d, world.Apply(center))
                : d => Along(world.Back(d), axis) + 0.5 * world.Back(d).Length + Double3.Dot(d, world.Apply(center)));
        }

        AssertReach(Imported.Quietly(text.Save(directory, "mirrors.unity")), expected);
    }

    /// <summary>Rounded rotations alone do not look like skew: all objects share the mesh.</summary>
    [Fact]
    public void WithoutSkewAMeshIsShared()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.Mesh(77, "cloud", [new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], [0, 1, 2]);
        _isEven = true;
        for (int i = 0; i < Hierarchies; i++)
        {
            (UnityObject top, Matrix world) = Object(text, null, Matrix.Identity, false);
            (UnityObject middle, world) = Object(text, top, world, false);
            text.MeshFilter(Object(text, middle, world, false).Object, "{fileID: 77}");
        }

        Assert.Equal(["cloud"], Imported.Quietly(text.Save(directory, "even.unity")).Meshes);
    }

    /// <summary>A skew of a few units in the sixth digit is more than the tolerance leaves out.</summary>
    [Theory]
    [InlineData(1.000004f)]
    [InlineData(1.00003f)]
    [InlineData(1.001f)]
    public void ASmallSkewIsKept(float factor)
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.Mesh(77, "tip", [new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], [0, 1, 2]);
        UnityObject top = text.Object("top", scale: new(factor, 1, 1));
        Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 4);
        text.MeshFilter(text.Object("leaf", top, rotation: turn), "{fileID: 77}");
        text.MeshFilter(text.Object("ball", top, rotation: turn), UnityText.Sphere);
        Imported imported = Imported.Quietly(text.Save(directory, "small.unity"));
        Double3 d = new(1, 0, 0);
        double leaf = factor * Turned(turn, Vector3.UnitX).X;
        Assert.Equal(leaf, Imported.Reach(imported["leaf"], d), Tolerance / 5);
        Assert.Equal(0.5 * factor, Imported.Reach(imported["ball"], d), Tolerance / 5);
    }

    private static double Across(Double3 v) => Math.Abs(v.X) + Math.Abs(v.Y) + Math.Abs(v.Z);

    private static double Along(Double3 v, int axis) => Math.Abs(axis == 0 ? v.X : axis == 1 ? v.Y : v.Z);

    /// <summary>The kinds take turns. A flat capsule or cylinder cannot be made, so these stay solid.</summary>
    private static void AddShape(
        UnityText text, UnityObject leaf, int i, bool isFlat, Matrix world, Vector3[] cloud,
        Dictionary<string, Func<Double3, double>> expected)
    {
        (string mesh, Func<Double3, double> local) = (isFlat ? i / 10 % 4 : i % 7) switch
        {
            0 => ("{fileID: 77}", (Func<Double3, double>)(e => cloud.Max(v => Double3.Dot(e, v)))),
            1 => (UnityText.Cube, e => 0.5 * (Math.Abs(e.X) + Math.Abs(e.Y) + Math.Abs(e.Z))),
            2 => (UnityText.Sphere, e => 0.5 * e.Length),
            3 => (Quad, e => 0.5 * (Math.Abs(e.X) + Math.Abs(e.Y))),
            4 => (Plane, e => 5 * (Math.Abs(e.X) + Math.Abs(e.Z))),
            5 => (Capsule, e => 0.5 * Math.Abs(e.Y) + 0.5 * e.Length),
            _ => (Cylinder, e => Math.Abs(e.Y) + 0.5 * Math.Sqrt(e.X * e.X + e.Z * e.Z)),
        };
        text.MeshFilter(leaf, mesh);
        expected.Add($"leaf {i}", d => local(world.Back(d)) + Double3.Dot(d, world.Origin));
    }

    private (UnityObject Object, Matrix World) Object(
        UnityText text, UnityObject? parent, Matrix above, bool isFlat, string name = "node")
    {
        Vector3 position = _random.Vector(5), scale = new(Factor(), isFlat ? 0 : Factor(), Factor());
        if (_isEven)
            scale = MathF.Abs(scale.X) * new Vector3(Math.Sign(scale.X), Math.Sign(scale.Y), Math.Sign(scale.Z));
        Quaternion turn = _random.Rotation();
        UnityObject added = text.Object(name, parent, position, turn, scale);
        Double3 X(Vector3 axis, float factor) => above.Turn(Turned(turn, axis)) * factor;
        return (added, new Matrix(
            X(Vector3.UnitX, scale.X), X(Vector3.UnitY, scale.Y), X(Vector3.UnitZ, scale.Z),
            above.Turn(position) + above.Origin));
    }

    /// <summary>v + 2 q x (q x v + w v) over |q|^2, without a matrix.</summary>
    private static Double3 Turned(Quaternion q, Vector3 v)
    {
        var axis = new Double3(q.X, q.Y, q.Z);
        double length = axis.LengthSquared + (double)q.W * q.W;
        Double3 across = Double3.Cross(axis, v) + (Double3)v * q.W;
        return (Double3)v + Double3.Cross(axis, across) * (2 / length);
    }

    private float Factor() => (_random.OneIn(4) ? -1 : 1) * _random.Float(0.3, 3);

    private static Double3[] Sides() =>
        [new(1, 0, 0), new(-1, 0, 0), new(0, 1, 0), new(0, -1, 0), new(0, 0, 1), new(0, 0, -1)];

    /// <summary>The images of the axes and of the origin.</summary>
    private sealed record Matrix(Double3 X, Double3 Y, Double3 Z, Double3 Origin)
    {
        public static readonly Matrix Identity = new(new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), default);

        public bool IsSkewed =>
            Math.Abs(Double3.Dot(X, Y)) + Math.Abs(Double3.Dot(Y, Z)) + Math.Abs(Double3.Dot(Z, X))
            > 1e-3 * Math.Max(X.LengthSquared, Math.Max(Y.LengthSquared, Z.LengthSquared));

        public Double3 Turn(Double3 v) => X * v.X + Y * v.Y + Z * v.Z;

        public Double3 Apply(Double3 p) => Turn(p) + Origin;

        public Double3 Back(Double3 d) => new(Double3.Dot(X, d), Double3.Dot(Y, d), Double3.Dot(Z, d));
    }
}
