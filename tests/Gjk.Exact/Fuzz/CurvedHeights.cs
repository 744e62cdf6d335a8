using System.Globalization;
using Gjk.Exact.Fuzz.Shrinking;

namespace Gjk.Exact.Fuzz;

/// <summary>How far a shape with a curved core reaches along a direction, from the shape's numbers by formulas of its
/// own.</summary>
public sealed class CurvedHeights
{
    private readonly ShapeKind _kind;
    private readonly double[] _numbers;
    private readonly Double3 _factors;
    private readonly double _margin;

    public CurvedHeights(in ConvexShape shape)
    {
        ShapeWords words = ShapeWords.Of(shape);
        _kind = shape.Kind;
        _margin = shape.Margin;
        _numbers = Read(words.Numbers);
        double[] scale = Read(words.Scale);
        _factors = scale.Length == 0 ? new Double3(1, 1, 1) : new Double3(scale[0], scale[1], scale[2]);
    }

    /// <summary>The greatest dot product with a point of the core, its own curved margin included.</summary>
    /// <param name="direction">In the local frame, about of unit length.</param>
    public double Of(in Double3 direction)
    {
        Double3 d = Double3.Multiply(_factors, direction);
        switch (_kind)
        {
            case ShapeKind.Cylinder:
                return _numbers[0] * Length(d.X, d.Z, 0) + _numbers[1] * Math.Abs(d.Y);
            case ShapeKind.Cone:
                return Math.Max(_numbers[1] * d.Y, _numbers[0] * Length(d.X, d.Z, 0) - _numbers[1] * d.Y);
            case ShapeKind.Ellipsoid:
                return Length(_numbers[0] * d.X, _numbers[1] * d.Y, _numbers[2] * d.Z);
            case ShapeKind.TaperedCapsule:
                double up = _numbers[2] * d.Y, length = Length(d.X, d.Y, d.Z);
                double most = Math.Max(up + _numbers[0] * length, _numbers[1] * length - up);
                return most - _margin * Length(direction.X, direction.Y, direction.Z);
            default:
                // A segment whose ball became an ellipsoid.
                double first = _numbers[0] * d.X + _numbers[1] * d.Y + _numbers[2] * d.Z;
                double second = _numbers[3] * d.X + _numbers[4] * d.Y + _numbers[5] * d.Z;
                return Math.Max(first, second) + _numbers[6] * Length(d.X, d.Y, d.Z);
        }
    }

    /// <summary>The length of a vector, whatever its size.</summary>
    private static double Length(double x, double y, double z)
    {
        double most = Math.Max(Math.Abs(x), Math.Max(Math.Abs(y), Math.Abs(z)));
        if (!(most > 0)) return 0;
        (x, y, z) = (x / most, y / most, z / most);
        return most * Math.Sqrt(x * x + y * y + z * z);
    }

    private static double[] Read(IEnumerable<string> words) =>
        [.. words.Select(w => double.Parse(w, CultureInfo.InvariantCulture))];
}
