using Gjk.Core;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>
/// A query depends on its arguments alone: asked again it gives the same bits, and so does the overload with the final
/// simplex, whose weights are those of points.
/// </summary>
internal sealed class TheSameBitsAgain : IPromise
{
    /// <summary>A pure number: the roundings of four weights.</summary>
    private const double WeightSum = 1e-12;

    public string Name => "the same query gives the same bits";

    public string? Broken(FuzzPair pair)
    {
        DistanceResult again = ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB);
        DistanceResult whole = ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, out FinalSimplex simplex);
        return Same.BitProblem(pair.Answer, again, "asked again")
            ?? Same.BitProblem(pair.Answer, whole, "with the simplex")
            ?? Weights(simplex);
    }

    private static string? Weights(in FinalSimplex simplex)
    {
        double sum = 0, least = 1;
        for (int i = 0; i < simplex.Count; i++)
        {
            double weight = simplex.Weight(i);
            sum += weight;
            least = System.Math.Min(least, weight);
        }

        return simplex.Count >= 1 && System.Math.Abs(sum - 1) <= WeightSum && least >= 0
            ? null
            : Say.Line($"{simplex.Count} weights, the least {least}, the sum {sum}");
    }
}
