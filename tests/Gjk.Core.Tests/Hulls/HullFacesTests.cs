namespace Gjk.Core.Tests.Hulls;

/// <summary>What of a hull's surface counts as one face.</summary>
public class HullFacesTests
{
    /// <summary>A prism that was turned in float has two caps and its sides, not a fan of tilted triangles.</summary>
    [Theory]
    [InlineData(3, 0)]
    [InlineData(64, 0)]
    [InlineData(64, 1e3f)]
    [InlineData(500, 0)]
    public void CornersRoundedToFloatStillMakeAFace(int sides, float offset)
    {
        var rotation = Quaternion.CreateFromYawPitchRoll(0.4f, 1.1f, -0.3f);
        var axis = (Double3)Vector3.Transform(Vector3.UnitY, rotation);
        var hull = new ConvexHull(Array.ConvertAll(
            Clouds.Prism(sides, 1, 1), p => Vector3.Transform(p, rotation) + new Vector3(offset)));
        Assert.Equal(Math.Min(sides, FaceCorners.Capacity), Show(hull, axis).Distinct().Count());
        Assert.Equal(Math.Min(sides, FaceCorners.Capacity), Show(hull, -axis).Distinct().Count());
        if (sides <= 64) Assert.Equal(sides + 2, hull.Faces.Count);
    }

    /// <summary>However thin a plate is, its two sides are two faces; and a step that can be seen is one.</summary>
    [Theory]
    [InlineData(1e-9f)]
    [InlineData(1e-3f)]
    public void BothSidesOfAPlateAreFaces(float thickness)
    {
        var half = new Vector3(1, thickness, 1);
        var hull = new ConvexHull(Clouds.Box(half));
        Assert.Equal(6, hull.Faces.Count);
        Assert.Equal(4, Show(hull, new Double3(0, 1, 0)).Count);
        Assert.Empty(Show(hull, new Double3(0, 1, 0)).Intersect(Show(hull, new Double3(0, -1, 0))));
    }

    [Fact]
    public void ARoofOfAThousandthHasTwoFaces()
    {
        var hull = new ConvexHull([.. Clouds.Box(Vector3.One), new(-1, 1.001f, 0), new(1, 1.001f, 0)]);
        Assert.Equal(7, hull.Faces.Count);
        hull = new ConvexHull([.. Clouds.Box(Vector3.One), new(-1, 1.0000005f, 0), new(1, 1.0000005f, 0)]);
        Assert.Equal(6, hull.Faces.Count);
        Assert.Equal(4, Show(hull, new Double3(0, 1, 0)).Count);
    }

    [Fact]
    public void WhatHasNoFaceShowsItsEdgeOrCorner()
    {
        var point = new ConvexHull([Vector3.One]);
        Assert.Equal([0], Show(point, new Double3(0, 1, 0)));
        var segment = new ConvexHull([Vector3.Zero, Vector3.UnitX]);
        Assert.Equal([0, 1], Show(segment, new Double3(0, 1, 0)));
        Assert.Equal([1], Show(segment, new Double3(1, 0.5, 0)));
        var flat = new ConvexHull([Vector3.Zero, Vector3.UnitX, Vector3.UnitZ]);
        Assert.Equal(3, Show(flat, new Double3(0, 1, 0)).Count);
        Assert.Equal(3, Show(flat, new Double3(0, -1, 0)).Count);
        Assert.Equal([0, 1], Show(flat, new Double3(0, 0.1, -1)));
    }

    /// <summary>Of every face of many hulls: convex corners in order, all of them in its plane.</summary>
    [Fact]
    public void FacesAreConvexPolygonsOfTheirOwnCorners()
    {
        for (int i = 0; i < Budget.Count(300); i++)
        {
            var rng = new Rng((ulong)i);
            ConvexHull hull = Generators.Shape(rng, i % 2 == 0 ? "made" : "bigHull").Shape.Hull!;
            for (int k = 0; k < 20; k++)
            {
                Double3 d = rng.UnitVector();
                List<int> ids = Show(hull, d);
                Assert.Equal(ids.Count, ids.Distinct().Count());
                if (ids.Count < 3) continue;
                Double3[] p = [.. ids.Select(id => (Double3)hull.GetVertex(id))];
                Double3 normal = default;
                for (int j = 1; j + 1 < p.Length; j++) normal += Double3.Cross(p[j] - p[0], p[j + 1] - p[0]);
                Assert.True(Double3.Dot(normal, d) > 0, $"seed {i}: inside out");
                for (int j = 0; j < p.Length; j++)
                {
                    Double3 turn = Double3.Cross(
                        p[(j + 1) % p.Length] - p[j], p[(j + 2) % p.Length] - p[(j + 1) % p.Length]);
                    Assert.True(Double3.Dot(turn, normal) >= -1e-12 * normal.LengthSquared, $"seed {i}: not convex");
                }
            }
        }
    }

    private static unsafe List<int> Show(ConvexHull hull, Double3 direction)
    {
        FaceCorner* memory = stackalloc FaceCorner[FaceCorners.Capacity];
        var corners = new FaceCorners(memory);
        new ConvexMesh(hull).GetFace(direction, ref corners);
        var ids = new List<int>();
        for (int i = 0; i < corners.Count; i++) ids.Add(corners.IdOf(i));
        return ids;
    }
}
