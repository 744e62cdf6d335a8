namespace Gjk.Core.Tests.Support;

/// <summary>Seeded random shapes, poses and pairs. Sizes are about 1 unless a scale is asked for.</summary>
internal static class Generators
{
    /// <summary>Every kind of polytope, with and without margin: what the exact oracle can judge.</summary>
    public static readonly string[] PolytopeKinds =
    [
        "point", "segment", "triangle", "sphere", "capsule", "box", "hull", "flat", "needle", "plate", "scaledHull",
        "scaledBox", "mirroredCapsule",
    ];

    public static readonly string[] CurvedKinds =
    [
        "cylinder", "cone", "ellipsoid", "scaledCylinder", "scaledCone", "scaledCapsule", "scaledSphere",
    ];

    /// <summary>Curved kinds that no random set draws, so that the sets stay what they were; theories ask each of
    /// them.</summary>
    public static readonly string[] LaterKinds = ["taperedCapsule", "scaledTaperedCapsule"];

    /// <summary>Meshes as people and programs make them, plain, far from their own origin, and scaled back to the size
    /// that they were divided by.</summary>
    public static readonly string[] MadeKinds = ["made", "made", "madeFarOff", "madeUneven"];

    public static readonly string[] AllKinds = [.. PolytopeKinds, .. CurvedKinds];

    public static TestShape Shape(Rng rng, string kind) => kind switch
    {
        "point" => TestShape.Point(),
        "segment" => TestShape.Segment(rng.Vector(-1, 1), rng.Vector(-1, 1)),
        "triangle" => TestShape.Triangle(rng.Vector(-1, 1), rng.Vector(-1, 1), rng.Vector(-1, 1)),
        "sphere" => TestShape.Sphere(rng.Float(0.1, 1)),
        "capsule" => TestShape.Capsule(rng.Float(0.1, 0.5), rng.Float(0.1, 1)),
        "box" => TestShape.Box(rng.Vector(0.1, 1)),
        "cylinder" => TestShape.Cylinder(rng.Float(0.1, 1), rng.Float(0.1, 1)),
        "cone" => TestShape.Cone(rng.Float(0.1, 1), rng.Float(0.1, 1)),
        "ellipsoid" => TestShape.Ellipsoid(rng.Vector(0.2, 1)),
        "taperedCapsule" => Tapered(rng),
        "hull" => TestShape.Mesh(Clouds.InBox(rng, 4 + rng.Below(13), Vector3.One)),
        "bigHull" => TestShape.Mesh(Clouds.InBox(rng, 32 + rng.Below(33), Vector3.One)),
        "flat" => TestShape.Mesh(Clouds.InBox(rng, 3 + rng.Below(8), new Vector3(1, 0, 1))),
        "needle" => TestShape.Mesh(Clouds.InBox(rng, 4 + rng.Below(9), new Vector3(1, 1e-3f, 1e-3f))),
        "plate" => TestShape.Mesh(Clouds.InBox(rng, 4 + rng.Below(9), new Vector3(1, 1e-3f, 1))),
        "scaledHull" => Shape(rng, "hull").Scaled(Signs(rng, rng.Vector(0.3, 2))),
        "scaledBox" => Shape(rng, "box").Scaled(Signs(rng, rng.Vector(0.3, 2))),
        "mirroredCapsule" => Shape(rng, "capsule").Scaled(Signs(rng, new Vector3(rng.Float(0.3, 2)))),
        "scaledCylinder" => Shape(rng, "cylinder").Scaled(Signs(rng, rng.Vector(0.3, 2))),
        "scaledCone" => Shape(rng, "cone").Scaled(Signs(rng, rng.Vector(0.3, 2))),
        "scaledCapsule" => Shape(rng, "capsule").Scaled(Signs(rng, rng.Vector(0.3, 2))),
        "scaledSphere" => Shape(rng, "sphere").Scaled(Signs(rng, rng.Vector(0.3, 2))),
        "scaledTaperedCapsule" => Shape(rng, "taperedCapsule").Scaled(Signs(rng, rng.Vector(0.3, 2))),
        "made" => TestShape.Mesh(Made(rng)),
        "madeFarOff" => TestShape.Mesh(FarOff(rng, Made(rng))),
        "madeUneven" => Uneven(rng, Made(rng)),
        _ => throw new ArgumentException("No such kind.", nameof(kind)),
    };

    /// <summary>With unequal balls, nearly equal ones, one that the other nearly holds, and one or both that are nearly
    /// nothing.</summary>
    private static TestShape Tapered(Rng rng)
    {
        float top = rng.Float(0.1, 0.7), little = rng.LogFloat(1e-7, 0.1), half = rng.Float(0.1, 1);
        return rng.Below(6) switch
        {
            0 => TestShape.TaperedCapsule(top, top * (1 + little), half),
            1 => TestShape.TaperedCapsule(top, top / 2, top / 4 * (1 + little)),
            2 => TestShape.TaperedCapsule(top, 0, top / 2 + half),
            3 => TestShape.TaperedCapsule(little, top, top / 2 + half),
            4 => TestShape.TaperedCapsule(little, little * rng.Float(0, 1), half),
            _ => TestShape.TaperedCapsule(top, rng.Float(0, 0.7), half),
        };
    }

    public static RigidPose Pose(Rng rng, Vector3 position) => new(rng.Rotation(), position);

    /// <summary>Two shapes at random whose centres are within a part of the sum of their radii, so that about half of
    /// them overlap.</summary>
    public static TestPair Pair(ulong seed, string[] kinds, double spread = 1.0)
    {
        var rng = new Rng(seed);
        TestShape a = Shape(rng, kinds[rng.Below(kinds.Length)]), b = Shape(rng, kinds[rng.Below(kinds.Length)]);
        double distance = rng.Range(0, spread) * (a.Reach + b.Reach);
        RigidPose poseA = Pose(rng, rng.Vector(-1, 1));
        RigidPose poseB = Pose(rng, poseA.Position + rng.UnitVector() * (float)distance);
        return new TestPair($"seed {seed}", a, poseA, b, poseB);
    }

    /// <summary>Made meshes whose centres, wherever they are in the local frames, are within reach of each other, or
    /// whose planes across one direction stand a gap apart.</summary>
    public static TestPair MadePair(ulong seed, double? gap = null)
    {
        var rng = new Rng(seed);
        TestShape a = Shape(rng, MadeKinds[rng.Below(MadeKinds.Length)]);
        TestShape b = rng.Below(4) == 0 ? Shape(rng, "hull") : Shape(rng, MadeKinds[rng.Below(MadeKinds.Length)]);
        RigidPose poseA = Pose(rng, rng.Vector(-1, 1)), turned = Pose(rng, Vector3.Zero);
        Body<ConvexShape> bodyA = new(a.Shape, poseA), bodyB = new(b.Shape, turned);
        Double3 n = rng.UnitVector(), centerA = bodyA.Rotate(a.Shape.Center), centerB = bodyB.Rotate(b.Shape.Center);
        n *= 1 / n.Length;
        double apart = gap is { } g
            ? bodyA.Height(n) - Double3.Dot(n, centerA) + bodyB.Height(-n) + Double3.Dot(n, centerB) + g
            : rng.Range(0, 0.7) * (a.LongestSide + b.LongestSide);
        return new TestPair(
            $"seed {seed}", a, poseA, b,
            new RigidPose(turned.Rotation, (Vector3)(poseA.Position + centerA + n * apart - centerB)));
    }

    /// <summary>A pair whose planes across one direction stand a given gap apart (to the rounding of the position),
    /// negative for shallow overlaps.</summary>
    public static TestPair NearPair(ulong seed, string[] kinds, double gap)
    {
        var rng = new Rng(seed);
        TestShape a = Shape(rng, kinds[rng.Below(kinds.Length)]), b = Shape(rng, kinds[rng.Below(kinds.Length)]);
        RigidPose poseA = Pose(rng, rng.Vector(-1, 1)), turned = Pose(rng, Vector3.Zero);
        Double3 n = rng.UnitVector();
        n *= 1 / n.Length;
        Body<ConvexShape> bodyA = new(a.Shape, poseA), bodyB = new(b.Shape, turned);
        double apart = bodyA.Height(n) + bodyB.Height(-n) + gap;
        return new TestPair(
            $"seed {seed} gap {gap:R}", a, poseA, b,
            new RigidPose(turned.Rotation, (Vector3)(poseA.Position + n * apart)));
    }

    private static Vector3[] Made(Rng rng) => MadeMeshes.Any(new Rng(rng.Next()));

    /// <summary>Ten to ten million sizes from its own origin.</summary>
    private static Vector3[] FarOff(Rng rng, Vector3[] cloud) =>
        Clouds.Placed(cloud, 1, rng.UnitVector() * rng.LogFloat(10, 1e7));

    /// <summary>By powers of two from 2^-24 to 2^24, some of them negative.</summary>
    private static TestShape Uneven(Rng rng, Vector3[] cloud)
    {
        Vector3 scale = Signs(rng, new Vector3(Power(), Power(), Power()));
        return TestShape.Mesh([.. cloud.Select(p => p / scale)]).Scaled(scale);

        float Power() => MathF.ScaleB(1, rng.Below(49) - 24);
    }

    private static Vector3 Signs(Rng rng, Vector3 v) =>
        new(rng.Below(2) == 0 ? v.X : -v.X, rng.Below(2) == 0 ? v.Y : -v.Y, rng.Below(2) == 0 ? v.Z : -v.Z);
}
