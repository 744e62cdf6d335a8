namespace Gjk.Core.Tests.Solvers;

/// <summary>The tolerances of a depth, each from both sides: a point lies in a block, under a face that has a tip in
/// its middle, or in one that is hardly a block.</summary>
public class DepthToleranceTests
{
    /// <summary>A rounding in double, 2^-53.</summary>
    private const double U = 1.0 / (1L << 53);

    /// <summary>The block of half sides 1, 1 and a height, by default 0.5, and the tip.</summary>
    private readonly struct Block(double tip, bool isCurved, double height = 0.5) : ISupportMap
    {
        public Double3 Center => default;

        public double Margin => 0;

        public double BoundingRadius => 1.5;

        public int Support(in Double3 direction, out Double3 point)
        {
            double most = double.NegativeInfinity;
            int best = 0;
            for (int id = 0; id < 9; id++)
            {
                TryGetVertex(id, out Double3 vertex);
                double along = Double3.Dot(direction, vertex);
                if (along > most) (most, best) = (along, id);
            }

            TryGetVertex(best, out point);
            return isCurved ? -1 : best;
        }

        public void GetFace(in Double3 direction, ref FaceCorners corners)
        {
        }

        public bool TryGetVertex(int id, out Double3 point)
        {
            point = id == 8
                ? new Double3(0, 0, -height - tip)
                : new Double3((id & 1) != 0 ? 1 : -1, (id & 2) != 0 ? 1 : -1, (id & 4) != 0 ? height : -height);
            return id is >= 0 and <= 8;
        }
    }

    /// <summary>Where they have not met, the tip becomes a part of the surface, which takes more supports.</summary>
    [Theory]
    [InlineData(false, 8 * U, true)]
    [InlineData(false, 32 * U, false)]
    [InlineData(true, 1e-14, true)]
    [InlineData(true, 4e-14, false)]
    public void BoundsOfTheDepthMeet(bool isCurved, double ratio, bool haveMet)
    {
        DistanceResult flat = Ask(0, isCurved), r = Ask(1.5 * ratio, isCurved);
        Assert.Equal(-0.2, r.Distance, 1e-6);
        Assert.Equal(haveMet, r.Iterations == flat.Iterations);
    }

    /// <summary>Thinner than 64 roundings of the size, or twice as thick; the point lies in the middle.</summary>
    [Theory]
    [InlineData(40 * U, true)]
    [InlineData(128 * U, false)]
    public void AThinDifferenceHasNoInside(double ratio, bool isFlat)
    {
        var block = new Block(0, false, 0.5 * ratio * Math.Sqrt(2));
        var point = new PointShape();
        PairFrame.Compose(ref block, RigidPose.Identity, ref point, RigidPose.Identity, out PairFrame frame);
        SolverState.Make<Block, PointShape>(frame, out SolverState state);
        NoPolytopeTrace trace = default;
        Verdict verdict = GjkDepth<Block, PointShape, NoPolytopeTrace>.Solve(
            ref block, ref point, frame, ref state, ref trace);
        Assert.Equal(isFlat, verdict == Verdict.Flat);
    }

    /// <summary>A box that is tilted on a larger one: its deepest edge is where they touch, or, if it hardly rises, the
    /// middle.</summary>
    [Theory]
    [InlineData(1.5e-8, true)]
    [InlineData(6e-8, false)]
    public void ASideThatHardlyRisesIsLevel(double rise, bool isLevel)
    {
        double size = (4 + 1) * Math.Sqrt(3);
        var tilt = new Quaternion(0, 0, (float)(0.5 * rise * size), 1);
        DistanceResult r = ConvexQuery.SignedDistance(
            new BoxShape(new Vector3(4)), RigidPose.Identity, new BoxShape(Vector3.One),
            new RigidPose(tilt, new Vector3(0, 4.9f, 0)));
        Assert.Equal(-0.1, r.Distance, 1e-6);
        Assert.Equal(isLevel ? 0 : -1, r.PointB.X, 1e-3);
    }

    private static DistanceResult Ask(double tip, bool isCurved) => ConvexQuery.SignedDistance(
        new Block(tip, isCurved), RigidPose.Identity, new PointShape(),
        new RigidPose(new Vector3(0.1f, 0.07f, -0.3f)));
}
