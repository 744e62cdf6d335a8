namespace Gjk.Core.Diagnostics;

/// <summary>Looks for the two witnesses of a signed distance: a direction across which planes stand far apart, and two
/// points that are near each other.</summary>
/// <remarks>
/// <para>Gilbert's iteration in its plainest form ("An iterative procedure for computing the minimum of a quadratic
/// form on a convex set", 1966): the support across the nearest mean so far makes the next means
/// (<see cref="WitnessMean"/>). Begun at the normal of a right answer it takes a few supports. It has none of the
/// solvers' tolerances, features and handovers, since nothing rests on how it ends.</para>
/// <para>Each bound is true when it is written: the lower one is the gap across some direction, the upper one the
/// distance of two weighted means of supports, and both give way by the noise of the pair. A poor search leaves them
/// apart, and what was asked stays open.</para>
/// <para>It ends where the bounds decide what was asked, where neither of two directions finds a nearer mean, and after
/// MostSupports at the latest. NaN and infinity end it with the bounds at hand.</para>
/// </remarks>
internal struct WitnessWalk
{
    /// <summary>Count: curved shapes that nearly touch take some thirty. A larger one is only slower; a quarter of it
    /// leaves more answers open. Pinned by AnswerCheckTests.</summary>
    private const int MostSupports = 64;

    /// <summary>The signed distance is not below.</summary>
    public double Lower;

    /// <summary>Of unit length: the planes across it show that.</summary>
    public Double3 Across;

    /// <summary>The signed distance is not above.</summary>
    public double Upper;

    /// <summary>The gap between the planes across the hint, as it is, without the noise; NaN where the hint is no
    /// direction.</summary>
    public double HintGap;

    /// <summary>Looks for witnesses until they decide whether the signed distance is between two numbers.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="pair">Where they are.</param>
    /// <param name="hint">Where to look first, from A to B; any vector.</param>
    /// <param name="least">What is asked: whether the signed distance is not below.</param>
    /// <param name="most">And whether it is not above.</param>
    public static WitnessWalk Of<TA, TB>(
        ref TA a, ref TB b, in PosedPair pair, in Double3 hint, double least, double most)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        WitnessWalk walk = default;
        (walk.Lower, walk.Upper) = (double.NegativeInfinity, double.PositiveInfinity);
        walk.HintGap = double.NaN;
        if (!pair.IsValid) return walk;
        WitnessMean mean = default;
        bool isHint = hint.LengthSquared > 0, isAcross = true;
        Double3 direction = isHint ? hint : pair.Between.LengthSquared > 0 ? pair.Between : new Double3(1, 0, 0);
        for (int i = 0; i < MostSupports && PosedPair.TryUnit(direction, out Double3 unit); i++)
        {
            double gap = pair.Gap(ref a, ref b, unit, out Double3 vertex);
            if (i == 0 && isHint) walk.HintGap = gap;
            if (gap - pair.Noise > walk.Lower) (walk.Lower, walk.Across) = (gap - pair.Noise, unit);
            bool isNearer = mean.TryAdd(vertex);
            if (isNearer) walk.Upper = mean.Length + pair.Noise - pair.Margins;
            if (walk.IsWithin(least, most) || walk.IsBeyond(least, most) || mean.Length <= pair.Noise) break;

            // Across a needle the mean's own direction may be the better one.
            if (!isNearer && (!isAcross || mean.Count == 1)) break;
            isAcross = isNearer;
            direction = isAcross ? mean.Across() : mean.Value;
        }

        return walk;
    }

    /// <summary>Whether the signed distance is certainly between two numbers.</summary>
    public readonly bool IsWithin(double least, double most) => Lower >= least && Upper <= most;

    /// <summary>Whether it is certainly below the one or above the other.</summary>
    public readonly bool IsBeyond(double least, double most) => Lower > most || Upper < least;
}
