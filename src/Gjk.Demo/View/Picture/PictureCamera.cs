namespace Gjk.Demo.View;

/// <summary>The camera of a still picture. It looks in the page's first direction and stands as near as all balls
/// allow. The picture is as tall as the balls need.</summary>
internal sealed class PictureCamera
{
    /// <summary>The tangent of half the angle that the longer side of the picture spans. The half angle is 19
    /// degrees.</summary>
    private const double HalfWidth = 0.344;

    /// <summary>Width over height of the widest and the narrowest picture.</summary>
    private const double Widest = 2.2, Narrowest = 1.2;

    /// <summary>The margin around the scene, as a share of the picture.</summary>
    private const double Border = 0.05;

    /// <summary>The least width of the picture, as a tangent. It sets how near the camera comes to a scene of one
    /// point.</summary>
    private const double Smallest = 1e-3;

    private readonly Double3 _right, _up, _back;
    private double _scale, _left, _top;

    /// <param name="balls">Balls that must be in sight.</param>
    public PictureCamera(IReadOnlyList<(Double3 Center, double Radius)> balls)
    {
        _back = Unit(new Double3(0.34, 0.42, 1));
        _right = Unit(Double3.Cross(new Double3(0, 1, 0), _back));
        _up = Double3.Cross(_back, _right);
        double away = 1;
        foreach ((Double3 center, double radius) in balls)
        {
            double depth = Double3.Dot(center, _back) + radius;
            double aside = Math.Max(
                Math.Abs(Double3.Dot(center, _right)), Math.Abs(Double3.Dot(center, _up)) * Narrowest);
            away = Math.Max(away, depth + (aside + radius) / HalfWidth);
        }

        Eye = _back * away;
    }

    public Double3 Eye { get; }

    public double Width { get; private set; }

    public double Height { get; private set; }

    /// <summary>Makes the picture as wide as given, and as tall as all points need.</summary>
    public void Frame(IEnumerable<Double3> points, double width)
    {
        double left = double.PositiveInfinity, right = -left, bottom = left, top = -left;
        foreach (Double3 point in points)
        {
            (double x, double y) = OnWindow(point);
            left = Math.Min(left, x);
            right = Math.Max(right, x);
            bottom = Math.Min(bottom, y);
            top = Math.Max(top, y);
        }

        if (left > right) (left, right, bottom, top) = (0, 0, 0, 0);
        double border = Border * Math.Max(right - left, top - bottom);
        double wide = right - left + 2 * border, high = Math.Max(top - bottom + 2 * border, wide / Widest);
        wide = Math.Max(Math.Max(wide, high * Narrowest), Smallest);
        high = Math.Max(high, wide / Widest);
        Width = width;
        Height = Math.Round(width * high / wide);
        _scale = width / wide;
        _left = (left + right - wide) / 2;
        _top = (top + bottom + high) / 2;
    }

    /// <summary>The position of a point in the picture. x goes to the right, y goes down.</summary>
    public (double X, double Y) Project(in Double3 point)
    {
        (double x, double y) = OnWindow(point);
        return ((x - _left) * _scale, (_top - y) * _scale);
    }

    /// <summary>A direction, given by its parts to the right, upwards and towards the viewer.</summary>
    public Double3 Direction(double right, double up, double back) => Unit(_right * right + _up * up + _back * back);

    /// <summary>The rectangle about a ball as the eye sees it, in tangents of the angles to the right and upwards.
    /// Infinite where the ball reaches behind the eye.</summary>
    public (double Left, double Right, double Bottom, double Top) Bounds(in Double3 center, double radius)
    {
        Double3 from = center - Eye;
        double depth = Depth(center);
        (double left, double right) = Span(Double3.Dot(from, _right), depth, radius);
        (double bottom, double top) = Span(Double3.Dot(from, _up), depth, radius);
        return (left, right, bottom, top);
    }

    /// <summary>The tangents from the eye to a disc in one plane through the axis of view.</summary>
    private static (double From, double To) Span(double aside, double depth, double radius)
    {
        double distance = Math.Sqrt(aside * aside + depth * depth);
        double middle = Math.Atan2(aside, depth), half = radius < distance ? Math.Asin(radius / distance) : Math.PI;
        return (Tangent(middle - half), Tangent(middle + half));
    }

    private static double Tangent(double angle) => Math.Abs(angle) < Math.PI / 2
        ? Math.Tan(angle)
        : Math.CopySign(double.PositiveInfinity, angle);

    private static Double3 Unit(in Double3 v) => v * (1 / v.Length);

    private (double X, double Y) OnWindow(in Double3 point)
    {
        Double3 from = point - Eye;
        double depth = Depth(point);
        return (Double3.Dot(from, _right) / depth, Double3.Dot(from, _up) / depth);
    }

    private double Depth(in Double3 point) => Double3.Dot(Eye - point, _back);
}
