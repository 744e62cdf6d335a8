namespace Gjk.Core;

/// <summary>
/// Is shown the pairs that a scene finds, in order. Implement it with a struct: it is called without boxing.
/// </summary>
public interface IPairVisitor
{
    /// <summary>One pair, A less than B. The scene must not be used before the last visit has returned.</summary>
    void Visit(ObjectPair pair);
}

/// <summary>
/// Is shown the pairs that a scene finds with their distances, in order. Implement it with a struct: it is called
/// without boxing.
/// </summary>
public interface IPairDistanceVisitor
{
    /// <summary>
    /// One pair, A less than B, with its distance. The scene must not be used before the last visit has returned.
    /// </summary>
    void Visit(in PairDistance pair);
}

/// <summary>
/// Is shown the pairs that a scene finds with their contact points, in order. Implement it with a struct: it is called
/// without boxing.
/// </summary>
public interface IPairContactsVisitor
{
    /// <summary>
    /// One pair, A less than B, with its signed distance and its points. The scene must not be used before the last
    /// visit has returned.
    /// </summary>
    void Visit(in PairContacts pair);
}
