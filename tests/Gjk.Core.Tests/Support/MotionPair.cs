namespace Gjk.Core.Tests.Support;

/// <summary>Two shapes that move and turn; its text is C# that makes the query again.</summary>
internal sealed record MotionPair(
    string Name, TestShape A, RigidMotion MotionA, TestShape B, RigidMotion MotionB, float Tolerance = 0)
{
    public double Scale => Math.Max(A.LongestSide, B.LongestSide);

    /// <summary>What the query promises where the caller asks for nothing else.</summary>
    public double Promised => Tolerance > 0 ? Tolerance : 1e-5 * Scale;

    /// <summary>Upper bound of the speed of a point of one shape, seen from a point of the other.</summary>
    public double Speed =>
        (MotionB.Velocity - MotionA.Velocity).Length() + Around(A, MotionA) + Around(B, MotionB);

    public MotionPair Swapped => new(Name + " swapped", B, MotionB, A, MotionA, Tolerance);

    public CastResult Ask(float maxFraction = 1) =>
        ConvexQuery.TimeOfImpact(A.Shape, MotionA, B.Shape, MotionB, Tolerance, maxFraction);

    /// <summary>The same pair with every length multiplied.</summary>
    public MotionPair Resized(float factor) => new(
        $"{Name} x {factor:R}", A.Scaled(new Vector3(factor)), Resized(MotionA, factor),
        B.Scaled(new Vector3(factor)), Resized(MotionB, factor), Tolerance * factor);

    /// <summary>The same pair elsewhere.</summary>
    public MotionPair Shifted(Vector3 way) => this with
    {
        MotionA = Shifted(MotionA, way),
        MotionB = Shifted(MotionB, way),
    };

    public override string ToString() =>
        $"{Name}: ConvexQuery.TimeOfImpact({A}, {T(MotionA)}, {B}, {T(MotionB)}, {TestShape.T(Tolerance)})";

    private static string T(in RigidMotion m) =>
        $"new RigidMotion({TestShape.T(m.Pose)}, {TestShape.T(m.Velocity)}, {TestShape.T(m.AngularVelocity)})";

    private static double Around(TestShape shape, in RigidMotion motion) =>
        motion.AngularVelocity.Length() * (shape.Shape.Center.Length + shape.Shape.BoundingRadius);

    private static RigidMotion Resized(in RigidMotion m, float factor) => new(
        new RigidPose(m.Pose.Rotation, m.Pose.Position * factor), m.Velocity * factor, m.AngularVelocity);

    private static RigidMotion Shifted(in RigidMotion m, Vector3 way) => new(
        new RigidPose(m.Pose.Rotation, m.Pose.Position + way), m.Velocity, m.AngularVelocity);
}
