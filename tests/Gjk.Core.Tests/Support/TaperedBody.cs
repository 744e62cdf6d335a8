namespace Gjk.Core.Tests.Support;

/// <summary>The hull of two balls in the world, with a signed distance of its own: the hull is the union of all balls
/// between the two, so the distance of two of them is the least of a convex function of two numbers.</summary>
internal sealed class TaperedBody
{
    private readonly Double3 _first, _along;
    private readonly double _firstRadius, _growth;

    public TaperedBody(double top, double bottom, double halfHeight, in RigidPose pose)
    {
        Double3 axis = new Body<PointShape>(default, pose).Rotate(new Double3(0, halfHeight, 0));
        (_first, _along) = (pose.Position + axis, axis * -2);
        (_firstRadius, _growth) = (top, bottom - top);
    }

    private TaperedBody(TaperedBody other, in Double3 motion)
    {
        (_first, _along) = (other._first + motion, other._along);
        (_firstRadius, _growth) = (other._firstRadius, other._growth);
    }

    /// <summary>The same elsewhere.</summary>
    public TaperedBody Moved(in Double3 motion) => new(this, motion);

    /// <summary>The signed distance of a point: by the ball of which the point lies straight out.</summary>
    public double Distance(in Double3 point) => Least(point);

    /// <summary>The signed distance of two bodies whose axes do not meet.</summary>
    public double Distance(TaperedBody other)
    {
        // Golden sections of the other's axis.
        const double Ratio = 0.6180339887498949;
        double low = 0, high = 1, p = 1 - Ratio, q = Ratio, atP = At(p), atQ = At(q);
        double least = Math.Min(At(0), At(1));
        for (int i = 0; i < 80; i++)
        {
            least = Math.Min(least, Math.Min(atP, atQ));
            if (atP < atQ)
            {
                (high, q, atQ) = (q, p, atP);
                atP = At(p = high - Ratio * (high - low));
            }
            else
            {
                (low, p, atP) = (p, q, atQ);
                atQ = At(q = low + Ratio * (high - low));
            }
        }

        return least;

        double At(double t) => Least(other._first + other._along * t) - other._firstRadius - other._growth * t;
    }

    private double Least(in Double3 point)
    {
        Double3 from = point - _first;
        double length = _along.Length, slope = length > 0 ? _growth / length : 2;
        double x = length > 0 ? Double3.Dot(from, _along) / length : 0;
        double beside = length > 0 ? Double3.Cross(from, _along).Length / length : from.Length;
        double at = Math.Abs(slope) < 1
            ? Math.Clamp(x + beside * slope / Math.Sqrt(1 - slope * slope), 0, length)
            : _growth > 0 ? length : 0;
        double past = x - at;
        return Math.Sqrt(past * past + beside * beside) - _firstRadius - (length > 0 ? _growth * at / length : 0);
    }
}
