namespace Gjk.Core.Tests.Support;

/// <summary>A half-space and a shape somewhere near its plane, with the exact distance.</summary>
internal sealed record HalfSpaceSetup(
    Vector3 Normal, float Offset, RigidPose Pose, TestShape Other, RigidPose OtherPose)
{
    public ConvexShape Plane { get; } = ConvexShape.HalfSpace(Normal, Offset);

    /// <summary>Random, at any distance from the plane, touching it but for rounding now and then, up to a hundred
    /// thousand sizes beside the origin of the half-space.</summary>
    public static HalfSpaceSetup Random(Rng rng, string kind, double far = 1e5)
    {
        TestShape other = Generators.Shape(rng, kind);
        Vector3 normal = rng.UnitVector() * rng.LogFloat(0.1, 10);
        float offset = rng.Float(-2, 2);
        var pose = new RigidPose(rng.Rotation(), rng.Vector(-3, 3));
        var otherPose = new RigidPose(rng.Rotation(), rng.UnitVector() * rng.LogFloat(1e-2, Math.Max(far, 1)));
        var random = new HalfSpaceSetup(normal, offset, pose, other, otherPose);
        if (rng.Below(4) == 0) return random;
        float gap = rng.Below(2) == 0 ? 0 : rng.LogFloat(1e-7, 2) * (rng.Below(2) == 0 ? 1 : -1);
        DistanceResult at = random.SignedDistance();
        return random with
        {
            OtherPose = new RigidPose(otherPose.Rotation, otherPose.Position - at.Normal * (at.Distance - gap)),
        };
    }

    public DistanceResult Distance() => ConvexQuery.Distance(Plane, Pose, Other.Shape, OtherPose);

    public DistanceResult SignedDistance() => ConvexQuery.SignedDistance(Plane, Pose, Other.Shape, OtherPose);

    /// <summary>The signed distance of a polytope, all but the normal's length in fractions.</summary>
    public double ExactGap()
    {
        ExactPose pose = new(Pose), otherPose = new(OtherPose);
        Fraction[] origin = pose.Place(default);
        Fraction[] normal = [.. pose.Place(Normal).Select((x, i) => x - origin[i])];
        Fraction least = 0;
        bool isFirst = true;
        foreach (Double3 vertex in Other.Vertices!)
        {
            Fraction[] at = otherPose.Place(vertex);
            Fraction gap = -Offset;
            for (int i = 0; i < 3; i++) gap += normal[i] * (at[i] - origin[i]);
            if (isFirst || (gap - least).Sign < 0) least = gap;
            isFirst = false;
        }

        return ToDouble(least) / ((Double3)Normal).Length - Other.Margin;
    }

    /// <summary>The outward normal in the other's axes, and how high its local origin is over the plane.</summary>
    public Double3 OutwardInOther(out double height)
    {
        Double3 unit = (Double3)Normal * (1 / ((Double3)Normal).Length);
        Double3 outward = new RotationD(Pose.Rotation).Rotate(unit);
        height = Double3.Dot(outward, (Double3)OtherPose.Position - Pose.Position) - Offset / ((Double3)Normal).Length;
        return new RotationD(OtherPose.Rotation).InverseRotate(outward);
    }

    private static double ToDouble(Fraction value)
    {
        const int bits = 1200;
        BigInteger shifted = (value.Numerator << bits) / value.Denominator;
        return Dyadic.ToDouble(shifted, -bits);
    }
}
