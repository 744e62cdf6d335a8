using System;
using System.Linq;
using System.Numerics;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Regression;

/// <summary>
/// A shape in a copy of itself that is turned by a few last places: the facets of the two lie beside each other,
/// support points lie above a face by rounding alone, and the surface turned inside out. The depth was said to be 0, or
/// the room ran out.
/// </summary>
public class NearCopyDepthTests
{
    private static readonly Vector3[] Octahedron =
    [
        Vector3.UnitX, -Vector3.UnitX, Vector3.UnitY, -Vector3.UnitY, Vector3.UnitZ, -Vector3.UnitZ,
    ];

    [Fact]
    public void AnOctahedronInItself()
    {
        ConvexShape shape = ConvexShape.Mesh(Octahedron);
        DistanceResult r = ConvexQuery.SignedDistance(
            shape, new RigidPose(new(0.5f, 0.5f, -0.5f, 0.5f), default),
            shape, new RigidPose(new(0.5f, 0.500000119f, -0.5f, 0.5f), default));
        Assert.Equal((GjkStatus.Overlapping, -1.1547005f), (r.Status, r.Distance));
    }

    [Fact]
    public void ShapesThatAreTurnedByAFewLastPlaces()
    {
        ConvexShape[] shapes =
        [
            ConvexShape.Mesh(Octahedron), ConvexShape.Mesh(Cylinder(3)), ConvexShape.Mesh(Cylinder(12)),
            ConvexShape.Mesh(Cylinder(64)), ConvexShape.Box(Vector3.One),
        ];
        double[] depths = [2 / Math.Sqrt(3), 1.5, 2 * Math.Cos(Math.PI / 12), 2 * Math.Cos(Math.PI / 64), 2];
        for (ulong seed = 0; seed < (ulong)Budget.Count(400); seed++)
        {
            var rng = new Rng(81_000 + seed);
            Quaternion q = rng.Rotation();
            float[] off = [.. Enumerable.Range(0, 4).Select(_ => rng.Float(-1e-7, 1e-7))];
            var turned = Quaternion.Normalize(new(q.X + off[0], q.Y + off[1], q.Z + off[2], q.W + off[3]));
            int kind = rng.Below(shapes.Length);
            DistanceResult r = ConvexQuery.SignedDistance(
                shapes[kind], new RigidPose(q, default), shapes[kind], new RigidPose(turned, default));
            Assert.True(
                r.IsOverlapping && Math.Abs(r.Distance + depths[kind]) < 2e-6, $"seed {seed}, kind {kind}: {r}");
        }
    }

    [Fact]
    public void APointInACylinderOfManySides()
    {
        ConvexShape cylinder = ConvexShape.Mesh(Cylinder(8));
        DistanceResult r = ConvexQuery.SignedDistance(
            ConvexShape.Point(), new RigidPose(new Vector3(0.136410892f, 0.0401664525f, 0.04207756f)), cylinder,
            new RigidPose(new(0, 0, 0.866025388f, 0.5f), default));
        Assert.Equal((GjkStatus.Overlapping, -0.8617815f), (r.Status, r.Distance));
    }

    [Theory]
    [InlineData(0.70710677f, 0, 0.70710677f)]
    [InlineData(0, 0.70710677f, 0.70710677f)]
    [InlineData(0, 0, 1)]
    public void ABoxInACylinderOfManySides(float y, float z, float w)
    {
        DistanceResult r = ConvexQuery.SignedDistance(
            ConvexShape.Box(Vector3.One), new RigidPose(new(0, y, z, w), default), ConvexShape.Mesh(Cylinder(12)),
            RigidPose.Identity);
        Assert.Equal((GjkStatus.Overlapping, -2f), (r.Status, r.Distance));
    }

    private static Vector3[] Cylinder(int sides) =>
    [
        .. from i in Enumerable.Range(0, sides)
           from y in new[] { -1, 1 }
           let angle = 2 * MathF.PI * i / sides
           select new Vector3(MathF.Cos(angle), y, MathF.Sin(angle)),
    ];
}
