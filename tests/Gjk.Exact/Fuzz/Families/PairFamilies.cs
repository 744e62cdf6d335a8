namespace Gjk.Exact.Fuzz.Families;

/// <summary>All families, and the draw between them. What a pair is does not depend on how it moves.</summary>
internal static class PairFamilies
{
    private static readonly PairFamily[] All =
    [
        new("anything", 8, r => Placement.Near(r, Shapes.Any(r), Shapes.Any(r))),
        new("polytopes", 8, r => Placement.Near(r, Shapes.Polytope(r), Shapes.Polytope(r))),
        new("curved", 4, r => Placement.Near(r, Shapes.Curved(r), Shapes.Any(r))),
        new("scaled", 4, r => Placement.Near(r, Shapes.Scaled(r), Shapes.Polytope(r))),
        new("flat", 6, r => Placement.Near(r, Shapes.Degenerate(r), Shapes.Degenerate(r))),
        new("needles", 6, r => Placement.Near(r, Shapes.Needle(r), r.OneIn(2) ? Shapes.Needle(r) : Shapes.Polytope(r))),
        new("lattice", 6, ContactFamilies.Lattice),
        new("parallel faces", 8, ContactFamilies.ParallelFaces),
        new("touching", 8, ContactFamilies.Touching),
        new("touching at the origin", 10, ContactFamilies.AtTheOrigin),
        new("nearly the same", 6, ContactFamilies.NearlyTheSame),
        new("concentric", 4, ContactFamilies.Concentric),
        new("sizes apart", 6, SizeFamilies.SizesApart),
        new("tiny and huge", 6, SizeFamilies.TinyAndHuge),
        new("far away", 6, SizeFamilies.FarAway),
        new("offset meshes", 6, SizeFamilies.OffsetMeshes),
        new("large hulls", 1, SizeFamilies.LargeHulls),
        new("made meshes", 8, MadeFamilies.Near),
        new("made meshes, a gap apart", 8, MadeFamilies.Apart),
        new("made meshes off their origin", 6, MadeFamilies.OffsetMeshes),
        new("uneven scales", 8, MadeFamilies.Uneven),
        new("resting", 8, RestFamilies.Resting),
        new("curved on a lattice", 4, RestFamilies.CurvedLattice),
        new("at the threshold", 8, RestFamilies.AtTheThreshold),
        new("thin gaps", 8, RestFamilies.ThinGaps),
        new("the whole range", 4, RangeFamilies.WholeRange),
        new("ratios", 4, RangeFamilies.Ratios),
        new("distances", 4, RangeFamilies.Distances),
        new("tapered capsules", 4, r => Placement.Near(
            r, Shapes.Tapered(r), r.OneIn(2) ? Shapes.Tapered(r) : Shapes.Any(r))),
    ];

    private static readonly int Weights = All.Sum(f => f.Weight);

    public static IReadOnlyList<string> Names { get; } = [.. All.Select(f => f.Name)];

    /// <summary>The pair of a seed and a number, with its family's name.</summary>
    public static FuzzPair Draw(ulong seed, long index, out string family)
    {
        Rng random = Rng.ForPair(seed, index);
        int left = random.Below(Weights), i = 0;
        while (left >= All[i].Weight) left -= All[i++].Weight;
        family = All[i].Name;
        FuzzPair atRest = All[i].Make(random);
        return atRest.Moving(Motions.Draw(random, atRest));
    }
}
