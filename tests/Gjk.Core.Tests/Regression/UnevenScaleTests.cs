namespace Gjk.Core.Tests.Regression;

/// <summary>Tolerances were fractions of a bounding radius that grew with the largest factor of an uneven scale, or
/// with what a user's shape reported: a unit cube stored a million times too long overlapped a box 3.5e-9
/// away.</summary>
public class UnevenScaleTests
{
    private const int Exponent = 21;
    private const float Long = 1 << Exponent;

    /// <summary>Puts the cube's right face at x = 0.</summary>
    private static readonly RigidPose Left = new(new Vector3(-0.5f, 0, 0));

    /// <summary>A unit cube about the local origin that reports any bounding radius.</summary>
    private readonly struct GenerousCube(double radius) : ISupportMap
    {
        public Double3 Center => default;

        public double Margin => 0;

        public double BoundingRadius => radius;

        public int Support(in Double3 direction, out Double3 point)
        {
            point = new Double3(
                direction.X < 0 ? -0.5 : 0.5, direction.Y < 0 ? -0.5 : 0.5, direction.Z < 0 ? -0.5 : 0.5);
            return (direction.X < 0 ? 1 : 0) + (direction.Y < 0 ? 2 : 0) + (direction.Z < 0 ? 4 : 0);
        }

        public void GetFace(in Double3 direction, ref FaceCorners corners)
        {
        }

        public bool TryGetVertex(int id, out Double3 point)
        {
            point = new Double3((id & 1) != 0 ? -0.5 : 0.5, (id & 2) != 0 ? -0.5 : 0.5, (id & 4) != 0 ? -0.5 : 0.5);
            return id is >= 0 and < 8;
        }
    }

    [Theory]
    [InlineData(3.5e-9f)]
    [InlineData(2e-12f)]
    [InlineData(1e-3f)]
    [InlineData(0f)]
    public void AStretchedMeshScaledBackIsAsExactAsTheMesh(float gap)
    {
        Vector3[] corners = TestShape.Corners(new Vector3(0.5f * Long, 0.5f, 0.5f));
        ConvexShape scaled = ConvexShape.Mesh(corners).Scaled(new Vector3(1 / Long, 1, 1));
        var typed = new Scaled<ConvexMesh>(new ConvexMesh(corners), new Vector3(1 / Long, 1, 1));
        var rounded = new Rounded<Scaled<ConvexMesh>>(typed, 0);
        var box = new BoxShape(new Vector3(0, 0.25f, 0.25f));
        AssertGap(gap, ConvexQuery.Distance(scaled, Left, ConvexShape.Box(box.HalfExtents), At(gap)));
        AssertGap(gap, ConvexQuery.Distance(typed, Left, box, At(gap)));
        AssertGap(gap, ConvexQuery.Distance(rounded, Left, box, At(gap)));
        AssertGap(gap, ConvexQuery.Distance(box, At(gap), typed, Left));
    }

    [Theory]
    [InlineData(0.87)]
    [InlineData(1e6)]
    [InlineData(1e30)]
    public void AGenerousRadiusOfAUsersShapeLoosensNothing(double radius)
    {
        foreach (float gap in new[] { 0f, 2e-12f, 3.5e-9f, 1f })
        {
            var box = new BoxShape(new Vector3(0, 0.25f, 0.25f));
            AssertGap(gap, ConvexQuery.Distance(new GenerousCube(radius), Left, box, At(gap)));
            AssertGap(
                gap, ConvexQuery.Distance(new Scaled<GenerousCube>(new GenerousCube(radius), 1), Left, box, At(gap)));
            Assert.Equal(gap == 0, ConvexQuery.Overlaps(new GenerousCube(radius), Left, box, At(gap)));
        }
    }

    [Fact]
    public void ALongCylinderScaledBackIsTheShortOne()
    {
        ConvexShape scaled = ConvexShape.Cylinder(1, Long).Scaled(new Vector3(1, 1 / Long, 1));
        var rng = new Rng(11);
        for (int i = 0; i < 50; i++)
        {
            RigidPose pose = Generators.Pose(rng, rng.UnitVector() * rng.Float(2, 4));
            var box = ConvexShape.Box(rng.Vector(0.1, 0.7));
            DistanceResult expected = ConvexQuery.Distance(ConvexShape.Cylinder(1, 1), RigidPose.Identity, box, pose);
            DistanceResult r = ConvexQuery.Distance(scaled, RigidPose.Identity, box, pose);
            Assert.True(
                r.Status == expected.Status && System.Math.Abs(r.Distance - expected.Distance) <= 2e-6,
                $"case {i}: {r.Distance:R}, not {expected.Distance:R}");
        }
    }

    /// <summary>The flat box stands a gap to the right of the cube's right face, which is at x = 0.</summary>
    private static RigidPose At(float gap) => new(new Vector3(gap, 0, 0));

    private static void AssertGap(float gap, in DistanceResult r)
    {
        Assert.Equal(gap == 0 ? GjkStatus.Overlapping : GjkStatus.Separated, r.Status);
        Assert.Equal(gap, r.Distance, Accuracy.Band(gap, 1));
    }
}
