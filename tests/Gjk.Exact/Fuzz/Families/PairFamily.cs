namespace Gjk.Exact.Fuzz.Families;

/// <summary>One kind of pairs that is hard in its own way.</summary>
/// <param name="Name">In a word or two.</param>
/// <param name="Weight">How often it is drawn, beside the others' weights.</param>
/// <param name="Make">Draws one.</param>
internal sealed record PairFamily(string Name, int Weight, Func<Rng, FuzzPair> Make);
