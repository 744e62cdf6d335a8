namespace Gjk.Core;

/// <summary>A direction in a plane of <see cref="AxialDepth"/> and the furthest point in it, and how that moves as the
/// plane turns.</summary>
internal readonly struct AxialSide
{
    /// <summary>The direction, of unit length.</summary>
    public readonly double X, Y;

    /// <summary>The point.</summary>
    public readonly double PointX, PointY;

    /// <summary>How the point moves as the plane turns: the first derivative and the second.</summary>
    private readonly double _movedX, _movedY, _bentX, _bentY;

    public AxialSide(
        in WayOut plane, double x, double y, in Double3 point, in Double3 moved, in Double3 bent)
    {
        X = x;
        Y = y;
        PointX = Double3.Dot(plane.Across, point);
        PointY = Double3.Dot(plane.Axis, point);
        _movedX = Double3.Dot(plane.Across, moved);
        _movedY = Double3.Dot(plane.Axis, moved);
        _bentX = Double3.Dot(plane.Across, bent);
        _bentY = Double3.Dot(plane.Axis, bent);
    }

    /// <summary>What the way out in the direction costs.</summary>
    public double Height => X * PointX + Y * PointY;

    /// <summary>Whether no way out across the line through two points is shorter than that, in this plane and in those
    /// that are turned against it by up to an angle.</summary>
    /// <remarks>The furthest of points that follow each other around the axis is least across one of the lines between
    /// them. As planes turn, the points p + δ v and q + δ u (<see cref="WayOut.Follow"/>) span a line that is p × q /
    /// |q - p| from the origin, of which the product is a polynomial and the length no more than one.</remarks>
    /// <param name="next">The side at the other end.</param>
    /// <param name="half">The angle.</param>
    /// <param name="slope">How fast a way out changes at most.</param>
    /// <param name="least">How long.</param>
    public bool IsProved(in AxialSide next, double half, double slope, double least)
    {
        double dx = next.PointX - PointX, dy = next.PointY - PointY, length = Math.Sqrt(dx * dx + dy * dy);
        if (length == 0) return true;
        double ux = next._movedX - _movedX, uy = next._movedY - _movedY, moved = Math.Sqrt(ux * ux + uy * uy);
        least += Rest(next, half, slope, moved / length);
        double over = PointX * next.PointY - PointY * next.PointX - least * length;
        double first = PointX * next._movedY - PointY * next._movedX + _movedX * next.PointY
            - _movedY * next.PointX - least * (dx * ux + dy * uy) / length;
        double second = _movedX * next._movedY - _movedY * next._movedX - least * 0.5 * moved * moved / length;
        return over >= half * (Math.Abs(first) + half * Math.Abs(second));
    }

    /// <summary>Whether the way out in the direction is no shorter than that, in all these planes.</summary>
    public bool IsHigh(double half, double slope, double least) =>
        Height - half * Math.Abs(X * _movedX + Y * _movedY) >= least + Rest(this, half, slope, 0);

    /// <summary>What the second and the third term of the points' movement can take from a way out between two
    /// directions, and as far beside them as these turn. A unit vector between them is a sum of both with weights of up
    /// to one over the cosine of half their angle.</summary>
    private double Rest(in AxialSide next, double half, double slope, double turn)
    {
        double scale = 0.5 / Math.Sqrt(Math.Max(0.5 + 0.5 * (X * next.X + Y * next.Y), 0));
        double bent = Math.Max(Bent(next), next.Bent(this)) * scale;
        return half * half * Math.Min(slope, bent + slope * half * (2.0 / 3 + turn));
    }

    /// <summary>The second derivative of the way out to this point, in this direction or the other one.</summary>
    private double Bent(in AxialSide other) =>
        Math.Max(Math.Abs(X * _bentX + Y * _bentY), Math.Abs(other.X * _bentX + other.Y * _bentY));

    /// <summary>The direction across the chord to the next side's point, and the chord's height along it.</summary>
    /// <returns>False where that is not between the two: no direction there is better than both.</returns>
    public bool TryGetChord(in AxialSide next, out double x, out double y, out double height)
    {
        x = next.PointY - PointY;
        y = PointX - next.PointX;
        double squared = x * x + y * y, scale = squared > 0 ? 1 / Math.Sqrt(squared) : 0;
        x *= scale;
        y *= scale;
        height = Math.Min(x * PointX + y * PointY, x * next.PointX + y * next.PointY);
        return X * y - Y * x > 0 && x * next.Y - y * next.X > 0;
    }
}
