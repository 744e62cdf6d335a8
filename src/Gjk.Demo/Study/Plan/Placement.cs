namespace Gjk.Demo.Study.Plan;

/// <summary>Puts two shapes so that the library's own signed distance is a wanted gap. A stands where both touch when B
/// is at the origin; B then moves along the line. Positions near the origin have the finest floats, so the gap is
/// usually met to the last bit, and otherwise by the nearest position there is. The script of the page
/// (study/placement.js) takes the same steps with the same numbers.</summary>
internal sealed class Placement
{
    /// <summary>Halvings. A float's bits are halved in 32 of them, and its exponents in 8 more; four times fewer would
    /// end early, and more do no harm, because the search ends where no float is left.</summary>
    private const int MostHalvings = 200;

    private readonly ConvexShape _a, _b;
    private readonly Quaternion _rotationA, _rotationB;
    private readonly Vector3 _line;
    private readonly float _contact, _low, _high;

    /// <param name="pair">The shapes and their rotations.</param>
    /// <param name="line">The unit axis along which B moves.</param>
    /// <exception cref="RefusedException">The shapes never overlap on the line.</exception>
    public Placement(PairPlan pair, Vector3 line)
    {
        (_a, _rotationA, _b, _rotationB, _line) = (pair.A, pair.RotationA, pair.B, pair.RotationB, line);
        float high = 1;
        while (At(0, high) <= 0 && high < 1e6f) high *= 2;
        float low =
            Inside(high) ?? throw new RefusedException($"pair \"{pair.Name}\": its shapes do not meet on the line");
        _contact = Search(0, 0, low, high);
        _low = low - _contact;
        _high = high - _contact;
    }

    /// <summary>Where A stands.</summary>
    public RigidPose PoseA => new(_rotationA, -_contact * _line);

    public RigidPose PoseB(float position) => new(_rotationB, position * _line);

    /// <summary>The library's answer.</summary>
    public float Distance(float position) => At(_contact, position);

    /// <summary>The position of B on the line at which the library answers the gap, or comes nearest to it.</summary>
    /// <exception cref="RefusedException">The shapes do not overlap so deeply.</exception>
    public float Position(float gap)
    {
        if (Distance(_low) > gap)
        {
            throw new RefusedException(
                FormattableString.Invariant($"the overlap {-gap:R} is deeper than the two shapes can overlap"));
        }

        float high = MathF.Max(_high, 1);
        while (Distance(high) < gap) high *= 2;
        return Search(_contact, gap, _low, high);
    }

    public string Record(float position) => new QueryRecord(_a, PoseA, _b, PoseB(position)).ToString();

    private float At(float contact, float position) => ConvexQuery.SignedDistance(
        _a, new RigidPose(_rotationA, -contact * _line), _b, new RigidPose(_rotationB, position * _line)).Distance;

    /// <summary>The deepest of some positions at which both overlap. The distance is convex along the line.</summary>
    private float? Inside(float high)
    {
        float best = 0;
        for (int i = -8; i < 8; i++)
        {
            if (At(0, high * i / 8) < At(0, best)) best = high * i / 8;
        }

        return At(0, best) < 0 ? best : null;
    }

    private float Search(float contact, float gap, float low, float high)
    {
        for (int i = 0; i < MostHalvings; i++)
        {
            float middle = (float)(((double)low + high) / 2);
            if (middle == low || middle == high) break;
            float distance = At(contact, middle);
            if (distance == gap) return middle;
            if (distance < gap) low = middle;
            else high = middle;
        }

        return Math.Abs((double)At(contact, low) - gap) <= Math.Abs((double)At(contact, high) - gap) ? low : high;
    }
}
