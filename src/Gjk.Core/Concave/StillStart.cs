namespace Gjk.Core;

/// <summary>The contact of bodies that do not move: parts that share no point at the start never meet.</summary>
internal static class StillStart
{
    /// <summary>Asks the parts that touch for the search that the scratch holds.</summary>
    public static void Run(ConcaveScratch scratch)
    {
        PartPairSearch.Collect(scratch, 0, scratch.Pairs);
        foreach (PairDistance pair in scratch.Pairs)
            scratch.CastSearch.Ask(scratch, Math.Max(pair.PartA, 0), Math.Max(pair.PartB, 0));
    }
}
