namespace Gjk.Core.Tests.Support;

/// <summary>Two posed shapes; its text is C# that makes the query again.</summary>
internal sealed record TestPair(string Name, TestShape A, RigidPose PoseA, TestShape B, RigidPose PoseB)
{
    /// <summary>As contract 6 has it: the longest side of the local boxes, scale applied, the larger of the
    /// two.</summary>
    public double Scale => Math.Max(A.LongestSide, B.LongestSide);

    /// <summary>How far its distance may be off.</summary>
    public double Band(double distance) =>
        IsPolytope ? Accuracy.Band(distance, Scale) : Accuracy.CurvedBand(distance, Scale);

    public bool IsPolytope => A.Vertices is not null && B.Vertices is not null;

    public TestPair Swapped => new(Name + " swapped", B, PoseB, A, PoseA);

    /// <summary>The same pair with every length multiplied.</summary>
    public TestPair Resized(float factor) => new(
        $"{Name} x {factor:R}",
        A.Scaled(new Vector3(factor)),
        new RigidPose(PoseA.Rotation, PoseA.Position * factor),
        B.Scaled(new Vector3(factor)),
        new RigidPose(PoseB.Rotation, PoseB.Position * factor));

    public DistanceResult Distance(float maxDistance = float.PositiveInfinity) =>
        ConvexQuery.Distance(A.Shape, PoseA, B.Shape, PoseB, maxDistance);

    public DistanceResult SignedDistance() => ConvexQuery.SignedDistance(A.Shape, PoseA, B.Shape, PoseB);

    public bool Overlaps() => ConvexQuery.Overlaps(A.Shape, PoseA, B.Shape, PoseB);

    public ExactAnswer Exact() => ExactOracle.Solve(A.Vertices!, A.Margin, PoseA, B.Vertices!, B.Margin, PoseB);

    public override string ToString() =>
        $"{Name}: ConvexQuery.Distance({A}, {TestShape.T(PoseA)}, {B}, {TestShape.T(PoseB)})";
}
