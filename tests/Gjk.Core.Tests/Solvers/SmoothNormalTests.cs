namespace Gjk.Core.Tests.Solvers;

/// <summary>Where the shortest way out bends, the normals of overlapping curved shapes are good to 1e-6 rad; 1.2e-7 of
/// that is the rounding of the three floats.</summary>
public class SmoothNormalTests
{
    private const double Promise = 1e-6, Rounding = 1.2e-7;

    private const int Kinds = 8;

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

    /// <summary>By their margins alone, or deeper.</summary>
    [Theory]
    [InlineData(ShapeKind.Ellipsoid, ShapeKind.Sphere)]
    [InlineData(ShapeKind.Ellipsoid, ShapeKind.Capsule)]
    [InlineData(ShapeKind.Ellipsoid, ShapeKind.RoundedEllipsoid)]
    [InlineData(ShapeKind.Ellipsoid, ShapeKind.Tapered)]
    [InlineData(ShapeKind.RoundedEllipsoid, ShapeKind.Sphere)]
    [InlineData(ShapeKind.RoundedEllipsoid, ShapeKind.RoundedEllipsoid)]
    [InlineData(ShapeKind.Capsule, ShapeKind.Cylinder)]
    [InlineData(ShapeKind.Capsule, ShapeKind.Tapered)]
    [InlineData(ShapeKind.Tapered, ShapeKind.Sphere)]
    [InlineData(ShapeKind.Tapered, ShapeKind.Tapered)]
    [InlineData(ShapeKind.Tapered, ShapeKind.Cylinder)]
    [InlineData(ShapeKind.Tapered, ShapeKind.Cone)]
    [InlineData(ShapeKind.Tapered, ShapeKind.RoundedBox)]
    public void ShapesWithMarginsLeaveAlongTheSharpNormal(ShapeKind first, ShapeKind second)
    {
        const int Pairs = 2000;
        var rng = new Rng(3);
        int count = 0;
        for (int i = 0; i < Pairs; i++)
        {
            ConvexShape a = Shape(first, rng), b = Shape(second, rng);
            var poseA = new RigidPose(Quaternion.Normalize(rng.Rotation()), rng.Vector(-1, 1));
            RigidPose poseB = Beside(a, poseA, b, rng);
            if (IsSharp(a, poseA, b, poseB, i)) count++;
        }

        Assert.InRange(count, 40, Pairs);
    }

    /// <summary>Bare, scaled and rounded ones.</summary>
    [Fact]
    public void RandomShapesLeaveAlongTheSharpNormal()
    {
        var rng = new Rng(4);
        int count = 0;
        for (int i = 0; i < 4000; i++)
        {
            ConvexShape a = Shape((ShapeKind)rng.Below(Kinds), rng), b = Shape((ShapeKind)rng.Below(Kinds), rng);
            if (IsPolytope(a) && IsPolytope(b)) continue;
            Vector3 scale = rng.OneIn(3) ? new(rng.Float(0.5, 1), rng.Float(1, 2), rng.Float(-2, -1)) : Vector3.One;
            a = a.Scaled(scale);
            if (rng.OneIn(4)) b = b.Rounded(rng.Float(0.01, 0.2));
            var poseA = new RigidPose(Quaternion.Normalize(rng.Rotation()), rng.Vector(-1, 1));
            if (IsSharp(a, poseA, b, Beside(a, poseA, b, rng), i)) count++;
        }

        Assert.InRange(count, 500, 4000);
    }

    private static bool IsPolytope(in ConvexShape shape) => shape.TryGetVertex(0, out _);

    /// <summary>Holds the answers to what is promised.</summary>
    /// <returns>Whether anything is: they overlap, and the way out bends.</returns>
    private static bool IsSharp(ConvexShape a, RigidPose poseA, ConvexShape b, RigidPose poseB, int index)
    {
        DistanceResult r = ConvexQuery.SignedDistance(a, poseA, b, poseB);
        var way = new BendingWay(a, poseA, b, poseB);
        if (r.Status != GjkStatus.Overlapping || r.Distance > -1e-3f) return false;
        double off = way.Off((Double3)r.Normal);
        if (double.IsNaN(off)) return false;
        string pair = $"{index}: {new QueryRecord(a, poseA, b, poseB)}";
        Assert.True(off <= Promise + Rounding, $"{off:G3}, {pair}");
        ConvexQuery.Contacts(a, poseA, b, poseB, 0, out ContactManifold contacts);
        double ofContacts = way.Off((Double3)contacts.Normal);
        Assert.True(ofContacts <= Promise + Rounding, $"contacts {ofContacts:G3}, {pair}");
        DistanceResult swapped = ConvexQuery.SignedDistance(b, poseB, a, poseA);
        if (Vector3.Dot(r.Normal, swapped.Normal) > -0.99f) return true;
        float moved = Math.Max((r.PointA - swapped.PointB).Length(), (r.PointB - swapped.PointA).Length());
        Assert.True(moved <= Promise * way.Size, $"moved {moved:G3}, {pair}");
        return true;
    }

    /// <summary>The kinds of shapes.</summary>
    public enum ShapeKind
    {
        /// <summary>Margin alone.</summary>
        Sphere,

        /// <summary>Of a segment.</summary>
        Capsule,

        /// <summary>Of a ball and a point.</summary>
        Tapered,

        /// <summary>Without a margin.</summary>
        Ellipsoid,

        /// <summary>With a margin.</summary>
        RoundedEllipsoid,

        /// <summary>Without a margin.</summary>
        Cylinder,

        /// <summary>Without a margin.</summary>
        Cone,

        /// <summary>Of a box.</summary>
        RoundedBox,
    }

    private static ConvexShape Shape(ShapeKind kind, Rng rng)
    {
        float x = rng.Float(0.3, 1), y = rng.Float(0.3, 1), z = rng.Float(0.3, 1);
        return kind switch
        {
            ShapeKind.Sphere => ConvexShape.Sphere(x),
            ShapeKind.Capsule => ConvexShape.Capsule(x, y),
            ShapeKind.Tapered => ConvexShape.TaperedCapsule(x, x * rng.Float(0.3, 0.95), y),
            ShapeKind.Ellipsoid => ConvexShape.Ellipsoid(new Vector3(x, y, z)),
            ShapeKind.RoundedEllipsoid => ConvexShape.Ellipsoid(new Vector3(x, y, z)).Rounded(x * 0.2f),
            ShapeKind.Cylinder => ConvexShape.Cylinder(x, y),
            ShapeKind.Cone => ConvexShape.Cone(x, y),
            _ => ConvexShape.Box(new Vector3(x, y, z)).Rounded(x * 0.2f),
        };
    }

    /// <summary>So near that they overlap along a random direction.</summary>
    private static RigidPose Beside(ConvexShape a, in RigidPose poseA, ConvexShape b, Rng rng)
    {
        Vector3 way = Vector3.Normalize(rng.Vector(-1, 1));
        var turned = new RigidPose(Quaternion.Normalize(rng.Rotation()), poseA.Position);
        double reach = new Body<ConvexShape>(a, poseA).Height((Double3)way)
            + new Body<ConvexShape>(b, turned).Height(-(Double3)way);
        return new RigidPose(turned.Rotation, poseA.Position + way * (float)(reach * rng.Range(0.4, 0.999)));
    }

    private static Double3 Gradient(Vector3 radii, RigidPose pose, Vector3 local)
    {
        var gradient = new Double3(
            local.X / ((double)radii.X * radii.X), local.Y / ((double)radii.Y * radii.Y),
            local.Z / ((double)radii.Z * radii.Z));
        return new RotationD(pose.Rotation).Rotate(gradient * (1 / gradient.Length));
    }
}
