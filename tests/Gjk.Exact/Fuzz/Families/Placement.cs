namespace Gjk.Exact.Fuzz.Families;

/// <summary>Puts two shapes next to each other.</summary>
internal static class Placement
{
    /// <summary>Centres within reach of each other, so that about half of the pairs overlap.</summary>
    public static FuzzPair Near(Rng random, in FuzzShape a, in FuzzShape b)
    {
        double apart = Apart(random, a, b);
        var poseA = new RigidPose(Rotations.Any(random), random.OneIn(2) ? Vector3.Zero : random.Vector(1));
        Quaternion turnB = Rotations.Any(random);
        Double3 centers = random.Direction() * apart;
        return Between(a, poseA, b, turnB, centers);
    }

    /// <summary>A distance of the centres at which about half of the pairs overlap.</summary>
    public static double Apart(Rng random, in FuzzShape a, in FuzzShape b) =>
        random.Unit() * (Radius(a) + Radius(b));

    /// <summary>Planes across a direction stand a gap apart, as nearly as the float position allows; negative gaps
    /// overlap.</summary>
    public static FuzzPair Gap(
        in FuzzShape a, in RigidPose poseA, in FuzzShape b, Quaternion turnB, in Double3 n, double gap)
    {
        var bodyA = new PosedShape(a, poseA);
        var bodyB = new PosedShape(b, new RigidPose(turnB, Vector3.Zero));
        return Between(a, poseA, b, turnB, n * (bodyA.Height(n) + bodyB.Height(-n) + gap));
    }

    /// <summary>Planes across any direction, or one across a face of A, stand any gap apart.</summary>
    public static FuzzPair Touching(Rng random, in FuzzShape a, in FuzzShape b)
    {
        var poseA = new RigidPose(Rotations.Any(random), random.OneIn(2) ? Vector3.Zero : random.Vector(1));
        return Gap(a, poseA, b, Rotations.Any(random), AnyNormal(random, a, poseA), AnyGap(random));
    }

    /// <summary>B in any direction, so near that about half of the pairs overlap.</summary>
    public static FuzzPair Meeting(Rng random, in FuzzShape a, in RigidPose poseA, in FuzzShape b)
    {
        double apart = Apart(random, a, b);
        return Between(a, poseA, b, Rotations.Any(random), random.Direction() * apart);
    }

    /// <summary>B with its centre a vector from A's, both in world axes.</summary>
    public static FuzzPair Between(
        in FuzzShape a, in RigidPose poseA, in FuzzShape b, Quaternion turnB, in Double3 centers)
    {
        var bodyA = new PosedShape(a, poseA);
        var bodyB = new PosedShape(b, new RigidPose(turnB, Vector3.Zero));
        Double3 position = bodyA.Position + bodyA.Rotate(bodyA.Center) + centers - bodyB.Rotate(bodyB.Center);
        return new FuzzPair(a, poseA, b, new RigidPose(turnB, (Vector3)position));
    }

    /// <summary>From 1e-15 to 0.1, of either sign, or none at all.</summary>
    public static double AnyGap(Rng random) =>
        random.OneIn(8) ? 0 : random.Sign() * random.Magnitude(1e-15, 0.1);

    /// <summary>Any direction of the world, or one across a face of A.</summary>
    public static Double3 AnyNormal(Rng random, in FuzzShape a, in RigidPose poseA) =>
        random.OneIn(2) ? random.Direction() : FaceNormal(random, new PosedShape(a, poseA));

    /// <summary>Across a face of a mesh, in the world; any direction for what has none.</summary>
    public static Double3 FaceNormal(Rng random, PosedShape body)
    {
        Double3[] faces = [.. body.FaceNormals(8)];
        return faces.Length == 0 ? random.Direction() : body.Rotate(faces[random.Below(faces.Length)]);
    }

    private static double Radius(in FuzzShape shape) => new PosedShape(shape, RigidPose.Identity).Radius;
}
