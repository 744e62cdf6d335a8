namespace Gjk.Core.Tests.Cases;

/// <summary>The oracle is held to the case files, whose answers were computed by other means, before anything is held
/// to the oracle.</summary>
public class OracleTests
{
    /// <summary>Keeps the thousands of vertices of the dense family out of the slow comparison of supports.</summary>
    private const int MostVertices = 200;

    public static TheoryData<string> Families => [.. CaseFamily.Names];

    [Theory]
    [MemberData(nameof(Families))]
    public void TheOracleAgreesWithTheCaseFiles(string family)
    {
        foreach (HardCase c in CaseFamily.Load(family).Cases)
        {
            ExactAnswer answer = c.Pair.Exact();
            Assert.True(answer.Overlap == c.Overlap, $"{c.Pair.Name}: oracle {answer}, file {c.Overlap}");

            // 2^-52: both were rounded to double once.
            Assert.True(
                Math.Abs(answer.Distance - c.Distance) <= 2.3e-16 * answer.Distance,
                $"{c.Pair.Name}: oracle {answer.Distance:R}, file {c.Distance:R}");
        }
    }

    /// <summary>Doubles rule out points that cannot be furthest: the support is that of a look at every point in
    /// integers, towards faces and edges, too.</summary>
    [Theory]
    [MemberData(nameof(Families))]
    public void TheFilterChangesNothing(string family)
    {
        HardCase[] small = [.. CaseFamily.Load(family).Cases.Where(c => Vertices(c.Pair) <= MostVertices)];
        int stride = Math.Max(1, small.Length / Budget.Count(20));
        var rng = new Rng(17);
        for (int i = 0; i < small.Length; i += stride)
        {
            TestPair pair = small[i].Pair;
            var problem = new ExactProblem(pair.A.Vertices!, 0, pair.PoseA, pair.B.Vertices!, 0, pair.PoseB);
            foreach (Int3 direction in DirectionsFor(rng, problem, pair))
            {
                Int3 fast = problem.Support(direction), slow = problem.SlowSupport(direction);
                Assert.True(
                    Int3.Dot(direction, fast) == Int3.Dot(direction, slow),
                    $"{pair.Name}: {direction} gives {fast}, not {slow}");
            }
        }
    }

    private static int Vertices(TestPair pair) => pair.A.Vertices!.Length + pair.B.Vertices!.Length;

    /// <summary>Across triangles of the difference, across those but for the last bit, and at random.</summary>
    private static IEnumerable<Int3> DirectionsFor(Rng rng, ExactProblem problem, TestPair pair)
    {
        for (int i = 0; i < 12; i++)
        {
            Int3 a = Any(), b = Any(), c = Any(), normal = Int3.Cross(b - a, c - a);
            Int3[] candidates =
            [
                normal, normal + new Int3(1, -1, 0), a - b, a, new Int3(rng.Below(3) - 1, rng.Below(3) - 1, 1),
            ];
            foreach (Int3 direction in candidates)
            {
                if (!direction.IsZero) yield return direction;
            }
        }

        Int3 Any() => problem.Vertex(rng.Below(pair.A.Vertices!.Length), rng.Below(pair.B.Vertices!.Length));
    }

    [Fact]
    public void TheOracleAgreesWithClosedForms()
    {
        static RigidPose At(float x, float y, float z) => new(new Vector3(x, y, z));
        Assert.Equal(
            new ExactAnswer(false, 4),
            new TestPair("", TestShape.Sphere(1), At(0, 0, 0), TestShape.Sphere(0), At(3, 4, 0)).Exact());
        Assert.Equal(
            new ExactAnswer(true, 0),
            new TestPair("", TestShape.Sphere(2), At(0, 0, 0), TestShape.Sphere(3), At(3, 4, 0)).Exact());
        TestPair justApart = new(
            "", TestShape.Sphere(2), At(0, 0, 0), TestShape.Sphere(MathF.BitDecrement(3)), At(3, 4, 0));
        Assert.Equal(new ExactAnswer(false, 3.0 - MathF.BitDecrement(3)), justApart.Exact());
        Assert.Equal(
            new ExactAnswer(false, Math.Sqrt(3)),
            new TestPair("", TestShape.Box(Vector3.One), At(0, 0, 0), TestShape.Point(), At(2, -2, 2)).Exact());

        // A rotation by 90 degrees from a quaternion that is not of unit length: (0, 0, 1, 1) / 1.4142 in floats.
        var quarter = new RigidPose(new Quaternion(0, 0, 0.7071f, 0.7071f), Vector3.Zero);
        var segment = TestShape.Segment(new Vector3(1, 0, 0), new Vector3(3, 0, 0));
        Assert.Equal(
            new ExactAnswer(false, 1), new TestPair("", segment, quarter, TestShape.Point(), At(0, 0, 0)).Exact());
        Assert.Equal(
            new ExactAnswer(false, 2), new TestPair("", segment, quarter, TestShape.Point(), At(0, 5, 0)).Exact());
    }

    [Fact]
    public void DepthAgreesWithTheCaseFiles()
    {
        HardCase[] small = [.. CaseFamily.Load("deep").Cases.Where(c => c.Overlap && Vertices(c.Pair) <= 16).Take(20)];
        Assert.True(small.Length > 5);
        foreach (HardCase c in small)
        {
            double depth = CloudDepth.Of(c.Pair);
            Assert.True(
                Math.Abs(depth - c.Depth) <= 1e-14 * c.Pair.Scale, $"{c.Pair.Name}: {depth:R}, file {c.Depth:R}");
        }
    }
}
