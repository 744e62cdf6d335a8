namespace Gjk.Core.Tests.Support.Rays;

/// <summary>What a ray truly meets.</summary>
internal readonly record struct TrueHit(
    CastStatus Status, double Distance, double Exit, Double3 Normal, bool IsNormalUnique);

/// <summary>A shape with the body that it is, and the scale that makes it of the body.</summary>
internal sealed record RayShape(
    string Text, ConvexShape Shape, RayBodyReference Body, Vector3 Factors, double Scale)
{
    /// <summary>Lengths in which a normal beside another one counts as the same point of the surface.</summary>
    private const double NearEdge = 1e-8;

    /// <summary>The closed interval of the ray in the body, in world units, and what that makes of the ray.</summary>
    public TrueHit Cast(RigidPose pose, Vector3 origin, Vector3 direction, double reach)
    {
        FixedVector o = ToLocal(pose, (FixedVector)origin - pose.Position), d = ToLocal(pose, direction);
        d = new FixedVector(d.X / d.Length, d.Y / d.Length, d.Z / d.Length);
        Crossing[] crossings =
        [
            .. Body.Crossings(FixedVector.Divide(o, Factors), FixedVector.Divide(d, Factors)).OrderBy(c => c.T.Raw),
        ];
        if (crossings.Length == 0) return new(CastStatus.Miss, double.NaN, double.NaN, default, false);
        double enter = (double)crossings[0].T, exit = (double)crossings[^1].T;
        CastStatus status = crossings[^1].T.Sign < 0 ? CastStatus.Miss
            : crossings[0].T.Sign <= 0 ? CastStatus.OverlappingAtStart
            : enter <= reach ? CastStatus.Hit : CastStatus.Miss;
        Double3 normal = Normal(pose, crossings[0]);
        bool isUnique = crossings.TakeWhile(c => (double)(c.T - crossings[0].T) <= NearEdge * Scale)
            .All(c => (Normal(pose, c) - normal).Length <= 1e-8);
        return new(status, enter, exit, normal, isUnique);
    }

    private Double3 Normal(in RigidPose pose, Crossing crossing)
    {
        Double3 local = FixedVector.Divide(crossing.Normal, Factors).Unit;
        return new RotationD(pose.Rotation).Rotate(local);
    }

    private static FixedVector ToLocal(in RigidPose pose, FixedVector v)
    {
        Fixed x = pose.Rotation.X, y = pose.Rotation.Y, z = pose.Rotation.Z, w = pose.Rotation.W;
        FixedVector u = new(-x, -y, -z);
        Fixed two = 2.0, norm = x * x + y * y + z * z + w * w;

        // v + 2 u × (u × v + w v) / |q|², with the conjugate's u.
        FixedVector inner = FixedVector.Cross(u, v) + v * w;
        return v + FixedVector.Cross(u, inner) * (two / norm);
    }
}

/// <summary>Shapes at random with their bodies.</summary>
internal static class RayShapes
{
    public static readonly string[] Kinds =
        ["sphere", "capsule", "box", "cylinder", "cone", "ellipsoid", "hull", "triangleHull"];

    public static RayShape Make(Rng rng, string kind, Vector3 size)
    {
        switch (kind)
        {
            case "sphere":
                float r = size.X * rng.Float(0.3, 1);
                return New($"sphere {r:R}", ConvexShape.Sphere(r), new CapsuleReference(default, default, r), 2 * r);
            case "capsule":
                float cr = size.X * rng.Float(0.3, 1), ch = size.Y * rng.Float(0.3, 1);
                return New(
                    $"capsule {cr:R} {ch:R}", ConvexShape.Capsule(cr, ch),
                    new CapsuleReference(new(0, ch, 0), new(0, -(double)ch, 0), cr), 2 * (cr + ch));
            case "box":
                Vector3 half = size * rng.Vector(0.3, 1);
                return New(
                    $"box {half}", ConvexShape.Box(half), Polytope(TestShape.Corners(half)), 2 * Largest(half));
            case "cylinder":
                float yr = size.X * rng.Float(0.3, 1), yh = size.Y * rng.Float(0.3, 1);
                return New(
                    $"cylinder {yr:R} {yh:R}", ConvexShape.Cylinder(yr, yh), new CylinderReference(yr, yh),
                    2 * Math.Max(yr, yh));
            case "cone":
                float nr = size.X * rng.Float(0.3, 1), nh = size.Y * rng.Float(0.3, 1);
                return New(
                    $"cone {nr:R} {nh:R}", ConvexShape.Cone(nr, nh), new ConeReference(nr, nh), 2 * Math.Max(nr, nh));
            case "ellipsoid":
                Vector3 radii = size * rng.Vector(0.3, 1);
                return New(
                    $"ellipsoid {radii}", ConvexShape.Ellipsoid(radii), new EllipsoidReference(radii),
                    2 * Largest(radii));
            default:
                Vector3[] cloud = Clouds.InBox(rng, kind == "hull" ? 8 + rng.Below(3) : 4, size);
                return New(
                    $"hull {string.Join(" ", cloud)}", ConvexShape.Mesh(cloud), Polytope(cloud), 2 * Largest(size));
        }
    }

    /// <summary>The same scaled, which the reference divides the ray by.</summary>
    public static RayShape Scaled(RayShape shape, Vector3 factors) => shape with
    {
        Text = $"{shape.Text} scaled by {factors}",
        Shape = shape.Shape.Scaled(factors),
        Factors = factors,
        Scale = shape.Scale * Largest(factors),
    };

    private static RayShape New(string text, ConvexShape shape, RayBodyReference body, double scale) =>
        new(text, shape, body, Vector3.One, scale);

    private static PolytopeReference Polytope(IEnumerable<Vector3> corners) =>
        new([.. corners.Select(c => (Double3)c)]);

    private static float Largest(Vector3 v) => Math.Max(Math.Max(Math.Abs(v.X), Math.Abs(v.Y)), Math.Abs(v.Z));
}
