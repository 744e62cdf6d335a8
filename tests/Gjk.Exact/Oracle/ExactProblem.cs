namespace Gjk.Exact.Oracle;

/// <summary>Two posed clouds as integer vectors: the Minkowski vertex of i and j is (A[i] - B[j]) · 2^Exponent /
/// Denominator.</summary>
public sealed class ExactProblem
{
    private readonly ExactCloud _a, _b;
    private readonly Int3 _shiftB;

    /// <param name="a">The first cloud, in its own frame.</param>
    /// <param name="marginA">How far its shape reaches beyond the cloud's hull.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second cloud.</param>
    /// <param name="marginB">How far its shape reaches beyond the cloud's hull.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="shiftB">Moves B further, in the world.</param>
    public ExactProblem(
        Double3[] a, double marginA, in RigidPose poseA, Double3[] b, double marginB, in RigidPose poseB,
        in Double3 shiftB = default)
    {
        int exponent = Math.Min(
            Math.Min(Dyadic.Exponent(marginA), Dyadic.Exponent(marginB)),
            Math.Min(ExponentOf(poseA.Position), ExponentOf(poseB.Position)));
        exponent = Math.Min(exponent, ExponentOf(shiftB));
        foreach (Double3 v in a) exponent = Math.Min(exponent, ExponentOf(v));
        foreach (Double3 v in b) exponent = Math.Min(exponent, ExponentOf(v));
        Exponent = exponent == Dyadic.NoExponent ? 0 : exponent;
        var rotationA = new ExactRotation(poseA.Rotation);
        var rotationB = new ExactRotation(poseB.Rotation);
        Denominator = rotationA.Denominator * rotationB.Denominator;
        _a = new ExactCloud(a, rotationA, poseA.Position, rotationB.Denominator, Exponent);
        _b = new ExactCloud(b, rotationB, poseB.Position, rotationA.Denominator, Exponent);
        _shiftB = new Int3(
            Dyadic.ToInteger(shiftB.X, Exponent), Dyadic.ToInteger(shiftB.Y, Exponent),
            Dyadic.ToInteger(shiftB.Z, Exponent)) * Denominator;
        Margins = Dyadic.ToInteger(marginA, Exponent) + Dyadic.ToInteger(marginB, Exponent);
    }

    public int Exponent { get; }

    public BigInteger Denominator { get; }

    /// <summary>Both margins, in units of 2^Exponent.</summary>
    public BigInteger Margins { get; }

    /// <summary>The Minkowski vertex of two points.</summary>
    public Int3 Vertex(int i, int j) => _a[i] - _b[j] - _shiftB;

    /// <summary>The Minkowski vertex that is furthest in a direction, without rounding.</summary>
    public Int3 Support(in Int3 direction)
    {
        Double3 approximate = direction.ToDirection();
        return Vertex(_a.Furthest(direction, approximate), _b.Furthest(-direction, -approximate));
    }

    /// <summary>The same by looking at every point in integers.</summary>
    public Int3 SlowSupport(in Int3 direction) => SlowFurthest(_a, direction) - SlowFurthest(_b, -direction) - _shiftB;

    /// <summary>The Minkowski vertex of the first points, in the unit of the coordinates, to double rounding.</summary>
    public Double3 FirstVertex()
    {
        Int3 w = Vertex(0, 0);
        return new Double3(ToDouble(w.X), ToDouble(w.Y), ToDouble(w.Z));
    }

    /// <summary>The indices of the points that are furthest in a direction, as far as doubles can tell, and their
    /// vertex seen from the first points' one.</summary>
    public (int I, int J, Double3 FromFirst) RoughSupport(in Double3 direction)
    {
        int i = _a.Furthest(direction), j = _b.Furthest(-direction);
        return (i, j, _a.FromFirst(i) - _b.FromFirst(j));
    }

    private static Int3 SlowFurthest(ExactCloud cloud, in Int3 direction)
    {
        Int3 best = cloud[0];
        for (int i = 1; i < cloud.Count; i++)
        {
            if (Int3.Dot(cloud[i], direction) > Int3.Dot(best, direction)) best = cloud[i];
        }

        return best;
    }

    private double ToDouble(BigInteger numerator) => Dyadic.ToDouble(numerator, Denominator, Exponent);

    private static int ExponentOf(in Double3 v) =>
        Math.Min(Math.Min(Dyadic.Exponent(v.X), Dyadic.Exponent(v.Y)), Dyadic.Exponent(v.Z));
}
