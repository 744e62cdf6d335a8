namespace Gjk.Core.Tests.Support;

/// <summary>Seeded pairs that move and turn, up to ten turns, about half of which meet.</summary>
internal static class MotionFamilies
{
    /// <summary>Radians: ten turns.</summary>
    private const double MostTurn = 20 * Math.PI;

    public static readonly string[] Names =
    [
        "boxes", "hulls", "plates", "rounds", "cylinders", "ellipsoids", "needles", "offCentre", "parallelAxes",
        "alike", "grazing", "bullets", "spinning", "slow", "mixed", "uneven", "faces", "edges", "tops",
    ];

    public static MotionPair Pair(string family, ulong seed)
    {
        var rng = new Rng(seed * 64 + (ulong)Array.IndexOf(Names, family));
        (TestShape a, TestShape b) = (Shape(rng, family), Shape(rng, family));
        if (family == "uneven") b = b.Scaled(new Vector3(rng.LogFloat(1e-3, 0.1)));
        Vector3 turnA = Turn(rng), turnB = rng.Below(3) == 0 ? default : Turn(rng);
        if (family == "parallelAxes") turnB = turnA * rng.Float(-2, 1);
        if (family == "alike") turnB = turnA;
        if (family == "slow") (turnA, turnB) = (turnA * 0.01f, turnB * 0.01f);
        double reach = Reach(a) + Reach(b);
        Vector3 direction = rng.UnitVector();
        float apart = (float)(reach * (family == "bullets" ? rng.LogFloat(10, 1e6) : rng.Range(0.7, 3)));
        Vector3 from = direction * apart, aside = rng.UnitVector() * (float)(reach * Math.Sqrt(rng.Unit()) * 0.6);
        Vector3 velocity = (aside - from) * rng.Float(0.5, 2);
        if (family is "spinning" or "tops") velocity = rng.UnitVector() * (float)(reach * rng.Range(0, 0.2));
        RigidPose poseA = Pose(rng, a, rng.Vector(-1, 1)), turned = Pose(rng, b, Vector3.Zero);
        Vector3 position = Meeting(poseA, a) + from - Meeting(turned, b);
        if (family is "grazing" or "faces" or "edges" or "tops" or "slow" or "spinning")
        {
            position = Near(rng, family, a, ref poseA, b, ref turned, direction);
            if (family is "tops") (turnA, turnB) = (direction * turnA.Length(), direction * turnB.Length());
            if (family is "grazing") velocity = Vector3.Cross(direction, rng.UnitVector()) * (float)reach;
            if (family is "faces" or "edges" or "slow")
                velocity = (rng.Vector(-1, 1) - direction) * (float)reach * 0.3f;
        }

        Vector3 velocityA = rng.Below(2) == 0 ? default : rng.Vector(-3, 3);
        return new MotionPair(
            $"{family} {seed}", a, new RigidMotion(poseA, velocityA, turnA), b,
            new RigidMotion(new RigidPose(turned.Rotation, position), velocity + velocityA, turnB));
    }

    private static TestShape Shape(Rng rng, string family) => family switch
    {
        "boxes" or "faces" or "edges" or "tops" => Generators.Shape(rng, "box"),
        "hulls" or "uneven" => Generators.Shape(rng, rng.Below(2) == 0 ? "hull" : "bigHull"),
        "plates" => rng.Below(2) == 0
            ? TestShape.Box(new Vector3(1, 5e-4f, rng.Float(0.3, 1)))
            : Generators.Shape(rng, rng.Below(2) == 0 ? "plate" : "box"),
        "rounds" => Generators.Shape(rng, rng.Below(2) == 0 ? "capsule" : "sphere"),
        "cylinders" => Generators.Shape(rng, rng.Below(2) == 0 ? "cylinder" : "cone"),
        "ellipsoids" => Generators.Shape(rng, rng.Below(2) == 0 ? "ellipsoid" : "hull"),
        "needles" => Generators.Shape(rng, rng.Below(2) == 0 ? "needle" : "box"),
        "offCentre" => OffCentre(rng),
        _ => Generators.Shape(rng, Generators.AllKinds[1 + rng.Below(Generators.AllKinds.Length - 1)]),
    };

    private static TestShape OffCentre(Rng rng)
    {
        Vector3 way = rng.UnitVector() * rng.LogFloat(0.5, 20);
        return TestShape.Mesh([.. Clouds.InBox(rng, 4 + rng.Below(13), Vector3.One).Select(p => p + way)]);
    }

    private static Vector3 Turn(Rng rng) => rng.UnitVector() * rng.LogFloat(0.03, MostTurn);

    private static double Reach(TestShape shape) => shape.Shape.BoundingRadius;

    /// <summary>Where the shape's middle is, from its position.</summary>
    private static Vector3 Meeting(in RigidPose pose, TestShape shape) =>
        (Vector3)new Body<ConvexShape>(shape.Shape, pose).Rotate(shape.Shape.Center);

    private static RigidPose Pose(Rng rng, TestShape shape, Vector3 position) => new(rng.Rotation(), position);

    /// <summary>A place for B beside A across a direction, with a gap between 1e-7 and 1; faces lie flat on each other,
    /// edges cross.</summary>
    private static Vector3 Near(
        Rng rng, string family, TestShape a, ref RigidPose poseA, TestShape b, ref RigidPose poseB, Vector3 direction)
    {
        if (family is "faces" or "tops")
        {
            Quaternion up = FromTo(direction);
            poseA = new RigidPose(up, poseA.Position);
            poseB = new RigidPose(
                Quaternion.Normalize(up * Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(0, 6))), default);
        }
        else if (family is "edges")
        {
            Quaternion up = FromTo(direction), tilt = Quaternion.CreateFromAxisAngle(Vector3.UnitX, 0.7f);
            poseA = new RigidPose(Quaternion.Normalize(up * tilt), poseA.Position);
            poseB = new RigidPose(
                Quaternion.Normalize(up * Quaternion.CreateFromAxisAngle(Vector3.UnitY, 1.5f) * tilt), default);
        }

        var bodyA = new Body<ConvexShape>(a.Shape, poseA);
        var bodyB = new Body<ConvexShape>(b.Shape, poseB);
        double apart = bodyA.Height(direction) + bodyB.Height(-direction) + rng.LogFloat(1e-7, 1);
        return (Vector3)(poseA.Position + (Double3)direction * apart);
    }

    private static Quaternion FromTo(Vector3 direction)
    {
        Vector3 axis = Vector3.Cross(Vector3.UnitY, direction);
        float sine = axis.Length();
        return sine < 1e-3f
            ? Quaternion.Identity
            : Quaternion.CreateFromAxisAngle(axis / sine, MathF.Atan2(sine, direction.Y));
    }
}
