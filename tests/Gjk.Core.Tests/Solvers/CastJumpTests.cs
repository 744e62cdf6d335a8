namespace Gjk.Core.Tests.Solvers;

/// <summary>A point flies at the end of a capsule and jumps to where the ball there is met. The capsule's side begins
/// just before, and the jump has gone through it by a little.</summary>
public class CastJumpTests
{
    /// <summary>The segment from the origin to the angle's side, widened by 1. It reaches 2 from its centre, which is
    /// the end that is met.</summary>
    private readonly struct Capsule(double angle) : ISupportMap
    {
        private readonly Double3 _end =
            new(0.6 * Math.Cos(angle) - 0.8 * Math.Sin(angle), 0.8 * Math.Cos(angle) + 0.6 * Math.Sin(angle), 0);

        public Double3 Center => default;

        public double Margin => 1;

        public double BoundingRadius => 2;

        public int Support(in Double3 direction, out Double3 point)
        {
            int id = Double3.Dot(direction, _end) > 0 ? 1 : 0;
            TryGetVertex(id, out point);
            return id;
        }

        public void GetFace(in Double3 direction, ref FaceCorners corners)
        {
        }

        public bool TryGetVertex(int id, out Double3 point)
        {
            point = id == 1 ? _end : default;
            return id is 0 or 1;
        }
    }

    /// <summary>It ends where the jump went if that is no more than 2e-10 too far, 1e-10 of the radii; otherwise it
    /// goes back.</summary>
    [Theory]
    [InlineData(1e-10, false)]
    [InlineData(4e-10, true)]
    public void AJumpMayGoThroughByLittle(double through, bool goesBack)
    {
        // The ball is met at (-0.8, 0.6), square to which the segment nearly lies. It turns to the point by an angle
        // whose square, over twice the slope, is what the line goes through the side.
        CastResult straight = Cast(0), r = Cast(Math.Sqrt(1.6 * through));
        Assert.Equal((CastStatus.Hit, 2.2f / 4), (r.Status, r.Fraction));
        Assert.Equal(straight.Iterations + (goesBack ? 1 : 0), r.Iterations);
    }

    private static CastResult Cast(double angle) => ConvexQuery.Cast(
        new Capsule(angle), RigidPose.Identity, default, new PointShape(), new RigidPose(new Vector3(-3, 0.6f, 0)),
        new Vector3(4, 0, 0));
}
