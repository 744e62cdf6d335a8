namespace Gjk.Exact.Oracle;

/// <summary>One posed cloud whose points become integers only when they are asked for. The furthest point is found in
/// two steps: doubles rule out whatever is lower by more than their rounding, integers decide between the
/// rest.</summary>
public sealed class ExactCloud
{
    /// <summary>Ratio to |direction| times the cloud's reach: above what rounding can do to the difference of two
    /// heights. The direction costs 2 roundings (2^-53 each), the matrix and turning the direction 20, the points'
    /// differences 2, two dot products 8. Pinned by OracleTests.TheFilterChangesNothing.</summary>
    private const double HeightError = 64.0 / (1L << 53);

    private readonly Double3[] _points, _fromFirst;
    private readonly Int3[] _exact;
    private readonly bool[] _isKnown;
    private readonly double[] _heights;
    private readonly ExactRotation _rotation;
    private readonly BigInteger _otherDenominator;
    private readonly Int3 _origin;
    private readonly int _exponent;
    private readonly double _reach;

    /// <param name="points">In the local frame.</param>
    /// <param name="rotation">Of the pose.</param>
    /// <param name="position">Of the pose.</param>
    /// <param name="otherDenominator">The other rotation's: both clouds get the product of both.</param>
    /// <param name="exponent">Of the common unit, 2^exponent.</param>
    public ExactCloud(
        Double3[] points, ExactRotation rotation, in Double3 position, BigInteger otherDenominator, int exponent)
    {
        _points = points;
        _rotation = rotation;
        _otherDenominator = otherDenominator;
        _exponent = exponent;
        _origin = Integer(position) * rotation.Denominator;
        _exact = new Int3[points.Length];
        _isKnown = new bool[points.Length];
        _heights = new double[points.Length];
        _fromFirst = new Double3[points.Length];
        for (int i = 0; i < points.Length; i++)
        {
            Double3 v = points[i] - points[0];
            _fromFirst[i] = v;
            _reach = Math.Max(_reach, Math.Abs(v.X) + Math.Abs(v.Y) + Math.Abs(v.Z));
        }
    }

    public int Count => _points.Length;

    /// <summary>The point in the world, in the common unit, times both denominators.</summary>
    public Int3 this[int index]
    {
        get
        {
            if (!_isKnown[index])
            {
                _exact[index] = (_rotation.Rotate(Integer(_points[index])) + _origin) * _otherDenominator;
                _isKnown[index] = true;
            }

            return _exact[index];
        }
    }

    /// <summary>A point's place in the world, seen from the first point's, to double rounding.</summary>
    public Double3 FromFirst(int index) => _rotation.Approximate.Rotate(_fromFirst[index]);

    /// <summary>The index of a point that is furthest in a direction of the world.</summary>
    /// <param name="direction">Exact.</param>
    /// <param name="approximate">The same, of about unit length, to double rounding.</param>
    public int Furthest(in Int3 direction, in Double3 approximate)
    {
        double enough = Highest(approximate) - HeightError * _reach;
        int best = -1;
        BigInteger bestDot = default;
        for (int i = 0; i < Count; i++)
        {
            if (_heights[i] < enough || (best >= 0 && _points[i] == _points[best])) continue;
            BigInteger dot = Int3.Dot(this[i], direction);
            if (best >= 0 && dot <= bestDot) continue;
            bestDot = dot;
            best = i;
        }

        return best;
    }

    /// <summary>The index of a point that is furthest in a direction, as far as doubles can tell.</summary>
    public int Furthest(in Double3 direction)
    {
        double highest = Highest(direction);
        return Array.IndexOf(_heights, highest);
    }

    /// <summary>The greatest height over the first point; fills in all of them.</summary>
    private double Highest(in Double3 direction)
    {
        Double3 local = _rotation.Approximate.InverseRotate(direction);
        double highest = double.NegativeInfinity;
        for (int i = 0; i < Count; i++)
        {
            double height = Double3.Dot(local, _fromFirst[i]);
            _heights[i] = height;
            if (height > highest) highest = height;
        }

        return highest;
    }

    private Int3 Integer(in Double3 v) =>
        new(Dyadic.ToInteger(v.X, _exponent), Dyadic.ToInteger(v.Y, _exponent), Dyadic.ToInteger(v.Z, _exponent));
}
