namespace Gjk.Exact.Fuzz.Promises;

/// <summary>
/// A hit is a contact, with a proof that there is none before; of a miss, planes prove that there is none at all.
/// </summary>
internal sealed class TheCastIsTheFirstTouch : IPromise
{
    public string Name => "a cast finds the first touch";

    public string? Broken(FuzzPair pair) => CastProof.Problem(pair, pair.Cast, 1);
}
