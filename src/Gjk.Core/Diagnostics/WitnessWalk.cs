namespace Gjk.Core;

/// <summary>
/// Looks for the two witnesses of a signed distance: a direction across which planes stand far apart, and points that
/// are near each other. Both bounds are true whatever the search does; a poor search only leaves them apart.
/// </summary>
/// <remarks>
/// Gilbert's iteration in its plainest form ("An iterative procedure for computing the minimum of a quadratic form on a
/// convex set", 1966): the support across the nearest mean so far makes the next means (<see cref="WitnessMean"/>).
/// It has none of the solvers' tolerances and proofs, since nothing rests on how it ends. From a right answer's normal
/// it takes a few supports.
/// </remarks>
internal struct WitnessWalk
{
    /// <summary>
    /// Count: curved shapes that nearly touch take some thirty; a larger one is only slower, a smaller one leaves more
    /// answers open.
    /// </summary>
    private const int MostSupports = 64;

    /// <summary>The signed distance is not below.</summary>
    public double Lower;

    /// <summary>The signed distance is not above.</summary>
    public double Upper;

    /// <summary>The gap between the planes across the hint, not rounded in any direction; NaN where it is none.</summary>
    public double HintGap;

    /// <summary>Looks for witnesses until they prove or refute that the signed distance is between two numbers.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="pair">Where they are.</param>
    /// <param name="hint">Where to look first, from A to B; any vector.</param>
    /// <param name="least">What is claimed: the signed distance is not below.</param>
    /// <param name="most">And not above.</param>
    public static WitnessWalk Of<TA, TB>(
        ref TA a, ref TB b, in PosedPair pair, in Vector3D hint, double least, double most)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        WitnessWalk walk;
        walk.Lower = double.NegativeInfinity;
        walk.Upper = double.PositiveInfinity;
        walk.HintGap = double.NaN;
        if (!pair.IsValid) return walk;
        WitnessMean mean = default;
        Vector3D direction = hint.LengthSquared > 0 ? hint
            : pair.Between.LengthSquared > 0 ? pair.Between : new Vector3D(1, 0, 0);
        bool isAcross = true;
        for (int i = 0; i < MostSupports && PosedPair.TryUnit(direction, out Vector3D unit); i++)
        {
            double gap = pair.Gap(ref a, ref b, unit, out Vector3D vertex);
            if (i == 0 && hint.LengthSquared > 0) walk.HintGap = gap;
            if (gap - pair.Noise > walk.Lower) walk.Lower = gap - pair.Noise;
            if (mean.TryAdd(vertex))
            {
                walk.Upper = mean.Length + pair.Noise - pair.Margins;
                isAcross = true;
            }
            else if (isAcross && mean.Count > 1)
            {
                // Across a needle the mean's own direction may be the better one.
                isAcross = false;
            }
            else
            {
                break;
            }

            if (walk.IsWithin(least, most) || walk.IsBeyond(least, most) || mean.Length <= pair.Noise) break;
            direction = isAcross ? mean.Across() : mean.Value;
        }

        return walk;
    }

    /// <summary>Whether the signed distance is certainly between two numbers.</summary>
    public readonly bool IsWithin(double least, double most) => Lower >= least && Upper <= most;

    /// <summary>Whether it is certainly below the one or above the other.</summary>
    public readonly bool IsBeyond(double least, double most) => Lower > most || Upper < least;
}
