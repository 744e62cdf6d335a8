using System.Runtime.InteropServices;

namespace Gjk.Core.Tests.Regression;

/// <summary>An infinite stored normal made every query of a pair with a curved shape end with InvalidShape, for ever:
/// the query failed and left the normal in place.</summary>
public class WarmStartContentTests
{
    public static TheoryData<float> StrangeNumbers =>
        [float.PositiveInfinity, float.NegativeInfinity, float.NaN, float.MaxValue, float.Epsilon, 1e30f, 0];

    [Theory]
    [MemberData(nameof(StrangeNumbers))]
    public void AStrangeStoredNormalIsOnlyAWrongGuess(float number)
    {
        var pose = new RigidPose(new Vector3(3, 0.5f, 0.25f));
        ConvexShape[] shapes =
            [ConvexShape.Cylinder(1, 1), ConvexShape.Cone(1, 1), ConvexShape.Ellipsoid(new Vector3(1, 0.5f, 0.7f))];
        foreach (ConvexShape curved in shapes)
        {
            DistanceResult cold = ConvexQuery.Distance(curved, RigidPose.Identity, ConvexShape.Cylinder(0.5f, 1), pose);
            for (int component = 0; component < 3; component++)
            {
                WarmStart warm = WithNormal(component, number);
                for (int call = 0; call < 3; call++)
                {
                    DistanceResult r = ConvexQuery.Distance(
                        curved, RigidPose.Identity, ConvexShape.Cylinder(0.5f, 1), pose, ref warm);
                    Assert.True(
                        r.Status == GjkStatus.Separated && Math.Abs(r.Distance - cold.Distance) <= 1e-6,
                        $"component {component}, call {call}: {r.Status} {r.Distance:R}");
                }
            }
        }
    }

    [Fact]
    public void AFailedQueryLeavesAColdStart()
    {
        var broken = BrokenShape.OfNaN;
        WarmStart warm = WithNormal(0, 1);
        DistanceResult r = ConvexQuery.Distance(
            broken, RigidPose.Identity, ConvexShape.Cylinder(0.5f, 1), new RigidPose(new Vector3(3, 0, 0)), ref warm);
        Assert.Equal(GjkStatus.InvalidShape, r.Status);
        Assert.True(MemoryMarshal.AsBytes(new ReadOnlySpan<WarmStart>(ref warm)).IndexOfAnyExcept((byte)0) < 0);
    }

    /// <summary>No vertices, and a normal with one component given, as the last twelve bytes hold it.</summary>
    private static WarmStart WithNormal(int component, float number)
    {
        Span<byte> bytes = stackalloc byte[48];
        bytes.Clear();
        Span<float> normal = MemoryMarshal.Cast<byte, float>(bytes)[9..];
        normal.Fill(0.1f);
        normal[component] = number;
        return MemoryMarshal.Read<WarmStart>(bytes);
    }
}
