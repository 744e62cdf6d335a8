namespace Gjk.Exact.Fuzz;

/// <summary>How far apart a pair's shapes are while B moves past A: a function of the fraction that is found without
/// the library's solvers.</summary>
/// <remarks>The signed distance of two convex shapes that do not turn is a convex function of the way that one has
/// gone: a plane between them leaves a gap that changes in proportion to the way, and the distance is the widest of all
/// those gaps (Rockafellar, "Convex Analysis", 1970, section 5: a maximum of linear functions is convex). So a plane
/// that is found at one fraction bounds the distance from below at all of them, and where shapes are apart once, and in
/// contact later, they were apart at all times before.</remarks>
internal sealed class FuzzSweep
{
    /// <summary>Count: more than the least distance of curved shapes needs.</summary>
    private const int MostRounds = 60;

    /// <summary>Count: halvings towards a touch, until doubles end it.</summary>
    private const int MostHalvings = 60;

    /// <summary>Ratio to what rounding may do: cores that are nearer than this have no normal.</summary>
    private const double LeastCores = 100;

    private readonly FuzzPair _pair;

    public FuzzSweep(FuzzPair pair) => _pair = pair;

    private Double3 Motion => _pair.Motion.Relative;

    /// <summary>What is certain about the distance at a fraction: of two points from above, of two planes from
    /// below.</summary>
    /// <param name="fraction">Of the motion; any number.</param>
    /// <param name="shift">Moves B further, in the world.</param>
    public Moment At(double fraction, in Double3 shift = default)
    {
        Double3 centers = Centers(fraction) + shift;
        double noise = NoiseAt(fraction), margins = _pair.A.Margin + _pair.B.Margin;
        List<ExactGuess.Corner> feature = ExactGuess.Walk(
            Difference(new Double3(1, 0, 0), centers), d => Difference(d, centers), out Double3 nearest);
        double cores = nearest.Length;
        if (!(cores > LeastCores * noise))
            return new Moment(fraction, double.NegativeInfinity, cores - margins + noise, default, double.NaN);
        Double3 normal = Across(feature, nearest * (-1 / cores));
        return new Moment(
            fraction, Gap(normal, centers) - noise, cores - margins + noise, normal, Double3.Dot(normal, Motion));
    }

    /// <summary>The direction at a right angle to the nearest feature's edges: a point of small length that is the
    /// difference of long ones has lost its own direction.</summary>
    private static Double3 Across(List<ExactGuess.Corner> feature, in Double3 nearest)
    {
        if (feature.Count < 2) return nearest;
        Double3 ab = feature[1].W - feature[0].W;
        Double3 normal = feature.Count == 3
            ? Double3.Cross(ab, feature[2].W - feature[0].W)
            : nearest - ab * (Double3.Dot(nearest, ab) / ab.LengthSquared);
        double length = normal.Length;
        if (!(length > 0)) return nearest;
        return normal * (Math.Sign(Double3.Dot(normal, nearest)) / length);
    }

    /// <summary>The gap between the planes across a unit direction at a fraction; negative where they cross.</summary>
    public double Gap(in Double3 normal, double fraction) => Gap(normal, Centers(fraction));

    /// <summary>What rounding may do to a length at a fraction.</summary>
    public double NoiseAt(double fraction) =>
        Accuracy.Rounding * (
            _pair.BodyA.LongestSide + _pair.BodyB.LongestSide + _pair.Centers.Length
            + Math.Abs(fraction) * Motion.Length);

    /// <summary>The least distance between two fractions, by cutting planes (Kelley, "The cutting-plane method for
    /// solving convex programs", 1960): two planes, one that closes and one that opens, bound it from below, and where
    /// their gaps are equal the next one is found. It ends where points prove that it is no larger than the planes say,
    /// and where the shapes touch.</summary>
    /// <param name="from">The first fraction.</param>
    /// <param name="to">The last one, no less.</param>
    /// <param name="shift">Moves B further, in the world.</param>
    /// <returns>The fraction at which it is least, the points' distance there as the upper bound, the planes' as the
    /// lower one, which is negative where the shapes touch. The normal is that of a plane that proves it for all
    /// fractions between.</returns>
    public Moment Least(double from, double to, in Double3 shift = default)
    {
        Moment left = At(from, shift), right = At(to, shift), least = left.AtMost <= right.AtMost ? left : right;
        if (left.Slope >= 0) return left;
        if (right.Slope <= 0) return right;
        for (int round = 0; round < MostRounds && left.HasPlane && right.HasPlane; round++)
        {
            Moment bound = Crossing(left, right);
            least = least with { AtLeast = bound.AtLeast, Normal = bound.Normal };
            double fraction = bound.Fraction;
            if (least.AtMost - bound.AtLeast <= 2 * NoiseAt(fraction)) return least;
            if (!(fraction > left.Fraction && fraction < right.Fraction)) return least;

            Moment middle = At(fraction, shift);
            if (!middle.HasPlane) return Touching(left, middle, right, shift);
            if (middle.AtMost <= least.AtMost) least = middle;
            if (middle.Slope < 0) left = middle;
            else right = middle;
        }

        return least.HasPlane ? least : Touching(left, least, right, shift);
    }

    /// <summary>How deep the shapes reach into each other at most, on the way from one side of a touch to the other, by
    /// the last plane that closes before it and the first one that opens behind it.</summary>
    private Moment Touching(Moment left, in Moment touch, Moment right, in Double3 shift)
    {
        left = Towards(left, touch.Fraction, shift);
        right = Towards(right, touch.Fraction, shift);
        bool closes = left.Slope < 0, opens = right.Slope > 0;
        Moment bound = closes && opens ? Crossing(left, right)
            : closes ? left with { AtLeast = left.AtLeast + left.Slope * (right.Fraction - left.Fraction) }
            : opens ? right with { AtLeast = right.AtLeast - right.Slope * (right.Fraction - left.Fraction) }
            : touch;
        return touch with { AtLeast = bound.AtLeast, Normal = bound.Normal };
    }

    /// <summary>The moment nearest to a touch, on the side of the given one, at which a plane is found.</summary>
    private Moment Towards(Moment apart, double touch, in Double3 shift)
    {
        for (int i = 0; i < MostHalvings && apart.HasPlane; i++)
        {
            if (Math.Abs(touch - apart.Fraction) * Motion.Length <= NoiseAt(touch)) break;
            Moment middle = At(0.5 * (apart.Fraction + touch), shift);
            if (middle.HasPlane && middle.Slope < 0 == apart.Slope < 0) apart = middle;
            else touch = middle.Fraction;
        }

        return apart;
    }

    /// <summary>Where the gaps of two planes are equal, one of which closes while the other opens.</summary>
    private static Moment Crossing(in Moment left, in Moment right)
    {
        double across = right.AtLeast - left.AtLeast - right.Slope * (right.Fraction - left.Fraction);
        double step = across / (left.Slope - right.Slope), bound = left.AtLeast + left.Slope * step;
        return new Moment(left.Fraction + step, bound, double.PositiveInfinity, Level(left, right), 0);
    }

    /// <summary>The mean of two normals along which the motion leads nowhere.</summary>
    private static Double3 Level(in Moment left, in Moment right)
    {
        Double3 sum = left.Normal * right.Slope - right.Normal * left.Slope;
        double length = sum.Length;
        return length > 0 ? sum * (1 / length) : left.Normal;
    }

    private Double3 Centers(double fraction) => _pair.Centers + Motion * fraction;

    private double Gap(in Double3 normal, in Double3 centers) =>
        Double3.Dot(normal, centers) - _pair.BodyA.Height(normal) - _pair.BodyB.Height(-normal);

    /// <summary>The furthest point of A - B in a direction of the world, seen from B's centre.</summary>
    private ExactGuess.Corner Difference(in Double3 direction, in Double3 centers)
    {
        PosedShape a = _pair.BodyA, b = _pair.BodyB;
        _pair.A.Support(a.InverseRotate(direction), out Double3 onA);
        _pair.B.Support(b.InverseRotate(-direction), out Double3 onB);
        return new ExactGuess.Corner(
            -1, -1,
            a.Rotate(_pair.A.Center - a.Center + onA) - b.Rotate(_pair.B.Center - b.Center + onB) - centers);
    }
}

/// <summary>What is certain about the distance of moving shapes at a fraction.</summary>
/// <param name="Fraction">When.</param>
/// <param name="AtLeast">A plane leaves so much between them; negative where none was found.</param>
/// <param name="AtMost">Two points of them are no further apart; less where they touch.</param>
/// <param name="Normal">Of the plane, from A to B; zero where there is none.</param>
/// <param name="Slope">By how much the plane's gap grows over the fraction 1; NaN where there is none.</param>
internal readonly record struct Moment(double Fraction, double AtLeast, double AtMost, Double3 Normal, double Slope)
{
    /// <summary>False where the shapes, or their cores, are too near each other for a plane between them.</summary>
    public bool HasPlane => !double.IsNaN(Slope);
}
