namespace Gjk.Core.Tests.Minkowski;

/// <summary>Supports of the difference of two clouds, against all its vertices in integers.</summary>
public class MinkowskiDifferenceTests
{
    /// <summary>Ratio to the size of the pair: roundings to double (2^-53 each).</summary>
    private const double Rounding = 64.0 / (1L << 53);

    [Fact]
    public void TheSupportIsTheVertexNearestTheOriginAlongTheNormal()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(100); seed++)
        {
            var rng = new Rng(seed);
            TestShape a = TestShape.Mesh(Clouds.InBox(rng, 10, Vector3.One));
            TestShape b = TestShape.Mesh(Clouds.InBox(rng, 10, Vector3.One));
            RigidPose poseB = Generators.Pose(rng, rng.Vector(-3, 3));
            var problem = new ExactProblem(a.Vertices!, 0, RigidPose.Identity, b.Vertices!, 0, poseB);
            ConvexShape shapeA = a.Shape, shapeB = b.Shape;
            PairFrame.Compose(ref shapeA, RigidPose.Identity, ref shapeB, poseB, out PairFrame frame);
            foreach (Double3 normal in Directions.Few)
            {
                Simplex simplex = default;
                int ids = MinkowskiDifference.Support(
                    ref shapeA, ref shapeB, frame, normal, ref simplex.At(2), out Double3 w);
                (int idA, int idB) = (simplex.IdA(2), simplex.IdB(2));
                Assert.Equal(idA | idB, ids);
                Assert.Equal(w, simplex.W(2));
                Assert.True(shapeA.TryGetVertex(idA, out Double3 vertexA) && vertexA == simplex.OnA(2));
                Assert.True(shapeB.TryGetVertex(idB, out Double3 vertexB) && vertexB == simplex.OnB(2));
                ref DifferenceVertex made = ref simplex.At(1);
                Assert.True(MinkowskiDifference.TryMakeVertex(ref shapeA, ref shapeB, frame, idA, idB, ref made));
                Assert.Equal(w, simplex.W(1));
                Assert.Equal(Lowest(problem, a, b, normal), Double3.Dot(normal, w), 10 * Rounding);
            }
        }
    }

    /// <summary>The least height of all differences of two points.</summary>
    private static double Lowest(ExactProblem problem, TestShape a, TestShape b, in Double3 normal)
    {
        double lowest = double.PositiveInfinity;
        for (int i = 0; i < a.Vertices!.Length; i++)
        {
            for (int j = 0; j < b.Vertices!.Length; j++)
            {
                Int3 v = problem.Vertex(i, j);
                Fraction height = (Fraction)normal.X * Whole(v.X) + (Fraction)normal.Y * Whole(v.Y)
                    + (Fraction)normal.Z * Whole(v.Z);
                Fraction scaled = height / Whole(problem.Denominator);
                int shift = 128;
                var quotient = (scaled.Numerator << shift) / scaled.Denominator;
                lowest = System.Math.Min(lowest, Dyadic.ToDouble(quotient, problem.Exponent - shift));
            }
        }

        return lowest;
    }

    private static Fraction Whole(BigInteger n) => new(n, 1);
}
