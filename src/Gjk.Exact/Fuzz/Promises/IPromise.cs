namespace Gjk.Exact.Fuzz.Promises;

/// <summary>One thing that a user of the library relies on, checked for one pair.</summary>
internal interface IPromise
{
    /// <summary>The promise in a few words.</summary>
    string Name { get; }

    /// <summary>How the pair breaks it, in one line; null when it holds.</summary>
    string? Broken(FuzzPair pair);
}
