namespace Gjk.Core.Tests.Contacts;

/// <summary>A shape of one's own with faces, right and wrong.</summary>
public class UserFaceTests
{
    private static readonly RigidPose Above = new(new Vector3(0.5f, 1.99f, 0.25f));

    /// <summary>A cube of side 2 whose faces are shown as its owner pleases.</summary>
    private readonly struct Cube(int corners, float badCoordinate = 0) : ISupportMap
    {
        public Double3 Center => default;
        public double Margin => 0;
        public double BoundingRadius => 1.75;
        public int Support(in Double3 d, out Double3 point) => new BoxShape(Vector3.One).Support(d, out point);
        public bool TryGetVertex(int id, out Double3 point) =>
            new BoxShape(Vector3.One).TryGetVertex(id, out point);

        public void GetFace(in Double3 direction, ref FaceCorners shown)
        {
            double y = direction.Y > 0 ? 1 : -1;
            for (int i = 0; i < corners; i++)
            {
                double angle = (i + 0.5) * (2 * Math.PI / corners), root = Math.Sqrt(2);
                shown.Add(new Double3(root * Math.Cos(angle), y + badCoordinate, root * Math.Sin(angle)), i);
            }
        }
    }

    private readonly struct NoFaces : ISupportMap
    {
        public Double3 Center => default;
        public double Margin => 0;
        public double BoundingRadius => 1.75;
        public int Support(in Double3 d, out Double3 point) => new BoxShape(Vector3.One).Support(d, out point);
        public void GetFace(in Double3 direction, ref FaceCorners corners)
        {
        }

        public bool TryGetVertex(int id, out Double3 point) =>
            new BoxShape(Vector3.One).TryGetVertex(id, out point);
    }

    [Fact]
    public void AShapeWithFacesHasAsManyPointsAsABox()
    {
        ContactManifold own = default, box = default, none = default;
        var slab = new BoxShape(Vector3.One);
        ConvexQuery.Contacts(slab, RigidPose.Identity, new Cube(4), Above, 0, out own);
        ConvexQuery.Contacts(slab, RigidPose.Identity, slab, Above, 0, out box);
        ConvexQuery.Contacts(slab, RigidPose.Identity, default(NoFaces), Above, 0, out none);
        Assert.Equal((4, 4, 1), (own.Count, box.Count, none.Count));
        Assert.Equal(box.Normal, own.Normal);
    }

    [Fact]
    public void ItAllocatesNothingAndNeitherDoItsDecorators()
    {
        var placed = new Placed<Rounded<Cube>>(new Rounded<Cube>(new Cube(4), 0.1f), RigidPose.Identity);
        ContactManifold m = default;
        Assert.Equal(0, Allocation.Least(Ask));
        Assert.Equal(4, m.Count);

        void Ask()
        {
            for (int i = 0; i < 100; i++)
            {
                ConvexQuery.Contacts(new Cube(4), RigidPose.Identity, placed, Above, 0, out m);
                ConvexQuery.Contacts(new Cube(4), RigidPose.Identity, default(NoFaces), Above, 0, out m);
                ConvexQuery.Contacts(new Cube(4), RigidPose.Identity, new Cube(4), Above, 0, out m);
            }
        }
    }

    /// <summary>No corners, too few, too many, or none that could be: the deepest pair is there.</summary>
    [Theory]
    [InlineData(0, 0)]
    [InlineData(1, 0)]
    [InlineData(2, 0)]
    [InlineData(100, 0)]
    [InlineData(4, float.NaN)]
    [InlineData(4, float.PositiveInfinity)]
    [InlineData(4, 1e30f)]
    public void WhatALyingShapeShowsDoesNoHarm(int corners, float badCoordinate)
    {
        ContactManifold m = default;
        DistanceResult r = ConvexQuery.Contacts(
            new BoxShape(Vector3.One), RigidPose.Identity, new Cube(corners, badCoordinate), Above, 1, out m);
        Assert.InRange(m.Count, 1, 4);
        Assert.Equal(-0.01f, r.Distance, 1e-6f);
        for (int i = 0; i < m.Count; i++)
            Assert.True(float.IsFinite(m[i].Gap) && float.IsFinite(m[i].PointA.LengthSquared()), m[i].ToString());
    }

    [Fact]
    public void ADefaultListTakesNothing()
    {
        FaceCorners corners = default;
        new BoxShape(Vector3.One).GetFace(new Double3(0, 1, 0), ref corners);
        Assert.Equal(0, corners.Count);
    }
}
