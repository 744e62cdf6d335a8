namespace Gjk.Core;

/// <summary>Which query is made of two parts.</summary>
internal enum MotionKind : byte
{
    /// <summary>Both move along lines.</summary>
    Cast,

    /// <summary>Both move along lines and turn.</summary>
    Impact,

    /// <summary>B is a point that moves: a ray.</summary>
    Ray,
}

/// <summary>How two shapes move, and which contacts are looked for.</summary>
internal readonly struct PartMotion(
    MotionKind kind, in RigidMotion a, in RigidMotion b, float maxFraction, float tolerance, in CastOptions options)
{
    public readonly MotionKind Kind = kind;
    public readonly RigidMotion A = a, B = b;
    public readonly float MaxFraction = maxFraction, Tolerance = tolerance;
    public readonly CastOptions Options = options;

    /// <summary>The motion of B's position, relative to A's.</summary>
    public Double3 Way => (Double3)B.Velocity - A.Velocity;

    /// <summary>The rest of the motion after a fraction, with B at another pose.</summary>
    public PartMotion RestFrom(float fraction, in RigidPose poseB, in CastOptions options) => new(
        Kind, new RigidMotion(PartAdvancement.PoseAt(A, fraction), A.Velocity, A.AngularVelocity),
        new RigidMotion(poseB, B.Velocity, B.AngularVelocity), MaxFraction - fraction, Tolerance, options);

    /// <summary>A vector's length where its square may leave the range of double.</summary>
    public static double Length(in Double3 v)
    {
        double most = v.SumOfMagnitudes;
        if (!(most > 0)) return 0;
        double unit = PowerOfTwo.AtMost(most);
        return (v * (1 / unit)).Length * unit;
    }
}
