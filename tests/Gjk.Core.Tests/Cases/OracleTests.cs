using System;
using System.Linq;
using System.Numerics;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Cases;

/// <summary>The oracle is held to the case files, whose answers were computed by other means, before anything is held to the oracle.</summary>
public class OracleTests
{
    /// <summary>The hulls of the dense family take the oracle a second each.</summary>
    private const int MostVertices = 200;

    public static TheoryData<string> Families => [.. CaseFamily.Names];

    [Theory]
    [MemberData(nameof(Families))]
    public void TheOracleAgreesWithTheCaseFiles(string family)
    {
        HardCase[] small = [.. CaseFamily.Load(family).Cases.Where(c => c.Pair.A.Vertices!.Length + c.Pair.B.Vertices!.Length <= MostVertices)];
        int stride = Math.Max(1, small.Length / Budget.Count(60));
        for (int i = 0; i < small.Length; i += stride)
        {
            ExactAnswer answer = small[i].Pair.Exact();
            Assert.True(answer.Overlap == small[i].Overlap, $"{small[i].Pair.Name}: oracle {answer}, file {small[i].Overlap}");

            // 2^-52: both were rounded to double once.
            Assert.True(Math.Abs(answer.Distance - small[i].Distance) <= 2.3e-16 * answer.Distance, $"{small[i].Pair.Name}: oracle {answer.Distance:R}, file {small[i].Distance:R}");
        }
    }

    [Fact]
    public void ClosedForms()
    {
        static RigidPose At(float x, float y, float z) => new(new Vector3(x, y, z));
        Assert.Equal(new ExactAnswer(false, 4), new TestPair("", TestShape.Sphere(1), At(0, 0, 0), TestShape.Sphere(0), At(3, 4, 0)).Exact());
        Assert.Equal(new ExactAnswer(true, 0), new TestPair("", TestShape.Sphere(2), At(0, 0, 0), TestShape.Sphere(3), At(3, 4, 0)).Exact());
        TestPair justApart = new("", TestShape.Sphere(2), At(0, 0, 0), TestShape.Sphere(MathF.BitDecrement(3)), At(3, 4, 0));
        Assert.Equal(new ExactAnswer(false, 3.0 - MathF.BitDecrement(3)), justApart.Exact());
        Assert.Equal(new ExactAnswer(false, Math.Sqrt(3)), new TestPair("", TestShape.Box(Vector3.One), At(0, 0, 0), TestShape.Point(), At(2, -2, 2)).Exact());

        // A rotation by 90 degrees from a quaternion that is not of unit length: (0, 0, 1, 1) / 1.4142 in floats.
        var quarter = new RigidPose(new Quaternion(0, 0, 0.7071f, 0.7071f), Vector3.Zero);
        var segment = TestShape.Segment(new Vector3(1, 0, 0), new Vector3(3, 0, 0));
        Assert.Equal(new ExactAnswer(false, 1), new TestPair("", segment, quarter, TestShape.Point(), At(0, 0, 0)).Exact());
        Assert.Equal(new ExactAnswer(false, 2), new TestPair("", segment, quarter, TestShape.Point(), At(0, 5, 0)).Exact());
    }

    [Fact]
    public void DepthAgreesWithTheCaseFiles()
    {
        HardCase[] small = [.. CaseFamily.Load("deep").Cases.Where(c => c.Overlap && c.Pair.A.Vertices!.Length <= 8 && c.Pair.B.Vertices!.Length <= 8).Take(20)];
        Assert.True(small.Length > 5);
        foreach (HardCase c in small)
        {
            double depth = Depth.Of(c.Pair);
            Assert.True(Math.Abs(depth - c.Depth) <= 1e-14 * c.Pair.Scale, $"{c.Pair.Name}: {depth:R}, file {c.Depth:R}");
        }
    }
}
