namespace Gjk.Core.Tests.Solvers;

/// <summary>The normals of overlapping ellipsoids are good to 1e-6 rad; 1.2e-7 of that is the rounding of the three
/// floats.</summary>
public class SmoothNormalTests
{
    private const double Promise = 1e-6, Rounding = 1.2e-7;

    /// <summary>Equal spheres, written as ellipsoids, leave each other along the line of their centres.</summary>
    [Fact]
    public void SpheresAsEllipsoidsLeaveAlongTheirCentres()
    {
        var rng = new Rng(1);
        for (int i = 0; i < 500; i++)
        {
            ConvexShape a = ConvexShape.Ellipsoid(new Vector3(0.7f)), b = ConvexShape.Ellipsoid(new Vector3(0.6f));
            Vector3 offset = Vector3.Normalize(rng.Vector(-1, 1)) * rng.Float(0.1, 1.29);
            DistanceResult r = ConvexQuery.SignedDistance(
                a, new RigidPose(Quaternion.Normalize(rng.Rotation()), default), b,
                new RigidPose(Quaternion.Normalize(rng.Rotation()), offset));
            var centres = (Double3)offset;
            double off = ((Double3)r.Normal - centres * (1 / centres.Length)).Length;
            Assert.True(off <= Promise + Rounding, $"{i}: {off:G3} by {offset}");
        }
    }

    /// <summary>At the shortest way out the normals of both surfaces at the deepest points are opposite; for ellipsoids
    /// they are the gradients there.</summary>
    [Fact]
    public void EllipsoidsLeaveAlongTheNormalsOfBothSurfaces()
    {
        var rng = new Rng(2);
        int count = 0;
        for (int i = 0; i < 500; i++)
        {
            Vector3 Radii() => new(rng.Float(0.4, 1), rng.Float(0.4, 1), rng.Float(0.4, 1));
            Vector3 radiiA = Radii(), radiiB = Radii();
            var a = new RigidPose(Quaternion.Normalize(rng.Rotation()), default);
            var b = new RigidPose(
                Quaternion.Normalize(rng.Rotation()), Vector3.Normalize(rng.Vector(-1, 1)) * rng.Float(0.3, 1));
            ConvexShape shapeA = ConvexShape.Ellipsoid(radiiA), shapeB = ConvexShape.Ellipsoid(radiiB);
            DistanceResult r = ConvexQuery.SignedDistance(shapeA, a, shapeB, b);
            if (r.Status != GjkStatus.Overlapping || r.Distance > -1e-2f) continue;
            count++;
            Double3 ofA = Gradient(radiiA, a, r.LocalPointA), ofB = -Gradient(radiiB, b, r.LocalPointB);
            double off = Math.Max(((Double3)r.Normal - ofA).Length, ((Double3)r.Normal - ofB).Length);

            // The points are floats, too, and a surface turns by up to 6 times as much as a point on it moves.
            Assert.True(off <= 2 * Promise, $"{i}: {off:G3}, {new QueryRecord(shapeA, a, shapeB, b)}");
        }

        Assert.InRange(count, 300, 500);
    }

    private static Double3 Gradient(Vector3 radii, RigidPose pose, Vector3 local)
    {
        var gradient = new Double3(
            local.X / ((double)radii.X * radii.X), local.Y / ((double)radii.Y * radii.Y),
            local.Z / ((double)radii.Z * radii.Z));
        return new RotationD(pose.Rotation).Rotate(gradient * (1 / gradient.Length));
    }
}
