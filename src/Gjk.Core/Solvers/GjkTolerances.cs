namespace Gjk.Core;

/// <summary>The solvers' tolerances. Lengths are fractions of the pair's size (<see cref="PairSize"/>, at most 1.74
/// times the scale that the promises are measured by), ratios are fractions of the distance. Each is a small multiple
/// of what rounding in double does to the quantity that it guards.</summary>
internal static class GjkTolerances
{
    /// <summary>Ratio: the gap between the feature and the newest support plane is closed when it is this fraction of
    /// the distance. Far below float's 6e-8, a few dozen units in the last place above what a double sum of three
    /// products loses. Larger, it would spend the room that float's rounding leaves; smaller, it would hand over more
    /// often. Pinned by ToleranceTests.ARelativeGapIsClosed.</summary>
    public const double RelativeGap = 256 * RoundOff.Unit;

    /// <summary>Ratio, for cores without vertices: a curved support never repeats, so the gap shrinks for ever. The
    /// error that it leaves is a sixtieth of float's rounding. Pinned by ToleranceTests.ARelativeGapIsClosed.</summary>
    public const double RelativeGapCurved = 1e-9;

    /// <summary>Length: what rounding usually does to the difference of two support values, 4 roundings of the pair's
    /// size. A gap below it cannot be told from 0; it is within the promise whatever rounding does (proofs/noise.g).
    /// Pinned by ToleranceTests.AGapBelowTheNoiseIsClosed.</summary>
    public const double Noise = 4 * RoundOff.Unit;

    /// <summary>Length, for cores without vertices; the promise for these is 1e-6. Pinned by
    /// ToleranceTests.AGapBelowTheNoiseIsClosed.</summary>
    public const double NoiseCurved = 1e-10;

    /// <summary>Length: how far the corners of a nearest triangle may be from level. Between Noise, which well-shaped
    /// triangles keep, and the promised 1e-14 of the scale; what is above goes to extended precision (proofs/level.g).
    /// Pinned by ToleranceTests.ATriangleIsLevelToSixteenRoundings.</summary>
    public const double Level = 4 * Noise;

    /// <summary>Length: shapes nearer than this touch. Four times the noise, so that a distance that the gap test ended
    /// cannot fall on the other side than an enclosed origin does; below the promised 1e-14 of the scale. Pinned by
    /// ToleranceTests.ADistanceBelowTheTouchToleranceIsContact.</summary>
    public const double Touch = 4 * Noise;

    /// <summary>Length, for cores without vertices: four times the noise, as above. Cold, warm and boolean queries end
    /// at different points within the noise, and a resting pair in exact contact must touch in all of them. Pinned by
    /// ToleranceTests.ADistanceBelowTheTouchToleranceIsContact.</summary>
    public const double TouchCurved = 4 * NoiseCurved;

    /// <summary>Length: the boolean solver calls shapes apart only when a plane proves a gap of this much, so that the
    /// distance solver must agree (proofs/separated-band.g); below, it asks it. Pinned by
    /// ToleranceTests.AGapBeyondTheBandIsApart.</summary>
    public const double SeparatedBand = 16 * Touch;

    /// <summary>Length: the same where a core has no vertices, and in the limit at which a query with a largest
    /// distance may end early. Pinned by ToleranceTests.AGapBeyondTheBandIsApart.</summary>
    public const double SeparatedBandCurved = 4 * TouchCurved;

    /// <summary>Length: what rounding can do to a lower bound: to the relative pose, to the choice of the supports and
    /// to their values: 10 roundings of (size + distance of the centres), twice the most that a search for the worst
    /// pose finds. The sum of all worst cases is more (proofs/README.md), but would not fit into the promised 1e-14 of
    /// the scale. Pinned by LowerBoundErrorTests and ToleranceTests.ALowerBoundLosesTwentyRoundingsOfTheSize.</summary>
    public const double LowerBoundError = 10 * RoundOff.Unit;

    /// <summary>Ratio to |e|·|f|·|g| for a determinant of three vectors: 16 roundings, twice what the textbook bound
    /// for a 3 by 3 determinant of rounded differences asks (proofs/determinant.g). Below it a sign is not certain and
    /// extended precision decides. Pinned by ToleranceTests.AFaceIsCertainlyPassedBySixteenRoundings.</summary>
    public const double DeterminantError = 16 * RoundOff.Unit;

    /// <summary>Length, as a fraction of size and distance: how far from a feature the foot of the origin on its plane
    /// may be. Half of what points are promised; less would only ask extended precision more often. Pinned by
    /// NeedlePointTests.</summary>
    public const double Beside = 1.0 / (1 << 24);

    /// <summary>Length: how far two answers of one support function may disagree before the shape counts as
    /// contradicting itself: room for a support that computes in float (6e-8 a rounding) on vertices a hundred radii
    /// off. Pinned by ToleranceTests.ASupportThatIsFurtherBehindContradictsItself.</summary>
    public const double Contradiction = 1e-5;

    /// <summary>Ratio: more than a rounding to float can take away (2^-24), so that a distance beyond it rounds to a
    /// larger float (proofs/float-band.g). Pinned by
    /// ToleranceTests.ALargestDistanceIsWidenedByFourRoundingsToFloat.</summary>
    public const double FloatBand = 4.0 / (1 << 24);

    /// <summary>A backstop that no valid shape reaches: hulls of 4096 vertices need about 30, curved shapes about 60.
    /// Pinned by ToleranceTests.AWalkThatDoesNotEndIsEnded.</summary>
    public const int MaxIterations = 256;

    /// <summary>Length: how far the corners of a face of the polytope may be from level before its normal is computed
    /// in extended precision: twice the noise, what a well-shaped face keeps. Pinned by HardDepthTests.</summary>
    public const double DepthLevel = 2 * Noise;

    /// <summary>Length: two bounds of the depth that are no further apart have met. Twice the level, so that a face's
    /// own corners never count as above it; below the promised 1e-14 of the scale (proofs/depth-noise.g). Pinned by
    /// DepthToleranceTests.</summary>
    public const double DepthNoise = 2 * DepthLevel;

    /// <summary>Ratio to the depth: bounds that are no further apart have met where a vertex repeats itself; half of
    /// float's rounding, which is half of the promise. Pinned by NearCopyDepthTests.</summary>
    public const double RepeatedGap = 1.0 / (1 << 24);

    /// <summary>Length, for cores without vertices: two bounds of the depth that are no further apart have met. The
    /// promise for these is 1e-6. Pinned by DepthToleranceTests.</summary>
    public const double DepthNoiseCurved = 2e-7;

    /// <summary>Length, for cores without vertices: two bounds of the depth that leave its direction open by their
    /// root, 2e-7 rad for a curve of the size; 180 roundings. Pinned by DepthToleranceTests.</summary>
    public const double NormalNoise = 2e-14;

    /// <summary>Length, for cores without vertices: the depth's bounds where the search has to divide its surface into
    /// cells. The supports that it takes grow with
    /// one over this, or with its root; nine tenths of the promise, whose scale is this one's size over 1.74. A quarter
    /// of it only takes more of them. Pinned by HullDepthTests.</summary>
    public const double DepthCellNoiseCurved = 5e-7;

    /// <summary>Length: a Minkowski difference that is thinner has no inside; eight times the level that its faces are
    /// kept to. A depth of half of it is below the promised 1e-14 of the scale (proofs/flat.g). Pinned by
    /// DepthToleranceTests.AThinDifferenceHasNoInside.</summary>
    public const double Flat = 8 * DepthLevel;

    /// <summary>The separated band of a pair.</summary>
    public static double SeparatedBandOf(bool curved) => curved ? SeparatedBandCurved : SeparatedBand;

    /// <summary>The touch tolerance of a pair.</summary>
    public static double TouchOf(bool curved) => curved ? TouchCurved : Touch;
}
