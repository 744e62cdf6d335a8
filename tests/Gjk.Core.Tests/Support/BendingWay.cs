namespace Gjk.Core.Tests.Support;

/// <summary>How far a direction is from that of the shortest way out beside it, where the way bends: a step of Newton's
/// method, in double, on the supports alone.</summary>
internal sealed class BendingWay(ConvexShape a, RigidPose poseA, ConvexShape b, RigidPose poseB)
{
    /// <summary>Radians: half of what a direction is turned by for a difference. A support that jumps within the larger
    /// one makes the two differ, and what is off by 2e-5 is far inside it.</summary>
    private const double Narrow = 1e-5, Wide = 1e-3;

    /// <summary>Ratio to the size: ways out that bend less have no sharp direction.</summary>
    private const double LeastBend = 3e-3;

    /// <summary>Ratio: how much the bends of the two differences may differ.</summary>
    private const double SameBend = 0.05;

    private readonly Body<ConvexShape> _a = new(a, poseA), _b = new(b, poseB);

    public double Size => _a.Radius + _b.Radius;

    /// <summary>The angle in radians; NaN where the way out does not end on a smooth point, or hardly bends.</summary>
    public double Off(Double3 normal)
    {
        normal *= 1 / normal.Length;
        (Double3 u, Double3 v) = new PlaneBasis(normal);
        Double3 w = Support(normal);
        double height = Double3.Dot(normal, w), alongU = Double3.Dot(u, w), alongV = Double3.Dot(v, w);
        (double U, double V, double Twist) bend = Bend(Narrow), wide = Bend(Wide);
        double sum = bend.U + bend.V, determinant = bend.U * bend.V - bend.Twist * bend.Twist;
        double change = Math.Abs(bend.U - wide.U) + Math.Abs(bend.V - wide.V) + Math.Abs(bend.Twist - wide.Twist);
        if (!(sum > 0 && determinant > LeastBend * Size * sum && change <= SameBend * sum)) return double.NaN;
        Double3 step = u * (bend.V * alongU - bend.Twist * alongV) + v * (bend.U * alongV - bend.Twist * alongU);
        return step.Length / determinant;

        (double U, double V, double Twist) Bend(double angle)
        {
            Double3 byU = Slope(u, angle), byV = Slope(v, angle);
            double twist = (Double3.Dot(u, byV) + Double3.Dot(v, byU)) / 2;
            return (Double3.Dot(u, byU) - height, Double3.Dot(v, byV) - height, twist);
        }

        Double3 Slope(Double3 across, double angle) =>
            (Support(normal + across * angle) - Support(normal - across * angle)) * (0.5 / angle);
    }

    /// <summary>The furthest point of A - B.</summary>
    private Double3 Support(Double3 direction) =>
        Furthest(_a, a, direction) + Furthest(_b, b, -direction) * -1 + (_a.Position - _b.Position);

    private static Double3 Furthest(Body<ConvexShape> body, ConvexShape shape, Double3 direction)
    {
        Double3 local = body.InverseRotate(direction);
        shape.Support(local, out Double3 point);
        return body.Rotate(point + shape.Center + local * (shape.Margin / local.Length));
    }
}
