namespace Gjk.Core.Tests.Shapes;

/// <summary>What is asked of every kind. A new one needs a sample here.</summary>
public class ShapeKindTests
{
    public static TheoryData<ShapeKind> Kinds =>
        [.. Enum.GetValues<ShapeKind>().Except([ShapeKind.None, ShapeKind.Custom])];

    /// <summary>Records are read kind by kind up to Custom, and the numbers are public.</summary>
    [Fact]
    public void TheNumbersHaveNoGapAndCustomIsTheLast()
    {
        ShapeKind[] kinds = Enum.GetValues<ShapeKind>();
        Assert.Equal(Enumerable.Range(0, kinds.Length - 1), kinds[..^1].Select(kind => (int)kind));
        Assert.Equal(ShapeKind.Custom, kinds[^1]);
        Assert.Equal(byte.MaxValue, (int)ShapeKind.Custom);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void EachHasTheMassOfItsCornersOrIsRefusedByName(ShapeKind kind)
    {
        ConvexShape shape = Sample(kind);
        Assert.Equal(kind, shape.Kind);
        if (kind == ShapeKind.HalfSpace)
        {
            var refused = Assert.Throws<InvalidOperationException>(() => shape.GetMassProperties());
            Assert.StartsWith("A half-space has no mass", refused.Message);
            return;
        }

        // The hull of many supports lies inside, and misses little.
        var rng = new Rng(7);
        var corners = new Vector3[4000];
        for (int i = 0; i < corners.Length; i++)
        {
            Vector3 direction = rng.UnitVector();
            shape.Support(direction, out Double3 point);
            corners[i] = (Vector3)(shape.Center + point + (Double3)direction * shape.Margin);
        }

        MassProperties body = shape.GetMassProperties();
        double volume = ConvexShape.Mesh(corners).GetMassProperties().Volume;
        Assert.InRange(body.Volume, volume * 0.999999, volume * 1.02 + 1e-9);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void ARecordOfEachIsReadAgain(ShapeKind kind)
    {
        ConvexShape shape = Sample(kind);
        string text = new QueryRecord(shape, RigidPose.Identity, shape, RigidPose.Identity).ToString();
        QueryRecord record = QueryRecord.Parse(text);
        Assert.Equal(kind, record.A.Kind);
        Assert.Equal(text, record.ToString());
        if (kind != ShapeKind.Mesh) Assert.Equal(shape, record.A);
    }

    [Theory]
    [InlineData("none")]
    [InlineData("custom")]
    [InlineData("13")]
    [InlineData("4")]
    [InlineData("254")]
    public void WhatIsNoKindIsNotRead(string name) => Assert.Throws<FormatException>(
        () => QueryRecord.Parse($"gjk1 {name} 1 1 1 @ 0 0 0 1 0 0 0 point 0 @ 0 0 0 1 3 0 0"));

    private static ConvexShape Sample(ShapeKind kind) => kind switch
    {
        ShapeKind.Point => ConvexShape.Point(),
        ShapeKind.Segment => ConvexShape.Segment(new Vector3(1, 2, 3), new Vector3(1.5f, 0.5f, 3.5f)),
        ShapeKind.Triangle => ConvexShape.Triangle(Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ),
        ShapeKind.Box => ConvexShape.Box(new Vector3(0.5f, 1.5f, 0.9f)),
        ShapeKind.Cylinder => ConvexShape.Cylinder(0.7f, 1.2f),
        ShapeKind.Cone => ConvexShape.Cone(0.7f, 1.2f),
        ShapeKind.Ellipsoid => ConvexShape.Ellipsoid(new Vector3(0.5f, 1.5f, 0.9f)),
        ShapeKind.Mesh => ConvexShape.Mesh([default, Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ]),
        ShapeKind.Sphere => ConvexShape.Sphere(0.7f),
        ShapeKind.Capsule => ConvexShape.Capsule(0.7f, 1.2f),
        ShapeKind.TaperedCapsule => ConvexShape.TaperedCapsule(0.3f, 0.9f, 0.8f),
        ShapeKind.HalfSpace => ConvexShape.HalfSpace(Vector3.UnitY, 0.5f),
        _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "Has no sample here."),
    };
}
